# What the command line says.

## Help
a-machine-dynamics-workbench-pick-a-problem-edit-its-inputs-in-any-units-see-the-worked-solution = Uma bancada de dinâmica das máquinas: escolha um problema, edite os dados em quaisquer unidades, veja a solução resolvida passo a passo
a-problem-file-or-the-id-of-an-analysis-to-open-in-the-workbench = Um arquivo de problema ou o id de uma análise, para abrir na bancada
change-an-input-mass-40-kg-masses-2-radius-0-1-m-a-table-can-be-read-from-a-file-samples-data-csv = Mudar um dado: mass="40 kg", masses[2].radius="0.1 m"; uma tabela pode ser lida de um arquivo: samples=@data.csv
hold-every-published-answer-against-ours = Comparar cada resposta publicada com a nossa
list-the-analyses = Listar as análises
open-the-file-without-a-way-to-save-over-it = Abrir o arquivo sem poder gravar sobre ele
play-a-recorded-or-written-session-of-the-workbench = Reproduzir uma sessão gravada ou escrita da bancada
play-at-once-without-a-terminal-and-print-the-screens-that-the-session-marks-or-the-last-one = Reproduzir de uma vez, sem terminal, e imprimir as telas que a sessão marca, ou a última
so-many-times-as-fast-as-a-person-types = Tantas vezes mais rápido do que uma pessoa digita
the-session-as-record-writes-it = A sessão, como --record a escreve
write-the-marked-screens-to-this-folder-as-svg-instead-of-printing-them = Gravar as telas marcadas nesta pasta como SVG, em vez de imprimi-las
write-what-is-done-in-the-workbench-to-a-new-file-for-dalembert-replay = Gravar o que se faz na bancada em um arquivo novo, para `dalembert replay`
there-is-no-terminal-to-play-in-write-headless = não há terminal em que reproduzir; escreva --headless
the-session-marks-no-picture-write-picture-name-in-it = a sessão não marca nenhuma figura; escreva `picture NAME` nela
print-a-script-that-completes-the-arguments-in-a-shell = Imprimir um script que completa os argumentos em um shell
print-ascii-characters-alone = Imprimir só caracteres ASCII
print-json = Imprimir JSON
print-the-json-schema-of-a-problem-file-for-an-editor = Imprimir o JSON Schema de um arquivo de problema, para um editor
print-the-manual-page = Imprimir a página de manual
show-an-answer-in-this-unit-amplitude-um = Mostrar uma resposta nesta unidade: amplitude=um
show-so-many-significant-digits = Mostrar tantos algarismos significativos
show-what-an-analysis-asks-for-and-answers = Mostrar o que uma análise pede e responde
solve-a-problem-and-print-its-worked-solution = Resolver um problema e imprimir a solução passo a passo
the-id-of-an-analysis-or-a-problem-file = O id de uma análise, ou um arquivo de problema
the-id-of-an-analysis-such-as-vibration-rotating-unbalance = O id de uma análise, como vibration/rotating-unbalance
the-language-of-everything-that-is-printed = A língua de tudo o que é impresso
the-shell = O shell
the-subcommand-without-it-the-whole-program = O subcomando; sem ele, o programa inteiro
the-table-to-print-as-csv-answers-inputs-steps-checks-table-1-plot-1 = A tabela a imprimir como CSV: answers, inputs, steps, checks, table-1, plot-1
what-is-printed-without-it-what-the-ending-of-the-file-asks-for-else-text = O que é impresso; sem isto, o que a extensão do arquivo pede, senão texto
without-arguments-the-workbench-in-a-terminal-a-worked-problem-elsewhere-exit-status-0-solved-1 = Sem argumentos: a bancada em um terminal, um problema resolvido fora dele. Código de saída: 0 resolvido; 1 recusado, ou uma verificação falhou; 2 entrada ou uso errado.
words-that-the-id-the-title-the-summary-or-the-keywords-contain = Palavras contidas no id, no título, no resumo ou nas palavras-chave

## Descriptions of analyses
a-whole-number-from-min = um número inteiro a partir de { $min }
a-whole-number-from-min-to-max = um número inteiro de { $min } a { $max }
above-limit = acima de { $limit }
at-least-limit = no mínimo { $limit }
at-most-limit = no máximo { $limit }
below-limit = abaixo de { $limit }
cases = Casos
closed-form = forma fechada
inputs = Dados de entrada
len-components-what = { $len } componentes, { $what }
one-of = uma de
or-nothing = ou nada
other-program = outro programa
otherwise-default = senão { $default }
own-earlier-value = valor próprio anterior
published = publicado
the-name-of-one-of-list = o nome de um de { $list }
as-in-field = como em { $field }
these = estes
words = palavras
yes-or-no = sim ou não

## Verdicts
agreed = confere
agreed-agreed-disputed-disputed-differing-differing = { $agreed } conferem, { $disputed } contestadas, { $differing } divergem
differing = diverge
disputed = contestada
printed-printed-ours-ours = impresso { $printed }, nosso { $ours }

## Information
analyses = análises
both-ends-are-a-terminal = as duas pontas são um terminal
braille = braille
characters = caracteres
colours = cores
curves-are-drawn-with = as curvas são traçadas com
dots = pontos
half-blocks = meios blocos
language = língua
none = nenhuma
number-of-published-cases = número de casos publicados
terminal = Terminal
unsaved-work-is-kept-in = o trabalho não gravado fica em
version = versão
width = largura

## Errors
a-problem-file-has-no-cases-leave-out-case = um arquivo de problema não tem casos; retire --case
what-the-workbench-is-to-do-and-a-subcommand-cannot-stand-together-write-one-of-them = o que a bancada deve fazer e um subcomando não podem vir juntos; escreva um deles
and-more-more-errors = e mais { $more } erros
error = erro
error-why = erro: { $why }
id-has-no-case-number-it-has-cases-1-to-have = { $id } não tem o caso { $number }; tem os casos 1 a { $have }
no-analysis-matches-filter-dalembert-list-shows-them-all = nenhuma análise corresponde a { $filter }; `dalembert list` mostra todas
no-answer-why = sem resposta: { $why }
path-value-why = { $path } = { $value }: { $why }
set-change-write-a-path-and-a-value-as-in-set-mass-40-kg = --set { $change }: escreva um caminho e um valor, como em --set mass="40 kg"
set-path-why = --set { $path }: { $why }
there-is-no-subcommand-name-did-you-mean-near = não há subcomando `{ $name }`; seria `{ $near }`?
there-is-no-subcommand-name-see-dalembert-help = não há subcomando `{ $name }`; veja `dalembert --help`
there-is-no-table-table-write-one-of-known = não há tabela `{ $table }`; escreva uma de { $known }
this-is-a-fault-of-the-program-not-of-your-input-what = isto é uma falha do programa, não da sua entrada: { $what }
unit-asked-write-an-answer-and-a-unit-as-in-unit-amplitude-um = --unit { $asked }: escreva uma resposta e uma unidade, como em --unit amplitude=um

## Settings
for-serial-lines-and-screen-readers-ascii-no-colours-no-frames-no-mouse-films-held = Para linhas seriais e leitores de tela: ASCII, sem cores, sem molduras, sem mouse, filmes parados
leave-the-mouse-to-the-terminal = Deixar o mouse com o terminal
print-a-file-of-settings-that-says-what-can-be-set-to-begin-one-s-own-with = Imprimir um arquivo de configuração que diz o que se pode configurar, para começar o seu
show-the-version-the-files-and-folders-and-what-the-terminal-can-do = Mostrar a versão, os arquivos e pastas e o que o terminal pode
files-and-folders = Arquivos e pastas
settings = configuração
is-there = existe
is-not-there = não existe
own-lists-of-exercises = listas de exercícios próprias
what-is-remembered = o que é lembrado
not-taken-of-the-settings = não aceito da configuração
not-taken-of-the-exercises = não aceito dos exercícios
file-exists-already-and-no-session-is-recorded-over-it-write-another-name-or-remove-it = { $file } já existe, e nenhuma sessão é gravada por cima: escreva outro nome, ou remova-o
file-cannot-be-recorded-there-is-no-such-folder = { $file } não pode ser gravado: não há essa pasta
a-table-as-lines-of-numbers-under-the-heading-heading-with-the-columns = uma tabela, como linhas de números sob o cabeçalho "{ $heading }", com as colunas
begin-with-the-inputs-of-this-published-case-counted-from-1-without-it-set-begins-with-empty-inputs = Começar com os dados deste caso publicado, contado a partir de 1; sem isso, --set começa com dados vazios, e um id sozinho resolve o caso 1
write-to-a-new-file-markdown-and-typst-write-their-figures-beside-it = Gravar em um arquivo novo; Markdown e Typst gravam as figuras ao lado dele
write-over-files-that-are-there-never-over-a-problem-file = Gravar por cima de arquivos que existem; nunca de um arquivo de problema
refuse-a-number-without-a-unit-where-one-is-needed-instead-of-saying-in-which-unit-it-is-taken = Recusar um número sem unidade onde é preciso uma, em vez de dizer em que unidade ele é tomado
note-words = nota: { $words }
warning-words = aviso: { $words }
file-is-the-problem-itself-write-its-solution-to-another-file = { $file } é o próprio problema: grave a solução em outro arquivo
file-is-a-problem-file-write-the-solution-to-another-file = { $file } é um arquivo de problema: grave a solução em outro arquivo
file-exists-already-write-another-name-or-force-to-write-over-it = { $file } já existe: escreva outro nome, ou --force para gravar por cima
an-input-that-is-not-set-is-not-filled-in-case-1-begins-with-those-of-the-first-published-case = um dado que não é informado não é preenchido; --case 1 começa com os do primeiro caso publicado
rows-at-most-most = linhas, no máximo { $most }
rows-min-to-most = linhas, de { $min } a { $most }
check-failed-what-the-two-ways-differ-by-residual-of-their-size-and-limit-is-allowed = verificação que não confere: { $what }: os dois caminhos diferem de { $residual } do seu tamanho, e se admite { $limit }
fault-of-the-program-what = defeito do programa: { $what }
seen-in-print = visto impresso
seen-in-a-companion-s-output = visto na saída de um programa que acompanha o livro
seen-on-a-page-that-quotes-it = visto em uma página que o cita
recalled = lembrado
refusal = recusa

## Coverage of answers by checks
answers-answers-covered-covered-forms-other-forms-of-covered-ones-inputs-inputs-explained-uncovered = { $answers } respostas: { $covered } cobertas, { $forms } outras formas de cobertas, { $inputs } dados, { $explained } descobertas com motivo, { $unexplained } descobertas sem motivo
a-reason-is-given-but-it-is-covered = um motivo é dado, mas ela está coberta
no-reason-given = nenhum motivo dado
an-answer-is-covered-when-a-check-of-one-of-its-cases-fails-once-it-is-wrong-by-one-part-in-a-million = Uma resposta está coberta quando uma verificação de um de seus casos falha assim que ela erra em uma parte em um milhão.
list-the-answers-that-no-check-covers-each-with-the-reason = Listar as respostas que nenhuma verificação cobre, cada uma com o motivo
