## Studies in files
file-why = { $file }: { $why }
line-line-cell-is-not-a-number = linha { $line }: `{ $cell }` não é um número
shards-are-missing-missing-run-each-with-shard-as-in-shard-first = faltam partes: { $missing }; execute cada uma com --shard, como em --shard { $first }
file-is-being-written-by-another-process-wait-for-it-or-stop-it = { $file } está sendo escrito por outro processo; espere-o ou interrompa-o
file-is-of-another-plan-problem-or-version-of-the-program-delete-it-or-choose-another-name = { $file } é de outro plano, problema ou versão do programa; apague-o ou escolha outro nome
there-are-no-shards-of-file-run-them-with-shard-as-in-shard-1-4 = não há partes de { $file }; execute-as com --shard, como em --shard 1/4
beside-file-there-are-shards-of-numbers-keep-those-of-one-number = ao lado de { $file } há partes de { $numbers }; conserve as de um só número
