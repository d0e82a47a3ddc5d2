# What the command line says.

## Help
a-machine-dynamics-workbench-pick-a-problem-edit-its-inputs-in-any-units-see-the-worked-solution = Uma bancada de dinâmica das máquinas: escolha um problema, edite os dados em quaisquer unidades, veja a resolução passo a passo
a-problem-file-or-the-id-of-an-analysis-to-open-in-the-workbench = Um arquivo de problema ou o id de uma análise, para abrir na bancada
change-an-input-mass-40-kg-masses-2-radius-0-1-m-a-table-can-be-read-from-a-file-samples-data-csv = Mudar um dado: mass="40 kg", masses[2].radius="0.1 m"; uma tabela pode ser lida de um arquivo: samples=@data.csv
parts-of-the-worked-solution-default-full = Partes da solução; padrão: full
parts-chooses-what-a-text-or-a-note-has-json-and-csv-have-all-of-it-leave-out-parts = --parts escolhe o que um texto ou um memorial tem; JSON e CSV têm tudo: retire --parts
check-all-published-answers = Verificar todos os resultados publicados
list-the-analyses = Listar as análises
open-the-file-read-only = Abrir o arquivo só para leitura
replay-a-recorded-or-written-session-of-the-workbench = Reproduzir uma sessão gravada ou escrita da bancada
watch-a-tour-of-90-seconds-in-the-workbench-any-key-takes-over = Assistir a uma visita de 90 segundos na bancada; qualquer tecla assume
the-tour-needs-a-terminal-dalembert-list-lists-the-analyses = a visita precisa de um terminal; `dalembert list` lista as análises
speed-factor = Fator de velocidade
replay-at-once-without-a-terminal-and-print-the-marked-screens-or-the-last-one = Reproduzir de uma vez, sem terminal, e escrever as telas marcadas, ou a última
speed-factor-relative-to-the-typing-speed = Fator de velocidade em relação à digitação
write-the-marked-screens-as-svg-to-this-folder-instead-of-printing-them = Gravar as telas marcadas como SVG nesta pasta em vez de escrevê-las
record-the-session-to-a-new-file-for-dalembert-replay = Gravar a sessão em um novo arquivo, para `dalembert replay`
no-terminal-to-replay-in-use-headless = não há terminal para a reprodução; use --headless
the-session-marks-no-screenshot-add-picture-name-to-it = a sessão não marca nenhuma captura; acrescente `picture NOME`
print-a-completion-script-for-a-shell = Escrever um script de complementação para um shell
print-ascii-characters-only = Escrever só caracteres ASCII
print-json = Imprimir JSON
print-the-json-schema-of-a-problem-file-for-an-editor-or-of-results = Imprimir o JSON Schema de um arquivo de problema, para um editor, ou o dos resultados
the-id-of-an-analysis-such-as-vibration-rotating-unbalance-results-for-what-solve-format-json-prints = O id de uma análise, como vibration/rotating-unbalance; results para o que `solve --format json` imprime
answer-requests-of-another-program = Responder às requisições de outro programa
read-json-lines-from-standard-input-and-write-one-to-standard-output-for-each = Ler linhas JSON da entrada padrão e escrever uma na saída padrão para cada uma
print-the-manual-page = Imprimir a página de manual
units-of-everything-that-is-shown-auto-the-system-that-the-inputs-show-as-typed-si-in-lbf-s-ft-slug-s = Unidades de tudo o que é mostrado: auto (o sistema usado nos dados), as-typed (como digitado), SI, in-lbf-s, ft-slug-s, mm-t-s
unit-of-an-answer-or-of-all-answers-of-a-name-or-a-quantity-amplitude-um-force-lbf = Unidade de uma resposta, ou de todas as de um nome ou de uma grandeza: amplitude=um, force=lbf
number-of-significant-digits = Número de algarismos significativos
show-the-inputs-and-answers-of-an-analysis = Mostrar os dados e as respostas de uma análise
solve-a-problem-and-print-its-worked-solution = Resolver um problema e imprimir a solução passo a passo
the-id-of-an-analysis-such-as-vibration-rotating-unbalance = O id de uma análise, como vibration/rotating-unbalance
language-of-the-output = Língua da saída
the-shell = O shell
subcommand-default-the-whole-program = Subcomando; padrão: o programa todo
the-table-to-print-as-csv-answers-inputs-steps-checks-table-1-plot-1 = A tabela a imprimir como CSV: answers, inputs, steps, checks, table-1, plot-1
output-format-default-by-the-file-extension-otherwise-text = Formato da saída; padrão: pela extensão do arquivo, senão texto
without-arguments-the-workbench-in-a-terminal-a-worked-problem-elsewhere-exit-status-0-solved-1 = Sem argumentos: a bancada em um terminal, um problema resolvido fora dele. Código de saída: 0 resolvido; 1 recusado, ou uma verificação falhou; 2 entrada ou uso errado.

## Descriptions of analyses
cases = Casos
closed-form = forma fechada
inputs = Dados de entrada
other-program = outro programa
own-earlier-value = valor próprio anterior
published = publicado
as-in-field = como em { $field }

## Verdicts
agreed = confere
agreed-agreed-disputed-disputed-differing-differing = { $agreed } conferem, { $disputed } contestadas, { $differing } divergem
differing = diverge
disputed = contestada
published-printed-computed-ours = publicado { $printed }, calculado { $ours }

## Information
analyses = análises
both-ends-are-a-terminal = as duas pontas são um terminal
braille = braille
characters = caracteres
colours = cores
curve-markers = marcadores das curvas
dots = pontos
half-blocks = meios blocos
language = língua
none = nenhuma
number-of-published-cases = número de casos publicados
terminal = Terminal
backup-of-unsaved-work = cópia do trabalho não salvo
version = versão
terminal-width = largura do terminal

## Errors
a-problem-file-has-no-cases-leave-out-case = um arquivo de problema não tem casos; retire --case
options-of-the-workbench-and-a-subcommand-cannot-be-combined-use-one-of-them = opções da bancada e um subcomando não se combinam; use um dos dois
and-more-more-errors = e mais { $more } erros
error = erro
error-why = erro: { $why }
id-has-no-case-number-it-has-cases-1-to-have = { $id } não tem o caso { $number }; tem os casos 1 a { $have }
no-analysis-matches-filter-dalembert-list-shows-them-all = nenhuma análise corresponde a { $filter }; `dalembert list` mostra todas
no-answer-why = sem resposta: { $why }
set-change-write-a-path-and-a-value-as-in-set-mass-40-kg = --set { $change }: escreva um caminho e um valor, como em --set mass="40 kg"
there-is-no-subcommand-name-did-you-mean-near = não há subcomando `{ $name }`; seria `{ $near }`?
there-is-no-subcommand-name-see-dalembert-help = não há subcomando `{ $name }`; veja `dalembert --help`
there-is-no-table-table-write-one-of-known = não há tabela `{ $table }`; escreva uma de { $known }
internal-error-not-caused-by-your-input-what = erro interno do programa, não causado pelos seus dados: { $what }
unit-asked-write-an-answer-and-a-unit-as-in-unit-amplitude-um = --unit { $asked }: escreva uma resposta e uma unidade, como em --unit amplitude=um

## Settings
for-serial-lines-and-screen-readers-ascii-no-colours-no-frames-no-mouse-animations-paused = Para linhas seriais e leitores de tela: ASCII, sem cores, sem molduras, sem mouse, animações em pausa
leave-the-mouse-to-the-terminal = Deixar o mouse com o terminal
print-a-settings-template = Escrever um modelo de configuração
show-version-files-and-folders-and-the-capabilities-of-the-terminal = Mostrar versão, arquivos e pastas, e os recursos do terminal
files-and-folders = Arquivos e pastas
settings = configuração
found = encontrado
not-found = não encontrado
own-lists-of-exercises = listas de exercícios próprias
history = histórico
ignored-settings = configurações ignoradas
ignored-exercises = exercícios ignorados
file-already-exists-and-is-never-overwritten-by-a-recording-choose-another-name-or-delete-it = { $file } já existe, e uma gravação nunca o sobrescreve: escolha outro nome, ou apague-o
file-cannot-be-recorded-folder-not-found = { $file } não pode ser gravado: pasta não encontrada
start-from-the-inputs-of-this-published-case-counted-from-1-without-it-set-starts-from-empty-inputs = Partir dos dados deste caso publicado, contado a partir de 1; sem isso, --set parte de dados vazios, e um id sozinho resolve o caso 1
write-to-a-new-file-by-its-extension-html-tex-typ-md-docx-txt-json-or-csv-markdown-and-typst-write = Gravar em um arquivo novo, conforme a extensão: .html, .tex, .typ, .md, .docx, .txt, .json ou .csv; Markdown e Typst gravam as figuras ao lado dele
overwrite-existing-files-never-a-problem-file = Sobrescrever arquivos existentes; nunca um arquivo de problema
refuse-a-number-without-a-unit-where-one-is-needed-instead-of-assuming-one-with-a-warning = Recusar um número sem unidade onde ela é necessária, em vez de supor uma com advertência
note-words = nota: { $words }
warning-words = aviso: { $words }
file-is-the-problem-itself-write-its-solution-to-another-file = { $file } é o próprio problema: grave a solução em outro arquivo
file-is-a-problem-file-write-the-solution-to-another-file = { $file } é um arquivo de problema: grave a solução em outro arquivo
file-already-exists-choose-another-name-or-use-force-to-overwrite = { $file } já existe: escolha outro nome, ou use --force para sobrescrever
inputs-that-are-not-set-stay-empty-case-1-starts-from-the-first-published-case = dados não definidos ficam vazios; --case 1 parte do primeiro caso publicado
check-failed-what-relative-difference-residual-limit-limit = verificação falhou: { $what }: diferença relativa { $residual }, limite { $limit }
internal-error-what = erro interno do programa: { $what }
seen-in-print = visto impresso
seen-in-the-output-of-a-companion = visto na saída de um programa que acompanha o livro
seen-on-a-page-that-quotes-it = visto em uma página que o cita
recalled = lembrado
from-memory = de memória
refusal = recusa

## Coverage of answers by checks
answers-answers-covered-covered-forms-other-forms-of-covered-ones-inputs-inputs-explained-uncovered = { $answers } respostas: { $covered } cobertas, { $forms } outras formas de cobertas, { $inputs } dados, { $explained } descobertas com motivo, { $unexplained } descobertas sem motivo
covered-although-a-reason-is-given = coberta, embora haja um motivo
no-reason-given = nenhum motivo dado
an-answer-is-covered-if-a-check-of-one-of-its-cases-fails-when-the-answer-is-changed-by-one-part-in-a = Uma resposta está coberta se uma verificação de um de seus casos falha quando ela muda uma parte em um milhão.
list-the-answers-that-no-check-covers-each-with-the-reason = Listar as respostas que nenhuma verificação cobre, cada uma com o motivo
define-a-quantity-for-formulas-in-inputs-and-questions-nu-0-3-g-e-2-1-nu = Definir uma grandeza para fórmulas em dados e perguntas: nu=0.3, 'G=E/(2*(1+nu))'
ask-a-question-over-inputs-answers-and-steps-peak-to-peak-2-x-or-one-of-the-usual-ones-which-show = Fazer uma pergunta com dados, resultados e passos: 'pico a pico=2*X'; ou uma das usuais, que `show` lista: rms_velocity
give-an-answer-whose-value-is-known-for-an-input-that-is-to-be-found-set-mass-given-natural-frequency = Dar um resultado de valor conhecido, para um dado que se quer obter: --set 'mass=?' --given 'natural_frequency=8.2 Hz'
write-a-name-and-a-formula-as-in-ask-peak-to-peak-2-x = escreva um nome e uma fórmula, como em --ask 'peak to peak=2*X'
write-an-answer-and-its-value-as-in-given-natural-frequency-8-2-hz = escreva um resultado e seu valor, como em --given 'natural_frequency=8.2 Hz'
write-a-name-and-a-formula-as-in-let-nu-0-3 = escreva um nome e uma fórmula, como em --let nu=0.3
begin-a-problem-file-with-comments-on-every-input = Iniciar um arquivo de problema, com comentários sobre cada dado
fill-in-the-inputs-of-this-published-case-counted-from-1-without-it-the-values-are-left-empty = Preencher com os dados deste caso publicado, contado a partir de 1; sem isso os valores ficam vazios
write-to-a-new-file = Escrever em um arquivo novo
overwrite-an-existing-file = Sobrescrever um arquivo existente
session-file-as-written-by-record-reads-the-standard-input = Arquivo de sessão, como --record o escreve; - lê a entrada padrão
the-id-of-an-analysis-or-a-problem-file-reads-the-standard-input = O id de uma análise, ou um arquivo de problema; - lê a entrada padrão
the-workbench-reads-its-keys-from-standard-input-name-a-file-or-use-dalembert-solve = a bancada lê as teclas da entrada padrão: informe um arquivo, ou use `dalembert solve -`
dalembert-new-id-writes-a-file-in-which-these-inputs-are-to-be-filled-in = `dalembert new { $id }` escreve um arquivo em que estes dados são preenchidos.
words-in-any-order-and-either-language-of-titles-topics-books-cases-inputs-and-answers = Palavras em qualquer ordem e em qualquer das línguas, de títulos, temas, livros, casos, dados e respostas

## Usual questions
usual-questions = Perguntas usuais
ask-name-there-is-no-such-usual-question-here-did-you-mean-near = --ask { $name }: não há essa pergunta usual aqui; quis dizer `{ $near }`?
ask-name-write-a-name-and-a-formula-as-in-ask-peak-to-peak-2-x = --ask { $name }: escreva um nome e uma fórmula, como em --ask 'pico a pico=2*X'
ask-name-write-a-name-and-a-formula-as-in-ask-peak-to-peak-2-x-or-one-of-known = --ask { $name }: escreva um nome e uma fórmula, como em --ask 'pico a pico=2*X', ou uma destas: { $known }
write-a-changed-input-and-its-value-as-in-configuration-weighted-mass-m-2-kg = escreva um dado alterado e seu valor, como em --configuration 'carregado.mass=m + 2 kg'
solve-the-same-problem-with-an-input-changed-beside-it-weighted-mass-m-2-kg = Resolve ao lado o mesmo problema com um dado alterado: 'carregado.mass=m + 2 kg'

## Find
take-the-other-inputs-of-this-published-case-counted-from-1-default-case-1-unless-set-sets-them = Usar os outros dados deste caso publicado, contado a partir de 1; padrão: caso 1, a menos que --set os defina
the-input-to-find-mass-masses-2-radius = O dado a obter: mass, masses[2].radius
least-value-of-the-range-to-search-default-1-1000-to-1000-times-the-value-of-case-1 = Menor valor do intervalo de busca; padrão: de 1/1000 a 1000 vezes o valor do caso 1
largest-value-of-the-range-to-search = Maior valor do intervalo de busca
write-an-answer-and-its-value-as-in-answer-natural-frequency-8-2-hz = escreva um resultado e seu valor, como em --answer 'natural_frequency=8.2 Hz'
unknown-for-answer-value-from-from-to-to = { $unknown } para { $answer } = { $value }, de { $from } a { $to }:
these-are-all-solutions-in-the-range-formula = são todas as soluções do intervalo: { $formula }
found-at-points-points-of-the-range = busca em { $points } pontos do intervalo
found-from-points-starts = busca a partir de { $points } pontos

## Studies
solve-a-problem-at-many-values-of-its-inputs-grids-samples-statistics = Resolver um problema para muitos valores dos dados: malhas, amostras, estatística
a-study-plan-a-problem-file-or-the-id-of-an-analysis = Um plano de estudo, um arquivo de problema ou o identificador de uma análise
vary-an-input-of-a-problem-speed-600-1800-rpm-13-speed-10-1000-31-log-mass-40-kg-45-kg-mass-normal-2 = Variar um dado de um problema: speed='600..1800 rpm:13', speed=10..1000:31:log, mass='40 kg; 45 kg', mass='normal(2 %)', mass='uniform(38 kg; 42 kg)'
the-answers-separated-by-commas-default-every-answer-that-is-a-number = Os resultados, separados por vírgulas; padrão: todo resultado numérico
a-limit-whose-probability-of-being-exceeded-is-wanted-amplitude-0-2-mm = Um limite cuja probabilidade de ser excedido se deseja: 'amplitude > 0.2 mm'
sobol-indices-shares-of-the-inputs-in-the-variance-of-each-answer = Índices de Sobol': parcelas dos dados na variância de cada resultado
two-inputs-over-which-the-answers-are-mapped-separated-by-a-comma-default-the-first-two-that-vary = Dois dados sobre os quais os resultados são mapeados, separados por vírgula; padrão: os dois primeiros que variam
write-all-points-to-a-csv-or-parquet-file-a-run-that-was-broken-off-goes-on-where-it-ended = Gravar todos os pontos em um arquivo CSV ou Parquet; uma execução interrompida continua de onde parou
number-of-samples-of-the-inputs-that-have-a-distribution = Número de amostras dos dados que têm distribuição
method-by-which-samples-are-drawn = Método de sorteio das amostras
seed-of-the-samples-the-same-seed-gives-the-same-ones = Semente das amostras: a mesma semente dá as mesmas amostras
solve-one-of-several-parts-of-the-points-into-a-file-beside-that-of-the-whole-3-16 = Resolver uma de várias partes dos pontos, em um arquivo ao lado do arquivo do todo: 3/16
merge-the-shards-into-the-file = Juntar as partes no arquivo
number-of-threads-default-one-for-each-processor = Número de threads; padrão: uma por processador
write-the-summary-to-a-file-text-markdown-html-latex-or-typst-by-its-extension = Gravar o resumo em um arquivo: texto, Markdown, HTML, LaTeX ou Typst, conforme a extensão
print-the-summary-as-json = Imprimir o resumo em JSON
print-the-plan-as-a-file-and-solve-nothing = Imprimir o plano como arquivo, sem resolver nada
vary-text-write-an-input-and-its-values-as-in-vary-speed-600-1800-rpm-13-vary-mass-40-kg-45-kg-or = --vary { $text }: escreva um dado e seus valores, como em --vary speed='600..1800 rpm:13', --vary mass='40 kg; 45 kg' ou --vary mass='normal(2 %)'
limit-text-write-an-answer-and-a-value-as-in-limit-amplitude-0-2-mm = --limit { $text }: escreva um resultado e um valor, como em --limit 'amplitude > 0.2 mm'
shard-text-write-the-number-of-the-part-and-of-all-parts-as-in-shard-3-16 = --shard { $text }: escreva o número da parte e o total de partes, como em --shard 3/16
map-text-write-two-inputs-that-vary-as-in-map-speed-mass = --map { $text }: escreva dois dados que variam, como em --map speed,mass
remaining = restantes

## Slurm
have-so-many-parts-solved-by-slurm-as-a-job-array-and-merge-them = Resolver tantas partes pelo Slurm, como um job array, e juntá-las
an-option-of-sbatch-slurm-option-partition-long = Uma opção do sbatch: --slurm-option=--partition=long

## Optima
a-limit-that-is-to-be-kept-amplitude-0-2-mm = Um limite a respeitar: 'amplitude < 0.2 mm'
an-input-to-choose-in-a-range-or-from-a-list-stiffness-20-kn-m-80-kn-m-mass-2-kg-3-kg-5-kg = Um dado a escolher, em uma faixa ou em uma lista: stiffness='20 kN/m .. 80 kN/m', mass='2 kg; 3 kg; 5 kg'
ask-a-question-over-inputs-answers-and-steps-which-may-be-minimised-or-limited-price-2-m = Fazer uma pergunta sobre dados, resultados e passos, que pode ser minimizada ou limitada: 'price=2*m'
change-an-input-with-a-tolerance-the-worst-case-counts-mass-40-kg-5 = Alterar um dado; com tolerância, vale o pior caso: mass='40 kg ± 5 %'
choose-inputs-so-that-an-answer-is-as-small-or-as-large-as-possible-under-limits = Escolher dados para que um resultado seja o menor ou o maior possível sob limites
the-answer-or-question-to-be-made-as-large-as-possible = O resultado ou a pergunta a maximizar
the-answer-or-question-to-be-made-as-small-as-possible-of-two-of-these-the-pareto-front-is-found = O resultado ou a pergunta a minimizar; de dois deles obtém-se a frente de Pareto
write-to-a-new-file-the-problem-with-the-optimum-toml-or-the-worked-solution-by-the-extension = Gravar em um arquivo novo: o problema com o ótimo (.toml), ou a resolução conforme a extensão
vary-text-write-an-input-and-its-range-or-values-as-in-vary-stiffness-20-kn-m-80-kn-m = --vary { $text }: escreva um dado e sua faixa ou seus valores, como em --vary 'stiffness=20 kN/m .. 80 kN/m'
no-answer-is-to-be-the-least-or-the-largest-add-minimise-or-maximise-as-in-minimise-amplitude-and = nenhum resultado deve ser o menor ou o maior possível: acrescente --minimise ou --maximise, como em --minimise amplitude, e dados a escolher, como em --vary 'stiffness=20 kN/m .. 80 kN/m'
## Requests of other programs
a-list-of-numbers-is-needed-for-each-column-known = é preciso uma lista de números para cada coluna: { $known }
a-request-has-an-id-and-one-of-known = uma requisição tem um `id` e um de { $known }
column-name-has-have-numbers-and-the-first-want-give-as-many-in-each = a coluna { $name } tem { $have } números e a primeira { $want }; dê o mesmo número em cada uma
is-one-value-and-no-list = é um só valor e não uma lista
key-value-want-is-needed-here = { $key } = { $value }: aqui é preciso { $want }
a-list-of-keys-of-the-result = uma lista de chaves do resultado
a-text = um texto
a-whole-number-counted-from-1 = um número inteiro, contado a partir de 1,
a-whole-number-from-1-to-17 = um número inteiro de 1 a 17
an-object-of-names-and-texts = um objeto de nomes e textos
an-object-of-names-and-values = um objeto de nomes e valores
true-or-false = true ou false
lang-language-write-en-or-pt-br = lang { $language }: escreva en ou pt-BR
name-one-of-problem-an-id-or-a-file-and-problem-file-the-text-of-a-file = dê um só de `problem`, um id ou um arquivo, e `problem_file`, o texto de um arquivo
requests-stand-on-standard-input-send-the-text-of-a-file-as-problem-file = a entrada padrão traz as requisições: envie o texto de um arquivo como `problem_file`
this-line-is-no-json-object-why = esta linha não é um objeto JSON: { $why }
this-request-is-longer-than-most-mib-send-less-in-one-line = esta requisição tem mais de { $most } MiB; envie menos em uma linha
write-an-object-behind-solve-report-and-new-and-an-id-behind-show-and-schema = escreva um objeto depois de `solve`, de `report` e de `new`, e um id depois de `show` e de `schema`
format-value-write-one-of-known = format = { $value }: escreva um de { $known }
there-is-no-answer-name-did-you-mean-near = não há a resposta `{ $name }`; você quis dizer `{ $near }`?
there-is-no-answer-name-write-one-of-known = não há a resposta `{ $name }`; escreva uma de { $known }
print-the-working-of-this-answer-alone-the-steps-that-lead-to-it-of-one-of-several-by-its-row = Imprime só o desenvolvimento desta resposta: os passos que levam a ela; de uma entre várias, pela linha: 'frequency[2]'
balance-a-rotor-in-the-field-step-by-step = Balancear um rotor em campo, passo a passo
job-file-an-existing-job-is-continued-a-new-one-is-begun-under-this-name = Arquivo do trabalho: um existente é continuado, um novo começa com este nome
## Variants and grading
write-variants-of-an-exercise-with-other-data-their-keys-and-files-for-learning-platforms = Gravar variantes de um exercício com outros dados, seus gabaritos e arquivos para plataformas de ensino
grade-the-answers-of-a-class = Avaliar as respostas de uma turma
vary-this-published-case-counted-from-1-default-case-1 = Variar este caso publicado, contado a partir de 1; padrão: caso 1
seed-of-the-data-the-same-seed-gives-the-same-variants = Semente dos dados: a mesma semente dá as mesmas variantes
number-of-variants = Número de variantes
one-variant-for-the-student-of-this-id-which-is-the-seed = Uma variante para o estudante desta identificação, que é a semente
tolerance-of-the-answers-a-share-of-their-values = Tolerância das respostas: uma fração de seus valores
output-format = Formato da saída
write-to-this-folder-a-sheet-and-a-worked-key-for-each-variant-the-key-and-its-csv-or-the-files-of-a = Gravar nesta pasta: um enunciado e um gabarito resolvido para cada variante, o gabarito e seu CSV, ou os arquivos de uma plataforma de ensino
overwrite-existing-files = Sobrescrever arquivos existentes
answers-in-csv-columns-of-students-answer-and-value-reads-the-standard-input = Respostas em CSV: colunas de estudantes, answer e value; - lê a entrada padrão
the-id-of-an-analysis-or-a-problem-file = A identificação de uma análise, ou um arquivo de problema
grade-answers-to-this-published-case-counted-from-1-default-case-1 = Avaliar respostas a este caso publicado, contado a partir de 1; padrão: caso 1
column-of-ids-whose-students-have-variants-of-their-own-as-written-by-dalembert-variants-student = Coluna de identificações cujos estudantes têm variantes próprias, como gravadas por `dalembert variants --student`
credit-of-outcomes-in-place-of-right-1-rounded-early-0-9-few-digits-0-5-carried-forward-0-8-sign-or = Crédito dos resultados no lugar de right=1, rounded-early=0.9, few-digits=0.5, carried-forward=0.8, sign-or-unit=0.5
the-longest-search-for-the-causes-of-the-wrong-answers-of-one-student-in-seconds = A busca mais longa das causas das respostas erradas de um estudante, em segundos
variants-variants-files-files-in-folder = { $variants } variantes, { $files } arquivos em { $folder }
tolerance-text-write-a-share-from-above-0-to-20-as-in-tolerance-0-5 = --tolerance { $text }: escreva uma fração acima de 0 e até 20 %, como em --tolerance '0.5 %'
student-student-why = estudante { $student }: { $why }
this-format-is-a-folder-of-files-name-the-folder-with-out = este formato é uma pasta de arquivos; indique a pasta com --out
folder-cannot-be-made-why = { $folder } não pode ser criada: { $why }
weights-why = --weights { $why }

# Check of a user's own answers.
written-write-an-answer-and-its-value-as-in-amplitude-19-5-mm = `{ $written }`: escreva uma resposta e o seu valor, como em `amplitude=19.5 mm`
there-is-no-answer-name-the-answers-are-known = não há resposta `{ $name }`; as respostas são { $known }
the-value-of-name-is-missing-as-in-name-example = falta o valor de `{ $name }`, como em `{ $name }={ $example }`
check-your-own-answers-and-find-the-likeliest-cause-of-a-wrong-one = Conferir as suas respostas e encontrar a causa mais provável de uma errada
your-answers-with-their-units-a-number-alone-is-in-the-unit-of-the-answer-amplitude-19-5-mm = As suas respostas, com unidades; um número sozinho está na unidade da resposta: 'amplitude=19.5 mm'
take-the-inputs-of-this-published-case-counted-from-1-default-case-1-unless-set-sets-them = Usar os dados deste caso publicado, contado a partir de 1; padrão: caso 1, a menos que --set os defina
change-an-input-mass-40-kg = Mudar um dado: mass="40 kg"
print-what-is-correct-too = Mostrar também o que está correto

# Sensitivity, and the values of an input within a limit.
find-the-values-of-an-input-with-which-an-answer-is-a-wanted-one-or-within-a-limit = Encontrar os valores de um dado com os quais um resultado é o desejado, ou respeita um limite
rank-the-inputs-by-their-effect-on-an-answer-and-combine-their-tolerances = Ordenar os dados pelo efeito sobre um resultado e combinar as suas tolerâncias
the-answer-or-question-and-the-value-or-the-limit-that-it-is-to-have-natural-frequency-8-2-hz = O resultado ou pergunta, e o valor ou o limite que deve ter: 'natural_frequency=8.2 Hz', 'amplitude<=2 mm'
the-same-as-input = O mesmo que INPUT
the-same-as-answer-value = O mesmo que ANSWER=VALUE
change-another-input-mass-40-kg = Mudar outro dado: mass="40 kg"
the-answer-default-the-main-one = O resultado; padrão: o principal
change-an-input-its-tolerance-may-stand-behind-it-mass-40-kg-5 = Mudar um dado; a sua tolerância pode vir atrás dele: mass='40 kg ± 5 %'
tolerance-of-an-input-to-either-side-in-place-of-that-of-the-problem-mass-2-length-0-5-mm = Tolerância de um dado, para cada lado, no lugar da do problema: mass='2 %', length='0.5 mm'
number-of-samples-of-the-monte-carlo-simulation = Número de amostras da simulação de Monte Carlo
tolerance-text-why = --tolerance { $text }: { $why }
write-an-input-and-its-tolerance-as-in-tolerance-mass-2 = escreva um dado e a sua tolerância, como em --tolerance mass='2 %'
elasticity = Elasticidade
derivative = Derivada
tolerance = ± tolerância
at-its-lower-end = no limite inferior
at-its-upper-end = no limite superior
worst-case-at-the-ends-of-the-tolerances-least-to-most = pior caso nos limites das tolerâncias: { $least } a { $most }
root-of-the-sum-of-squares-value-likely = raiz da soma dos quadrados: { $value } ± { $likely }
monte-carlo-95-of-the-answers-from-from-to-to-mean-mean-samples-samples-seed-seed-normal-inputs-95 = Monte Carlo: 95 % dos resultados de { $from } a { $to }, média { $mean } ({ $samples } amostras, semente { $seed }; dados normais, 95 % dentro das tolerâncias)
no-tolerance-is-given-1-is-taken-for-every-input-1-for-an-angle-write-tolerance-path-value-for-your = nenhuma tolerância é dada: adota-se 1 % para cada dado, 1° para um ângulo; escreva --tolerance CAMINHO=VALOR para as suas
input-asymmetric-effect = { $input }: efeito assimétrico
input-no-answer-on-one-side-why = { $input }: sem resultado de um lado: { $why }
count-of-samples-samples-have-no-answer = { $count } de { $samples } amostras não têm resultado
warning-monte-carlo-and-root-of-the-sum-of-squares-differ-by-percent-of-the-latter-more-than-limit = aviso: Monte Carlo e a raiz da soma dos quadrados diferem em { $percent } % desta, mais de { $limit } %: dentro destas tolerâncias o resultado não é linear
certified-by-interval-arithmetic-for-the-formulas-of-this-solution-the-same-formulas-were-seen-at = certificado por aritmética intervalar para as fórmulas desta solução; as mesmas fórmulas foram vistas em { $points } pontos da faixa
not-certified-why-points-points-of-the-range-were-examined = não certificado: { $why }; { $points } pontos da faixa foram examinados
undecided-from-from-to-to = não decidido: de { $from } a { $to }
undecided-in-all-percent-of-the-range = não decidido ao todo: { $percent } % da faixa
the-range-from-from-to-to-of-path-is-empty-write-from-and-to-in-ascending-order = a faixa de { $from } a { $to } de `{ $path }` é vazia: escreva --from e --to em ordem crescente
a-value-is-missing-write-one-in-unit-as-in-1-5-unit = falta um valor; escreva um em { $unit }, como em 1.5 { $unit }
unknown-for-answer-relation-value-from-from-to-to = { $unknown } para { $answer } { $relation } { $value }, de { $from } a { $to }:
the-answer-does-not-depend-on-this-input = o resultado não depende deste dado
not-a-constraint-every-value-of-the-range-meets-it-the-answer-lies-between-least-at-at-least-and-most = não é restrição: todo valor da faixa a satisfaz; o resultado fica entre { $least } (em { $at_least }) e { $most } (em { $at_most })
impossible-no-value-of-the-range-meets-it-the-answer-lies-between-least-at-at-least-and-most-at-at = impossível: nenhum valor da faixa a satisfaz; o resultado fica entre { $least } (em { $at_least }) e { $most } (em { $at_most })
impossible-there-is-no-answer-in-the-whole-range = impossível: não há resultado em toda a faixa
from-to-to-lower-upper = { $from } a { $to } ({ $lower }; { $upper })
limit-reached = limite atingido
beyond-it-no-answer-why = além disso não há resultado: { $why }
beyond-it-no-answer = além disso não há resultado
beyond-it-undecided = além disso não decidido
no-value-of-the-range-is-known-to-meet-it-values-that-may-are-in-what-is-undecided = de nenhum valor da faixa se sabe que a satisfaz; valores que talvez o façam estão no que não está decidido
solve-the-problem-in-a-calculation-note-again-and-compare-every-printed-line-of-data-answers-and = Resolver de novo o problema de um memorial de cálculo e comparar cada linha impressa de dados, respostas e resolução
note-that-dalembert-solve-output-wrote-html-latex-typst-or-markdown = Memorial escrito por `dalembert solve --output`: HTML, LaTeX, Typst ou Markdown
line-of-the-title-block-project-author-checker-date-or-revision-as-in-author-a-silva = Linha do carimbo: project (projeto), author (elaborado por), checker (verificado por), date (data) ou revision (revisão), como em author='A. Silva'
title-block-line-write-a-line-and-its-text-as-in-title-block-author-a-silva = --title-block { $line }: escreva uma linha e seu texto, como em --title-block author='A. Silva'
a-note-is-html-latex-typst-markdown-or-word-html-tex-typ-md-or-docx = um memorial é HTML, LaTeX, Typst, Markdown ou Word: .html, .tex, .typ, .md ou .docx
a-document-of-word-is-no-text-to-print-name-its-file-as-in-output-note-docx = um documento do Word não é texto para escrever na tela: dê o nome do arquivo, como em --output memorial.docx
the-note-was-written-by-dalembert-version-this-is-this = o memorial foi escrito pelo dalembert { $version }; este é o { $this }
line-line-printed-printed-computed-computed = linha { $line }: impresso `{ $printed }`, calculado `{ $computed }`
missing-in-the-note-computed = falta no memorial: `{ $computed }`
confirmed-count-lines-of-data-answers-and-working-are-as-computed = confirmado: { $count } linhas de dados, respostas e resolução conferem com o cálculo
not-confirmed-found-of-count-lines-of-data-answers-and-working-are-not-as-computed = não confirmado: { $found } de { $count } linhas de dados, respostas e resolução não conferem com o cálculo
title-is-left-out-another-analysis-has-its-id-id-give-it-one-of-its-own = { $title } fica de fora: outra análise tem o seu id { $id }; dê-lhe um id próprio
number-has-a-decimal-mark-and-is-read-as-a-decimal-write-thousands-without-one = { $number } tem um sinal decimal e é lido como decimal; escreva milhares sem sinal
