## Studies in files
line-line-cell-is-not-a-number = linha { $line }: `{ $cell }` não é um número
shards-are-missing-missing-run-each-with-shard-as-in-shard-first = faltam partes: { $missing }; execute cada uma com --shard, como em --shard { $first }
file-is-being-written-by-another-process-wait-for-it-or-stop-it = { $file } está sendo escrito por outro processo; espere-o ou interrompa-o
file-is-of-another-plan-problem-or-version-of-the-program-delete-it-or-choose-another-name = { $file } é de outro plano, problema ou versão do programa; apague-o ou escolha outro nome
there-are-no-shards-of-file-run-them-with-shard-as-in-shard-1-4 = não há partes de { $file }; execute-as com --shard, como em --shard 1/4
beside-file-there-are-shards-of-numbers-keep-those-of-one-number = ao lado de { $file } há partes de { $numbers }; conserve as de um só número

## Slurm
squeue-does-not-answer-job-job-may-still-run-start-the-same-command-again-later = squeue não responde; o job { $job } talvez ainda esteja em execução: repita o mesmo comando mais tarde
shards-were-lost-times-times-missing-see-log = partes perdidas { $times } vezes: { $missing }; veja { $log }
sbatch-why-run-this-on-a-machine-of-the-cluster = sbatch: { $why }; execute isto em uma máquina do cluster
sbatch-refuses-the-job-why = sbatch recusa o job: { $why }

## Points of arrays

## Planos em arquivos
this-is-a-problem-file-not-a-study-plan-which-names-its-problem-problem-fan-toml = este é um arquivo de problema, não um plano de estudo, que nomeia o seu problema: problem = "fan.toml"
line-line-why = linha { $line }: { $why }

## Values of an input within a limit
the-answers-of-the-scan-are-not-those-of-the-formulas-at-the-compared-points = os resultados da varredura não são os das fórmulas nos pontos comparados
the-worked-solution-has-no-answer-where-the-plain-reading-has-one = a resolução passo a passo não tem resultado onde a leitura simples tem um
the-answer-is-not-computed-by-formulas-alone = o resultado não é calculado só por fórmulas
the-formulas-of-the-answer-are-too-long-to-be-enclosed = as fórmulas do resultado são longas demais para a aritmética intervalar
the-enclosure-of-the-formulas-is-not-that-of-the-answer = o intervalo das fórmulas não contém o resultado
a-number-in-the-formulas-changes-with-the-input-a-numerical-method-found-it-or-code-outside-of-the = um número nas fórmulas muda com o dado: foi achado por um método numérico, ou por código fora das fórmulas
the-formulas-of-the-answer-change-too-often-over-the-range = as fórmulas do resultado mudam vezes demais na faixa
