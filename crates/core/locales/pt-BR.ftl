# What the core says: inputs, files, answers.

## Reading quantities
unexpected-found-expected-expected = `{ $found }` inesperado: espera-se { $expected }
symbol-must-follow-after-write-a-single-value-for-example-example = `{ $symbol }` deve vir depois de { $after }: escreva um único valor, por exemplo { $example }
text-divides-by-zero-write-another-divisor = `{ $text }` divide por zero: escreva outro divisor
text-has-a-unit-with-some-components-only-write-one-unit-after-the-brackets-as-in-example = `{ $text }` tem unidade só em algumas componentes: escreva uma unidade depois dos parênteses, como em `{ $example }`
text-has-two-decimal-marks-write-first-or-second = `{ $text }` tem dois sinais decimais: escreva `{ $first }` ou `{ $second }`
text-has-a-gap-between-digits-write-first-or-second = `{ $text }` tem um espaço entre algarismos: escreva `{ $first }` ou `{ $second }`
text-can-be-read-in-two-ways-write-first-or-second = `{ $text }` pode ser lido de dois modos: escreva `{ $first }` ou `{ $second }`
text-without-a-unit-can-be-read-in-two-ways-write-first-or-second = `{ $text }` sem unidade pode ser lido de dois modos: escreva `{ $first }` ou `{ $second }`
shown-is-of-another-kind-than-first-value-write-all-of-these-in-units-of-one-kind = { $shown } é de outra espécie que { $first } = { $value }: escreva todas estas grandezas em unidades de uma só espécie
why-units-of-any-of-these-kinds-are-accepted-units = { $why }; aceitam-se unidades de qualquer destas espécies: { $units }
was-read-as-now-the-units-now-say-what-was-measured = { $was }: lido como { $now }; agora as unidades dizem o que foi medido
text-is-neither-yes-nor-no = `{ $text }` não é nem sim nem não
unexpected-text-after-the-unit-an-exponent-is-an-integer-other-than-0-from-limit-to-limit = `{ $text }` inesperado depois da unidade: um expoente é um inteiro diferente de 0, de -{ $limit } a { $limit }
text-is-not-a-count-enter-an-integer-for-example-4 = `{ $text }` não é uma contagem: digite um inteiro, por exemplo 4
text-is-not-a-number-write-digits-for-example-example = `{ $text }` não é um número: escreva algarismos, por exemplo { $example }
text-is-not-a-real-number-write-a-root-of-a-positive-number = `{ $text }` não é um número real: escreva a raiz de um número positivo
text-is-too-close-to-zero-write-a-number-above-1e-300 = `{ $text }` está perto demais de zero: escreva um número acima de 1e-300
text-is-too-large-write-a-number-below-1e300 = `{ $text }` é grande demais: escreva um número abaixo de 1e300
text-is-found-expected-expected-e-g-in-example = `{ $text }` é { $found }; espera-se { $expected }, por exemplo em { $example }
text-is-found-expected-expected-e-g-in-example-hint = `{ $text }` é { $found }; espera-se { $expected }, por exemplo em { $example }; { $hint }
text-is-incomplete-expected-expected = `{ $text }` está incompleto: espera-se { $expected }
a-level = um nível
a-number-without-a-unit = um número sem unidade
a-quantity-in-unit = uma grandeza em { $unit }
an-amplitude-in-unit = uma amplitude em { $unit }
a-value-is-needed-for-example-example = falta um valor, por exemplo { $example }
a-mass-is-weight-g-write-weight-9-81-kg = massa é peso / g: escreva `{ $weight }/9.81 kg`
a-weight-is-mass-g-write-9-81-mass-n-or-mass-kgf = peso é massa × g: escreva `9.81*{ $mass } N` ou `{ $mass } kgf`
more-than-limit-nested-brackets-roots-powers-and-signs-write-a-simpler-expression = mais de { $limit } níveis de parênteses, raízes, potências e sinais: escreva uma expressão mais simples
symbol-has-several-meanings-write-meant = `{ $symbol }` tem vários significados: escreva { $meant }
g-is-the-gram-write-text-for-multiples-of-standard-gravity = g é o grama: escreva `{ $text }` para múltiplos da gravidade padrão
g0-is-standard-gravity-write-text-for-grams = g0 é a gravidade padrão: escreva `{ $text }` para gramas
unit-is-a-mass-write-text = { $unit } é uma massa: escreva `{ $text }`
unit-is-a-force-write-text = { $unit } é uma força: escreva `{ $text }`
peak-peak-to-peak-and-rms-belong-to-amplitudes-write-the-unit-alone = pico, pico a pico e rms são de amplitudes: escreva só a unidade
the-marks-and-are-minutes-and-seconds-of-arc-write-text = os sinais ' e " são minutos e segundos de arco: escreva `{ $text }`
the-square-root-of-dim-is-not-a-unit-write-a-root-of-an-even-power-such-as-sqrt-4-m-2 = a raiz quadrada de { $dim } não é uma unidade: escreva a raiz de uma potência par, como sqrt(4 m^2)
the-text-contains-the-control-or-invisible-character-code-delete-it = o texto contém o caractere de controle ou invisível { $code }: apague-o
the-text-is-longer-than-limit-characters-write-a-single-value = o texto passa de { $limit } caracteres: escreva um único valor
unknown-unit-symbol-did-you-mean-nearest = unidade desconhecida `{ $symbol }`: seria { $nearest }?
unknown-unit-symbol-write-a-unit-such-as-m-kg-s-n-pa-or-rpm = unidade desconhecida `{ $symbol }`: escreva uma unidade como m, kg, s, N, Pa ou rpm
write-n-m-for-a-torque-number-n-m = escreva N·m para um torque: `{ $number } N*m`
write-brackets-if-the-divisor-is-meant-to-have-the-unit-text = use parênteses se a unidade é do divisor: `{ $text }`
write-the-angle-in-rad-or-deg-that-of-a-30-slope-is-16-699-deg = escreva o ângulo em rad ou deg; o de uma inclinação de 30 % é 16.699 deg
found-components-are-written-where-expected-are-expected-write-them-as-in-example = há { $found } componentes onde se esperam { $expected }: escreva como em `{ $example }`
left-and-right-cannot-be-added-did-you-mean-one = { $left } e { $right } não podem ser somados: seria `{ $one }`?
left-and-right-cannot-be-added-write-first-or-second = { $left } e { $right } não podem ser somados: escreva `{ $first }` ou `{ $second }`
left-and-right-cannot-be-added-give-both-the-same-kind-of-unit-or-write-brackets-as-in-2-3-mm = { $left } e { $right } não podem ser somados: dê a ambos o mesmo tipo de unidade, ou use parênteses como em `(2 + 3) mm`

## Limits
must-be-above-zero-you-wrote-text = deve ser maior que zero; foi escrito { $text }
must-not-be-below-zero-you-wrote-text = não pode ser negativo; foi escrito { $text }
must-be-above-limit-you-wrote-text = deve ser maior que { $limit }; foi escrito { $text }
must-be-limit-or-more-you-wrote-text = deve ser { $limit } ou mais; foi escrito { $text }
must-be-below-limit-you-wrote-text = deve ser menor que { $limit }; foi escrito { $text }
must-be-limit-or-less-you-wrote-text = deve ser { $limit } ou menos; foi escrito { $text }
count-is-outside-the-limits-enter-an-integer-from-min-to-max = { $count } está fora dos limites; digite um inteiro de { $min } a { $max }
at-least-one-row-is-needed = é necessária ao menos uma linha
at-least-min-rows-are-needed-so-far-have = são necessárias ao menos { $min } linhas; até agora: { $have }
row-first-is-called-name-too-and-an-input-refers-to-that-name-give-each-its-own = a linha { $first } também se chama `{ $name }`, e uma entrada se refere a esse nome: dê a cada uma o seu
there-is-only-one-row-the-next-is-next = há só uma linha; a próxima é { $next }
did-you-mean-text = seria `{ $text }`?
the-character-code-cannot-be-typed-here-remove-it = o caractere { $code } não pode ser digitado aqui; remova-o
have-characters-at-most-most-are-accepted = { $have } caracteres: são aceitos no máximo { $most }

## Fields and paths
is-missing = está faltando
a-quantity-is-needed-here = aqui é necessária uma grandeza
a-vector-is-needed-here = aqui é necessário um vetor
a-text-is-needed-here = aqui é necessário um texto
yes-or-no-is-needed-here = aqui é necessário sim ou não
a-whole-number-is-needed-here = aqui é necessário um número inteiro
the-name-of-a-row-is-needed-here = aqui é necessário o nome de uma linha
one-of-the-alternatives-is-needed-here = aqui é necessária uma das alternativas
a-list-is-needed-here = aqui é necessária uma lista
a-table-is-needed-here = aqui é necessária uma tabela
a-group-of-inputs-is-needed = é necessário um grupo de dados
one-alternative-is-needed-here-known = aqui é necessária uma das alternativas: { $known }
is-not-an-input-of-the-problem-with-its-present-options = não é um dado do problema com as opções atuais
is-not-a-quantity-of-this-problem-so-it-cannot-be-varied = não é uma grandeza deste problema, portanto não pode ser variada
is-not-a-number-among-the-answers = não é um número entre as respostas
a-name-is-missing-write-a-path-such-as-masses-1-radius = falta um nome; escreva um caminho como masses[1].radius
there-are-no-list-to-name = não há { $list } para nomear
there-are-rows-rows-the-next-is-next = há { $rows } linhas; a próxima é { $next }
there-is-no-name-did-you-mean-near = não há `{ $name }`; seria `{ $near }`?
there-is-no-name-write-one-of-known = não há `{ $name }`; escreva um de { $known }
rest-was-not-expected-here = `{ $rest }` não era esperado aqui
row-is-not-a-row-rows-count-from-1-as-in-masses-1 = `{ $row }` não é uma linha; as linhas contam a partir de 1, como em masses[1]

## Tables
line-line-why = linha { $line }: { $why }
there-are-more-faults-these-are-the-first = há mais erros; estes são os primeiros
the-heading-gives-unit-for-column-hint = o cabeçalho dá { $unit } para { $column }; { $hint }
the-heading-gives-unit-for-column-write-a-unit-like-own = o cabeçalho dá { $unit } para { $column }; escreva uma unidade como { $own }
no-row-of-numbers-follows-the-heading-in-line-line-write-one-row-a-line-columns = nenhuma linha de números segue o cabeçalho na linha { $line }; escreva uma linha de dados por linha: { $columns }
the-table-is-empty-write-one-row-a-line-columns = a tabela está vazia; escreva uma linha de dados por linha: { $columns }
line-line-and-more-more-why = linha { $line } e mais { $more }: { $why }
have-columns-separated-by-separator-instead-of-want-columns = { $have } colunas separadas por { $separator } em vez de { $want }: { $columns }
one-column-instead-of-want-columns-separate-them-by-semicolons-tabs-spaces-or-commas = uma coluna em vez de { $want }: { $columns }; separe-as por ponto e vírgula, tabulações, espaços ou vírgulas
column-after = { $column }; { $after }
semicolons = ponto e vírgula
blanks = espaços
spaces = espaços
commas = vírgulas
this-table-has-have-bytes-at-most-most-are-read = esta tabela tem { $have } bytes; são lidos no máximo { $most }

## Problem files
key-must-be-a-text-in-quotes = `{ $key }` deve ser um texto entre aspas
path-why = { $path }: { $why }
the-analysis-is-not-named-write-analysis-family-name-at-the-top = a análise não foi nomeada; escreva analysis = "family/name" no início
the-analysis-must-be-a-text-such-as-vibration-rotating-unbalance = a análise deve ser um texto como "vibration/rotating-unbalance"
there-is-no-analysis-id-did-you-mean-near = não há análise `{ $id }`; seria `{ $near }`?
there-is-no-analysis-id-see-dalembert-list = não há análise `{ $id }`; veja `dalembert list`
this-file-has-format-found-this-program-reads-formats-up-to-known-update-the-program = este arquivo tem o formato { $found }; este programa lê formatos até { $known }: atualize o programa
this-is-not-a-format-write-format-known = isto não é um formato; escreva `format = { $known }`
path-omitted-value-assumed-the-default-of-files-without-format-2 = { $path } omitido: supõe-se { $value }, o padrão de arquivos sem `format = 2`
duplicate-key-key-keep-one-of-the-two = chave repetida `{ $key }`: mantenha uma das duas
the-file-is-nested-too-deeply-to-be-a-problem-file = níveis de aninhamento demais para um arquivo de problema
a-unit-must-be-a-text-such-as-mm = uma unidade deve ser um texto como "mm"

## Answers
every-value = qualquer valor
no-value = nenhum valor
or = ou
these-inputs-lead-to-a-number-that-cannot-be-represented-symbol = estes dados levam a um número que não pode ser representado: { $symbol }

## Kinds of quantity
a-length = um comprimento
a-mass = uma massa
a-time = um tempo
an-angle = um ângulo
an-angular-velocity = uma velocidade angular
an-angular-acceleration = uma aceleração angular
a-velocity = uma velocidade
an-acceleration = uma aceleração
a-force = uma força
a-torque = um torque
an-energy = uma energia
a-power = uma potência
a-stiffness = uma rigidez
a-torsional-stiffness = uma rigidez à torção
a-damping-coefficient = um coeficiente de amortecimento
a-torsional-damping-coefficient = um coeficiente de amortecimento à torção
a-stress = uma tensão
an-area = uma área
a-volume = um volume
a-second-moment-of-area = um momento de inércia de área
a-density = uma massa específica
a-mass-per-length = uma massa por comprimento
a-moment-of-inertia = um momento de inércia
an-unbalance = um desbalanceamento
a-compliance = uma flexibilidade
a-flexural-rigidity = uma rigidez à flexão
a-momentum = uma quantidade de movimento
an-angular-momentum = uma quantidade de movimento angular
a-ratio = uma razão
an-amplitude = uma amplitude
another-quantity = outra grandeza

## What a reader expects
an-operator-or-a-unit = um operador ou uma unidade
an-operator = um operador
a-plain-number = um número simples
a-closing-bracket = um parêntese de fechamento
a-closing-bracket-behind-2-or-3-components = um parêntese de fechamento depois de 2 ou 3 componentes
an-opening-bracket = um parêntese de abertura
a-number-or-a-unit = um número ou uma unidade
a-number = um número
a-unit = uma unidade
a-unit-of-length-velocity-or-acceleration = uma unidade de comprimento, velocidade ou aceleração
a-division = uma divisão
a-component = uma componente
a-component-along-i-j-or-k = uma componente ao longo de i, j ou k
each-axis-once = cada eixo uma só vez
one-unit = uma só unidade
a-magnitude = um módulo

## Universal files
is-between-datasets = está entre conjuntos de dados
a-dataset-begins-and-the-file-ends = um conjunto de dados começa e o arquivo termina
dataset-number-is-not-a-function = o conjunto de dados { $number } não é uma função
not-a-dataset-number = isto não é um número de conjunto de dados
the-function-ends-before-its-values = a função termina antes dos seus valores
the-form-of-the-values-cannot-be-read = a forma dos valores não pode ser lida
values-of-type-found-are-not-read-types-2-4-5-and-6-are = valores do tipo { $found } não são lidos; os tipos 2, 4, 5 e 6 são
count-points-are-announced-1-to-most-are-read = são anunciados { $count } pontos; de 1 a { $most } são lidos
the-abscissas-are-evenly-spaced-without-a-step = as abscissas são igualmente espaçadas sem um passo
point-n-of-the-function-is-not-finite = o ponto { $n } da função não é finito
the-file-ends-within-the-function = o arquivo termina dentro da função
line-is-not-a-row-of-numbers = `{ $line }` não é uma linha de números
the-function-has-have-numbers-its-header-announces-wanted = a função tem { $have } números; seu cabeçalho anuncia { $wanted }
byte-order-order-is-not-read-1-and-2-are = a ordem de bytes { $order } não é lida; 1 e 2 são
floating-point-format-format-is-not-read-write-the-file-in-format-2-ieee-754 = o formato de ponto flutuante { $format } não é lido; grave o arquivo no formato 2, IEEE 754
the-function-has-too-few-bytes-for-its-points = a função tem bytes de menos para seus pontos
end-of-dataset-missing-after-its-bytes = falta o fim do conjunto depois dos bytes
this-universal-file-has-no-function-that-can-be-read-line-line-why = este arquivo universal não tem função que possa ser lida; linha { $line }: { $why }
this-universal-file-has-no-function-that-can-be-read = este arquivo universal não tem função que possa ser lida
there-is-no-function-which-this-universal-file-has-have = não há função { $which }; este arquivo universal tem { $have }
no-function-of-this-universal-file-fits-the-table-line-line-why = nenhuma função deste arquivo universal serve para a tabela; linha { $line }: { $why }
the-function-is-real-the-table-asks-for-real-and-imaginary-part-or-amplitude-and-phase = a função é real; a tabela pede partes real e imaginária, ou amplitude e fase
a-function-fills-two-or-three-columns-the-table-has-count = uma função preenche duas ou três colunas; a tabela tem { $count }
the-function-is-in-unit-the-table-asks-for-column-in-a-unit-like-own = a função está em { $unit }; a tabela pede { $column } em uma unidade como { $own }

# Conferir uma resposta
outside-the-limits-of-this-input = fora dos limites desta entrada
write-it-as-in-example = escreva como em `{ $example }`
not-a-finite-number = não é um número finito
all-next = { $all }, { $next }
consistent-with-your-earlier-answer-to-answers-error-carried-forward = coerente com a sua resposta a { $answers } (erro propagado)
this-is-the-value-of-another-answer-answer = este é o valor de outra resposta: { $answer }
input-change = { $input }: { $change }
first-and-second-interchanged = { $first } e { $second } trocados
computing-symbol-change = no cálculo de { $symbol }: { $change }
label-place = { $label } { $place }
label-row = { $label }, { $row }
sign-error = erro de sinal
the-number-is-in-taken-not-is = o número está em { $taken }, não em { $is }
squared-value-a-square-root-was-omitted = valor ao quadrado: uma raiz quadrada foi omitida
square-root-of-the-value-a-square-was-omitted = raiz do valor: um quadrado foi omitido
reciprocal-of-the-answer = inverso da resposta
angle-measured-from-another-axis-or-in-the-opposite-sense = ângulo medido a partir de outro eixo ou no sentido oposto
is-used-as-taken = { $is } usado como { $taken }
diameter-and-radius-or-a-whole-and-its-half-confused = confusão entre diâmetro e raio (ou entre o todo e a metade)
gravity-used = usado { $gravity }
omitted = omitido
measured-from-another-axis-or-in-the-opposite-sense = medido a partir de outro eixo ou no sentido oposto
the-other-sign = o sinal contrário
sign-error-in-a-term = erro de sinal em um termo
a-term-omitted = um termo omitido
an-exponent-omitted = um expoente omitido
a-square-root-omitted = uma raiz quadrada omitida
sine-and-cosine-interchanged = seno e cosseno trocados
division-and-multiplication-interchanged = divisão e multiplicação trocadas
factor-times-too-large = { $factor } vezes maior
factor-times-too-small = { $factor } vezes menor
taken-otherwise = tomado de outro modo
different-interpretation = outra interpretação
correct = correto
close-off-off-rounding-of-an-intermediate-result-or-a-small-term = próximo (diferença de { $off }): arredondamento intermediário, ou um termo pequeno
agrees-to-the-digits-given-enter-more-digits-to-confirm = concorda até os algarismos dados; digite mais para confirmar
not-right = não está certo
incorrect = incorreto

# Sensibilidade e estudos
a-tolerance-cannot-be-negative-it-applies-to-both-sides = uma tolerância não pode ser negativa; vale para os dois lados
this-input-is-not-a-number-of-the-problem-with-its-present-options = este dado não é um número do problema com as opções atuais
the-range-is-empty-enter-two-different-limits = a faixa é vazia: digite dois limites diferentes
this-input-cannot-be-varied = esta entrada não pode ser variada
input-value = { $input } = { $value }
target-not-reached-in-the-range-the-answer-lies-between-least-at-at-least-and-most-at-at-most = alvo não atingido na faixa: a resposta fica entre { $least } (em { $at_least }) e { $most } (em { $at_most })
no-answer-in-the-whole-range = nenhuma resposta em toda a faixa
answer-against-input = { $answer } em função de { $input }
no-answer-from-from-to-to-why = sem resposta de { $from } a { $to }: { $why }
no-reason-reported = sem motivo informado
current-value = valor atual
wanted = desejado
target = alvo
mean-mean-standard-deviation-deviation = média { $mean }, desvio padrão { $deviation }
n-95-interval-low-to-high = intervalo de 95 %: { $low } a { $high }
refused-of-all-have-no-answer = { $refused } de { $all } não têm resposta
distribution-of-answer = Distribuição de { $answer }
relative-frequency = frequência relativa
the-published-value-cannot-be-compared-with-the-computed-one = o valor publicado não pode ser comparado com o calculado
outdated-dispute-the-published-value-agrees = contestação desatualizada: o valor publicado concorda
title-is-required = falta `title = "…"`
at-least-one-exercise-with-analysis-family-name-is-required = falta ao menos um `[[exercise]]` com `analysis = "family/name"`
an-exercise-requires-analysis-family-name = um exercício exige `analysis = "family/name"`
key-is-neither-analysis-nor-case = `{ $key }` não é `analysis` nem `case`
analysis-has-no-case-name-did-you-mean-near = { $analysis } não tem o caso `{ $name }`; seria `{ $near }`?
analysis-has-no-case-name-dalembert-show-analysis-lists-them = { $analysis } não tem o caso `{ $name }`; `dalembert show { $analysis }` os lista
answer-does-not-depend-on-input = { $answer } não depende de { $input }
the-heading-gives-unit-for-column-which-has-no-unit = o cabeçalho dá { $unit } para { $column }, que não tem unidade
line-line-the-unit-of-column-is-known-above-and-unit-here = linha { $line }: a unidade de { $column } é { $known } acima e { $unit } aqui
the-heading-contains-word-but-has-not-one-cell-per-column-write-one-such-as-own = o cabeçalho contém { $word }, mas não tem uma célula por coluna: escreva um como { $own }
the-heading-of-column-contains-word-not-recognised-as-its-unit-write-the-unit-in-brackets-such-as-own = o cabeçalho de { $column } contém { $word }, não reconhecido como unidade: escreva a unidade entre colchetes, como [{ $own }]
the-heading-of-column-contains-word-did-you-mean-meant = o cabeçalho de { $column } contém { $word }: seria [{ $meant }]?
column-unit = { $column } [{ $unit }]
two-values-of-gravity-in-one-problem-first-at-path-second-at-other = dois valores da gravidade em um problema: { $first } em { $path }, { $second } em { $other }
table-no-unit-in-the-heading-units-assumed = { $table }: sem unidade no cabeçalho; supõe-se { $units }
path-no-unit-in-the-heading-units-assumed-as-in-files-without-format-2 = { $path }: sem unidade no cabeçalho; supõe-se { $units }, como em arquivos sem `format = 2`
this-row-has-no-column-a-row-has-columns = esta linha não tem { $column }; uma linha tem { $columns }
write-a-table-as-lines-of-text-with-the-heading-heading-or-as-a-list-of-rows-row = escreva uma tabela como linhas de texto com o cabeçalho "{ $heading }", ou como uma lista de linhas { $row }
have-rows-at-most-most-are-accepted-here = { $have } linhas: aqui são aceitas no máximo { $most }
write-one-of-known = escreva um destes: { $known }
no-unit-unit-assumed = sem unidade; supõe-se { $unit }
there-is-no-name = não há `{ $name }`
path-text-read-as-value-as-in-every-file-without-format-2 = { $path } = { $text }: lido como { $value }, como em todo arquivo sem `format = 2`
show-is-a-table-of-answers-and-their-units-as-in-show-amplitude-mm-6-digits = `show` é uma tabela de respostas e suas unidades, como em [show] amplitude = "mm; 6 digits"
count-digits-write-from-1-to-17-digits = `{ $count } digits`: escreva de 1 a 17 algarismos
a-check-of-the-solution-failed = uma verificação da solução falhou
the-computed-value-in-place-of-the-disputed-one-is-right = o valor calculado, em lugar do contestado, é { $right }

## Coverage of answers by checks
definition-no-independent-check-exists = definição: não há verificação independente
it-is-counted-not-measured = é contada, não medida
a-count = uma contagem
a-list-or-set-its-numbers-have-no-traced-steps = lista ou conjunto: seus números não têm passos rastreados
a-standard-or-an-empirical-rule-gives-it = dada por uma norma ou uma regra empírica
given-by-a-standard-or-an-empirical-rule = dado por uma norma ou regra empírica
definition = Definição
question-question = Pergunta: { $question }
name-has-several-meanings-write-one-of-known = `{ $name }` tem vários significados: escreva um destes: { $known }
name-is-a-set-of-values-which-a-formula-cannot-take = `{ $name }` é um conjunto de valores, que uma fórmula não aceita
name-is-defined-twice-keep-one-of-the-two = `{ $name }` está definido duas vezes: mantenha uma das duas
name-is-no-function-write-name-for-a-product = `{ $name }` não é uma função: escreva `{ $name }*(…)` para um produto
name-is-no-name-write-letters-digits-and-a-letter-first = `{ $name }` não é um nome: escreva letras, algarismos e _, começando por uma letra
name-is-the-name-of-a-function-or-a-constant-choose-another = `{ $name }` é o nome de uma função ou constante: escolha outro
name-is-the-name-of-an-input-choose-another = `{ $name }` é o nome de um dado: escolha outro
text-compares-or-adds-left-and-right-both-must-be-the-same-kind-of-quantity = `{ $text }` compara ou soma { $left } e { $right }: ambos devem ser grandezas da mesma espécie
text-has-no-finite-value-with-these-numbers = `{ $text }` não tem valor finito com estes números
text-has-no-value-a-sine-or-cosine-is-between-1-and-1 = `{ $text }` não tem valor: um seno ou cosseno está entre −1 e 1
text-is-no-single-number = `{ $text }` não é um único número
text-is-no-vector-write-its-components-as-in-r-0-or-r-0-2-r = `{ $text }` não é um vetor: escreva os componentes, como em (R; 0) ou (R; 0; 2*R)
text-has-a-component-along-z-components-components-are-asked = `{ $text }` tem um componente ao longo de z: pedem-se { $components } componentes
text-is-of-an-empty-list = `{ $text }` é de uma lista vazia
text-is-found-which-unit-does-not-measure = `{ $text }` é { $found }, que { $unit } não mede
text-mixes-numbers-vectors-or-lists-in-a-way-that-has-no-meaning = `{ $text }` mistura números, vetores ou listas de um modo sem significado
a-comma-or-a-closing-bracket = uma vírgula ou um parêntese de fechamento
a-number-a-name-or-a-bracket = um número, um nome ou um parêntese
a-word-directly-behind-a-number-is-a-unit-and-name-is-none-write-number-name = uma palavra logo após um número é uma unidade, e `{ $name }` não é: escreva `{ $number }*{ $name }`
an-angle-needs-its-unit-write-name-number-deg-or-name-number-rad = um ângulo precisa da sua unidade: escreva `{ $name }({ $number } deg)` ou `{ $name }({ $number } rad)`
an-exponent-is-a-number-without-a-unit-that-of-text-is-found = um expoente é um número sem unidade; o de `{ $text }` é { $found }
defined-in-a-circle-circle = definido em círculo: { $circle }
one-argument = um argumento
there-is-no-function-name-did-you-mean-near = não há função `{ $name }`; seria `{ $near }`?
there-is-no-function-name-there-are-known = não há função `{ $name }`; há { $known }
two-arguments = dois argumentos
two-questions-have-the-key-key-give-one-of-them-another = duas perguntas têm a chave `{ $key }`: dê outra a uma delas
found-has-no-such-root-text = { $found } não tem essa raiz: `{ $text }`
found-to-the-power-power-is-not-a-quantity = { $found } elevado a { $power } não é uma grandeza
from-or-more-arguments = { $from } ou mais argumentos
from-to-to-arguments = { $from } a { $to } argumentos
input-by-its-formula = { $input }, pela sua fórmula
name-is-of-a-number-without-a-unit-or-of-an-angle-text-has-found = { $name } é de um número sem unidade ou de um ângulo; `{ $text }` tem { $found }
name-takes-wanted-there-are-have = { $name } recebe { $wanted }; há { $have }
question-no-value-why = { $question }: sem valor: { $why }
definitions = Definições
questions = Perguntas
value-or-formula = Valor ou fórmula
formula = Fórmula
quantity = Grandeza
symbol = Símbolo
key = Chave
unit-of-the-result = Unidade do resultado
name = Nome
quantities-of-your-own-for-formulas-in-inputs-and-questions-nu-0-3-g-e-2-1-nu = Grandezas próprias, para fórmulas em dados e perguntas: nu = 0.3, G = E/(2*(1+nu)).
formulas-over-inputs-answers-and-steps-answered-like-the-rest-peak-to-peak-2-x = Fórmulas com dados, resultados e passos, respondidas como as demais: pico a pico = 2*X.
as-formulas-write-it-nu-e-1-bolt = Como as fórmulas o escrevem: nu, E_1, parafuso.
n-12-g-or-e-2-1-nu-over-other-definitions-and-inputs = 12 g, ou E/(2*(1+nu)) com outras definições e dados.
in-words-peak-to-peak = Em palavras: pico a pico.
over-definitions-inputs-answers-and-steps-2-x-c-omega-x-2-2 = Com definições, dados, resultados e passos: 2*X, c*(omega*X)^2/2.
the-unit-of-the-result-left-out-that-of-its-parts = A unidade do resultado; omitida, a das suas partes.
the-symbol-in-the-worked-solution-left-out-q-and-a-number = O símbolo na resolução; omitido, Q e um número.
the-name-in-files-and-on-the-command-line-left-out-made-from-the-words = O nome em arquivos e na linha de comando; omitido, formado a partir das palavras.
takes-its-value-from-a-formula-so-it-cannot-be-varied-vary-its-definitions = recebe o valor de uma fórmula, por isso não pode ser variado; varie as suas definições
a-name-is-needed-for-example-nu = é necessário um nome, por exemplo nu
a-name-is-needed-for-example-peak-to-peak = é necessário um nome, por exemplo pico a pico
a-quantity-or-a-formula-in-quotes-is-needed-here = aqui é necessária uma grandeza ou uma fórmula entre aspas
a-formula-is-needed-here-as-in-2-x = aqui é necessária uma fórmula, como em "2*X"

## Unknowns
given-answers-and-those-of-the-fit = Resultados dados e os do ajuste
solutions-in-the-range-searched = Soluções no intervalo pesquisado
key-is-a-table-of-names-and-formulas-as-in-key-example = `{ $key }` é uma tabela de nomes e fórmulas, como em [{ $key }] { $example }
more-unknowns-unknowns-than-given-answers-givens-give-another-answer-as-in-given-natural-frequency-8 = mais incógnitas ({ $unknowns }) que resultados dados ({ $givens }): dê outro resultado, como em [given] natural_frequency = "8.2 Hz", ou digite um valor aqui
no-solution-in-the-ranges-searched-the-nearest-reached-with-at-write-other-ranges-as-in-1-kg-100-kg = nenhuma solução nos intervalos pesquisados; a mais próxima: { $reached }, com { $at }; escreva outros intervalos, como em ? 1 kg .. 100 kg
no-value-in-the-range-of-the-unknowns-is-permitted-with-these-inputs = nenhum valor no intervalo das incógnitas é permitido com estes dados
no-input-from-from-to-to-gives-answer-given-the-answer-lies-between-least-at-at-least-and-most-at-at = nenhum valor de { $input } de { $from } a { $to } dá { $answer } = { $given }: o resultado fica entre { $least } (em { $at_least }) e { $most } (em { $at_most })
no-input-from-from-to-to-gives-answer-given-the-problem-has-no-answer-there = nenhum valor de { $input } de { $from } a { $to } dá { $answer } = { $given }: o problema não tem solução ali
only-a-quantity-can-be-unknown-enter-a-value-here = só uma grandeza pode ser incógnita: digite um valor aqui
the-given-answers-do-not-determine-unknowns-separately-many-values-give-the-same-answers-give-another = os resultados dados não determinam { $unknowns } separadamente: muitos valores dão os mesmos resultados; dê outro resultado
the-problem-has-no-answer-at-any-of-the-starts-of-the-search-write-narrower-ranges-as-in-1-kg-100-kg = o problema não tem solução em nenhum dos pontos de partida da busca: escreva intervalos menores, como em ? 1 kg .. 100 kg
the-range-of-an-unknown-ascends-as-in-1-kg-100-kg = o intervalo de uma incógnita é crescente, como em ? 1 kg .. 100 kg
the-uncertainty-behind-is-above-zero = a incerteza depois de ± é maior que zero
no-answer-name-with-a-single-number-the-answers-are-known = nenhum resultado `{ $name }` com um único número; os resultados são { $known }
answer-does-not-depend-on-what-is-unknown-give-another-answer = { $answer } não depende das incógnitas: dê outro resultado
answer-is-the-given-one = { $answer } é o valor dado
count-solutions-in-the-range-searched-solutions-the-first-is-worked-out-a-narrower-range-as-in-1-kg = { $count } soluções no intervalo pesquisado: { $solutions }; a resolução é a da primeira; um intervalo menor, como em ? 1 kg .. 100 kg, escolhe outra
unknown-is-unknown-found-from-givens-solutions-from-from-to-to-at-points-points-count = { $unknown } é incógnita: obtida de { $givens }; soluções de { $from } a { $to }, em { $points } pontos: { $count }
unknown-is-unknown-found-from-givens-solutions-from-from-to-to-from-points-starts-count = { $unknown } é incógnita: obtida de { $givens }; soluções de { $from } a { $to }, a partir de { $points } pontos: { $count }
unknown-is-unknown-its-formula-follows-from-givens-all-solutions-from-from-to-to-count = { $unknown } é incógnita: sua fórmula resulta de { $givens }; todas as soluções de { $from } a { $to }: { $count }
unknown-is-unknown-its-formula-follows-from-givens-all-solutions-from-from-to-to-with-branches-count = { $unknown } é incógnita: sua fórmula resulta de { $givens }; todas as soluções de { $from } a { $to }, com { $branches }: { $count }
unknown-by-its-formula-is-the-solution-of-the-search = { $unknown } pela fórmula é a solução da busca
both-signs-of-the-root = os dois sinais da raiz
both-signs-of-the-absolute-value = os dois sinais do valor absoluto
the-angles-of-the-arcsine = os ângulos do arco seno
the-angles-of-the-arccosine = os ângulos do arco cosseno
the-angles-of-the-arctangent = os ângulos do arco tangente
unknown-is-unknown-least-squares-of-givens = { $unknown } é incógnita: mínimos quadrados de { $givens }
given-answers = Resultados dados
known-values-of-answers-from-which-inputs-written-as-are-found-natural-frequency-8-2-hz = Valores conhecidos de resultados, dos quais se obtêm os dados escritos como ?: natural_frequency = 8.2 Hz.
the-name-of-an-answer-or-a-question-natural-frequency = O nome de um resultado ou de uma pergunta: natural_frequency.
n-8-2-hz-with-its-standard-uncertainty-8-2-hz-0-05 = 8.2 Hz; com a incerteza-padrão, 8.2 Hz ± 0.05.
a-quantity-in-quotes-is-needed-here-as-in-8-2-hz = aqui é necessária uma grandeza entre aspas, como em "8.2 Hz"
the-name-of-an-answer-or-a-question-is-needed-for-example-natural-frequency = falta o nome de um resultado ou de uma pergunta, por exemplo natural_frequency
write-a-range-as-in-1-kg-100-kg-it-gives-the-unit = escreva um intervalo, como em ? 1 kg .. 100 kg: ele dá a unidade
nothing-is-unknown-write-in-the-input-that-is-to-be-found-from-it = não há incógnita: escreva ? no dado que se quer obter dele
write-a-range-to-search-as-in-1-kg-100-kg = escreva um intervalo de busca, como em ? 1 kg .. 100 kg
this-input-cannot-be-varied-so-it-cannot-be-unknown = este dado não pode ser variado, por isso não pode ser incógnita
value-of-the-fit = valor do ajuste
given-value = valor dado
residual = resíduo
answer = Resposta
shown-quantity = { $shown_quantity }

## Inputs in words, and the file that a problem begins with
a-whole-number-from-min = um número inteiro a partir de { $min }
a-whole-number-from-min-to-max = um número inteiro de { $min } a { $max }
above-limit = acima de { $limit }
at-least-limit = no mínimo { $limit }
at-most-limit = no máximo { $limit }
below-limit = abaixo de { $limit }
one-of = uma de
or-nothing = ou nada
default-default = padrão { $default }
the-name-of-one-of-list = o nome de um de { $list }
these = estes
words = palavras
yes-or-no = sim ou não
rows-at-most-most = linhas, no máximo { $most }
rows-min-to-most = linhas, de { $min } a { $most }
len-components-what-written-form = { $len } componentes, { $what }, na forma { $form }
a-table-as-lines-of-text-under-the-heading-heading-or-as-rows-form-with-the-columns = uma tabela, como linhas de texto sob o cabeçalho "{ $heading }" ou como linhas { $form }, com as colunas
write-each-value-between-its-quotation-marks-with-its-unit-what-stands-behind-a-single-may-be-left = Escreva cada valor entre as aspas, com a unidade. O que está depois de um único # pode ser omitido.
let-has-quantities-of-your-own-for-formulas-ask-questions-of-your-own-given-known-answers-from-which = [let] tem grandezas próprias para fórmulas, [ask] perguntas próprias, [given] resultados conhecidos dos quais se obtêm os dados escritos como ?, [configuration.NOME] o mesmo problema com alguns dados alterados, [show] unidades das respostas; units = "in-lbf-s" acima de [inputs] mostra tudo em um só sistema.
a-table-of-inputs-is-needed-here-written-form = aqui é necessária uma tabela de dados, na forma { $form }
a-list-is-needed-here-written-form = aqui é necessária uma lista, na forma { $form }
one-value-is-needed-here-written-form = aqui é necessário um único valor, na forma { $form }
holds-several-inputs-name-one-of-them-known = contém vários dados; nomeie um deles: { $known }
is-in-a-list-name-a-row-as-in-row = está em uma lista; nomeie uma linha, como em { $row }
is-a-list-name-a-row-as-in-row = é uma lista; nomeie uma linha, como em { $row }
there-is-no-such-input-what-it-would-be-part-of-is-one-value = não há tal dado: aquilo de que faria parte é um único valor
path-text-read-as-full = { $path } = { $text }: lido como { $full }
default-that-of-the-problem-else-default-or-customary-among-us-customary-units = padrão: a do problema, senão { $default }, ou { $customary } entre unidades inglesas

## Usual questions
peak-to-peak-displacement = Deslocamento pico a pico
root-mean-square-of-the-displacement = Valor eficaz do deslocamento
amplitude-of-the-velocity = Amplitude da velocidade
root-mean-square-of-the-velocity = Valor eficaz da velocidade
amplitude-of-the-acceleration = Amplitude da aceleração
amplitude-of-the-inertia-force = Amplitude da força de inércia
amplitude-of-the-spring-force = Amplitude da força na mola
amplitude-of-the-damper-force = Amplitude da força no amortecedor
energy-dissipated-per-cycle = Energia dissipada por ciclo
mean-power-dissipated = Potência média dissipada
energy-dissipated-per-cycle-by-friction = Energia dissipada por ciclo pelo atrito
maximum-energy-of-the-spring = Energia máxima da mola
maximum-kinetic-energy = Energia cinética máxima
static-displacement-under-the-amplitude-of-the-force = Deslocamento estático sob a amplitude da força
magnification-factor = Fator de amplificação
transmissibility-of-the-force = Transmissibilidade da força
amplitude-of-the-unbalance-force = Amplitude da força de desbalanceamento
transmissibility-of-the-unbalance-force = Transmissibilidade da força de desbalanceamento
transmitted-force-on-each-mount = Força transmitida em cada apoio
transmitted-force-on-each-of-four-mounts = Força transmitida em cada um de quatro apoios
force-on-each-of-two-bearings = Força em cada um de dois mancais
mean-stress-due-to-the-transmitted-force-section-of-100-mm = Tensão média devida à força transmitida, seção de 100 mm²
bending-moment-at-the-clamp = Momento fletor no engaste
bending-stress-at-the-clamp-section-modulus-of-10-cm = Tensão de flexão no engaste, módulo de resistência de 10 cm³
period-of-the-natural-vibration = Período da vibração natural
period-of-the-transverse-vibration = Período da vibração transversal
period-of-the-first-mode = Período do primeiro modo
ratio-of-the-second-natural-frequency-to-the-first = Razão entre a segunda e a primeira frequências naturais
period-of-the-small-oscillations = Período das pequenas oscilações
damped-natural-frequency = Frequência natural amortecida
logarithmic-decrement = Decremento logarítmico
quality-factor = Fator de qualidade
time-constant-of-the-decay = Constante de tempo do decaimento
critical-damping = Amortecimento crítico
critical-torsional-damping = Amortecimento crítico torcional
compliance = Flexibilidade
weight = Peso
static-deflection-under-the-weight = Deflexão estática sob o peso
kinetic-energy-at-that-time = Energia cinética nesse instante
energy-of-the-spring-at-that-time = Energia da mola nesse instante
equivalent-static-force = Força estática equivalente
maximum-force-over-the-weight = Força máxima sobre o peso
maximum-deceleration-over-gravity = Desaceleração máxima sobre a gravidade
kinetic-energy-before-the-shock = Energia cinética antes do choque
maximum-strain = Deformação máxima
equivalent-static-force-on-a-mass-of-1-kg = Força estática equivalente em uma massa de 1 kg
n-3-velocity = Velocidade 3σ
root-mean-square-of-the-spring-force = Valor eficaz da força na mola
n-3-force-on-the-support = Força 3σ no apoio
crest-factor-of-the-displacement = Fator de crista do deslocamento
natural-frequency-of-the-absorber = Frequência natural do absorvedor
amplitude-of-the-force-in-the-absorber-s-spring = Amplitude da força na mola do absorvedor
frequency = Frequência
maximum-speed-of-the-bob = Velocidade máxima da massa do pêndulo
maximum-acceleration = Aceleração máxima
first-critical-speed-over-running-speed = Primeira velocidade crítica sobre a rotação de operação
clearance-left-at-the-maximum-amplitude = Folga restante na amplitude máxima
centrifugal-force-of-the-correction-at-this-speed = Força centrífuga da correção nesta rotação
centrifugal-force-of-the-correction-at-1000-rpm = Força centrífuga da correção a 1000 rpm
centrifugal-force-of-the-second-correction-at-this-speed = Força centrífuga da segunda correção nesta rotação
centrifugal-force-of-the-second-correction-at-1000-rpm = Força centrífuga da segunda correção a 1000 rpm
rotating-force-of-the-permissible-unbalance-at-bearing-a = Força rotativa do desbalanceamento admissível no mancal A
rotating-force-of-the-permissible-unbalance-at-bearing-b = Força rotativa do desbalanceamento admissível no mancal B
shaking-moment-after-over-before = Momento de agitação depois sobre antes
secondary-force-over-primary-force = Força secundária sobre força primária
range-of-the-wheel-load = Faixa de variação da carga na roda
angular-momentum-of-the-rotation = Quantidade de movimento angular da rotação
kinetic-energy-of-the-rotation = Energia cinética da rotação
force-of-the-couple-on-two-bearings-1-m-apart = Força do binário em dois mancais a 1 m um do outro
time-of-one-revolution = Tempo de uma volta
centripetal-acceleration = Aceleração centrípeta
kinetic-energy-of-the-translation = Energia cinética da translação
kinetic-energy-after-over-before = Energia cinética depois sobre antes
share-of-the-rotation-in-the-kinetic-energy = Parcela da rotação na energia cinética
moment-of-inertia-about-the-centre-of-mass = Momento de inércia em relação ao centro de massa
instantaneous-power-at-the-crank = Potência instantânea na manivela
instantaneous-power-of-the-first-driver = Potência instantânea do primeiro acionamento
maximum-over-mean-turning-moment = Momento de torção máximo sobre o médio
mean-shear-stress-in-a-pin-of-10-mm-diameter-double-shear = Tensão média de cisalhamento em um pino de 10 mm de diâmetro, corte duplo
mean-stress-in-a-section-of-100-mm = Tensão média em uma seção de 100 mm²
pressure-in-a-cylinder-of-50-mm-bore = Pressão em um cilindro de 50 mm de diâmetro
holding-torque-over-driving-torque = Torque de retenção sobre torque motor
speed-at-the-radius-of-gyration = Velocidade no raio de giração
hoop-stress-of-a-thin-steel-rim-of-that-radius = Tensão circunferencial em um aro fino de aço desse raio
energy-fluctuation-over-kinetic-energy = Flutuação de energia sobre energia cinética
amplitude-over-the-ratio-of-unbalance-to-mass = Amplitude sobre a razão entre desbalanceamento e massa
mass-with-this-weight = Massa com esse peso

## Families
balancing = Balanceamento
rigid-bodies = Corpos rígidos
vibration = Vibrações
virtual-work = Trabalho virtual

## Units of a problem
units-system = Unidades: { $system }
units-system-found-from-the-inputs = Unidades: { $system }, reconhecidas nos dados
text-is-no-system-of-units-write-one-of-known = `{ $text }` não é um sistema de unidades; escreva um de { $known }
name-is-changed-twice-keep-one-of-the-two = `{ $name }` é alterado duas vezes: mantenha um dos dois
name-is-no-name-of-a-problem-write-letters-digits-and-a-letter-first = `{ $name }` não é nome de problema: escreva letras, algarismos e _, começando por uma letra
name-is-the-name-of-a-problem-or-a-configuration-choose-another = `{ $name }` é o nome de um problema ou de uma configuração: escolha outro
name-is-the-name-of-a-problem-choose-another = `{ $name }` é o nome de um problema: escolha outro
problem-has-no-answer-name-with-these-inputs-did-you-mean-near = `{ $problem }` não tem a resposta `{ $name }` com estes dados; seria `{ $near }`?
problem-has-no-answer-name-with-these-inputs-it-has-known = `{ $problem }` não tem a resposta `{ $name }` com estes dados; tem { $known }
a-configuration-is-a-table-of-changed-inputs-as-in-configuration-name = uma configuração é uma tabela de dados alterados, como em [configuration.{ $name }]
linked-file-file-sha-256-digest = arquivo vinculado { $file }, SHA-256 { $digest }
linked-file-file-as-it-is-open-with-unsaved-changes-sha-256-digest = arquivo vinculado { $file } como está aberto, com alterações não salvas, SHA-256 { $digest }
linked-problems-are-solved-one-by-one = problemas vinculados são resolvidos um a um
more-than-most-files-are-linked-behind-one-another = há mais de { $most } arquivos vinculados em sequência
problem-name-a-table-with-an-analysis-is-needed-as-in-problem-name = problem.{ $name }: é necessária uma tabela com uma análise, como em [problem.{ $name }]
problem-name-why = problem.{ $name }: { $why }
the-files-link-to-each-other-in-a-circle-circle = os arquivos se vinculam em círculo: { $circle }
the-name-of-an-answer = o nome de uma resposta
input-from-name = { $input }, de { $name }
linked-problems = Problemas vinculados
several-problems-that-feed-each-other = Vários problemas em que as respostas de uns são dados de outros.
exam-questions = Questões de prova
several-steps = Várias etapas
no-other-file-can-be-read-here = nenhum outro arquivo pode ser lido aqui
the-file-is-larger-than-1-mib-it-is-no-problem-file = o arquivo tem mais de 1 MiB: não é um arquivo de problema
this-is-no-problem-file-only-problem-files-can-be-linked = este não é um arquivo de problema: só arquivos de problema podem ser vinculados
problem-holds-named-problems-as-in-problem-fan = `problem` contém problemas com nome, como em [problem.fan]
a-link-names-a-file-and-an-answer-of-it-as-in-beam-toml-stiffness = um vínculo indica um arquivo e uma resposta dele, como em @viga.toml:stiffness
a-name-of-letters-and-digits-is-needed-for-example-weighted = é necessário um nome de letras e algarismos, por exemplo carregado
configurations = Configurações
the-same-problem-with-some-inputs-changed-answered-beside-it-weighted-mass-m-2-kg = O mesmo problema com alguns dados alterados, respondido ao lado dele: carregado, mass = m + 2 kg.
configuration = Configuração
a-name-of-your-own-weighted = Um nome à sua escolha: carregado.
input = Dado de entrada
file-note = { $file }: { $note }
a-configuration-and-an-input-are-needed-as-in-weighted-mass = são necessários uma configuração e um dado, como em carregado.mass
name-is-the-name-of-an-input-give-the-linked-problem-another-name = `{ $name }` é o nome de um dado: dê outro nome ao problema vinculado
two-linked-problems-are-called-name-give-one-of-them-another-name = dois problemas vinculados se chamam `{ $name }`: dê outro nome a um deles
the-linked-file-is-not-read-yet-save-this-problem-beside-it = o arquivo vinculado ainda não foi lido: salve este problema ao lado dele
all-problems = Todos os problemas
there-is-no-name-here-no-input-definition-answer-or-step-has-that-name-or-symbol-dalembert-show-lists = não há `{ $name }` aqui: nenhum dado, definição, resultado ou passo tem esse nome ou símbolo; `dalembert show` lista os dos dados e resultados, a Resolução os dos passos
name-is-neither-an-input-nor-a-definition-and-no-answer-of-this-problem-is-known-before-its-inputs-to = `{ $name }` não é um dado nem uma definição, e nenhum resultado deste problema é conhecido antes dos seus dados; para obter um dado a partir de um resultado, escreva ? no dado e o resultado em [given]
list-has-count-elements-counted-from-1 = `{ $list }` tem { $count } elementos, contados a partir de 1
a-row-of-names-without-a-number-is-a-heading-but-these-are-definitions-write-1-first-for-its-value-or = uma linha só de nomes, sem números, é um cabeçalho, mas estes são definições: escreva 1*{ $first } para o valor, ou as unidades do cabeçalho depois dos nomes
there-is-no-name-here-did-you-mean-near-dalembert-show-lists-the-names-of-inputs-and-answers-the = não há `{ $name }` aqui; seria { $near }? `dalembert show` lista os nomes dos dados e resultados, a Resolução os dos passos
name-a-cell-of-the-table-as-in-example = indique uma célula da tabela, como em { $example }
is-chosen-already-change-the-inputs-in-it = já está escolhida: altere os dados dentro dela
only-an-input-of-the-problem-itself-can-be-unknown-enter-a-value-here = só um dado do próprio problema pode ser incógnita: digite um valor aqui
only-an-input-of-a-problem-can-be-unknown = só um dado de um problema pode ser incógnita
a-choice-cannot-be-unknown-write-one-of-known = uma escolha não pode ser incógnita: escreva uma de { $known }
an-unknown-is-a-component-of-a-vector-as-in-0-3-m-s = uma incógnita é um componente do vetor, como em (?; 0; 3) m/s
an-unknown-component-stands-alone-write-and-the-sign-will-be-found = um componente incógnito fica sozinho: escreva `+ ?` e o sinal será encontrado
name-the-unknown-components-of-a-vector-as-in-0-3-m-s = indique os componentes incógnitos do vetor, como em (?; 0; 3) m/s
input-with-the-components-found = { $input }, com os componentes encontrados
the-path-of-the-input-that-differs-mass-masses-3-radius-a-choice = O caminho do dado que difere: mass, masses[3].radius, uma escolha.
n-12-kg-or-m-2-kg-over-the-inputs-and-definitions-of-the-problem-an-alternative-by-its-name = 12 kg, ou m + 2 kg com os dados e as definições do problema; uma alternativa pelo nome.

## Studies
name-an-input-that-varies-a-table-vary-with-input-and-values-or-from-to-and-points = indique um dado que varia: uma tabela [[vary]] com input e values, ou from, to e points
input-varies-twice-name-it-once = { $input } varia duas vezes; indique-o uma só vez
samples-are-drawn-of-inputs-that-have-a-distribution-and-none-has-one-leave-it-out = sorteiam-se amostras dos dados que têm distribuição, e nenhum tem; omita este valor
write-a-whole-number-from-1-on = escreva um número inteiro a partir de 1
write-a-whole-number-from-2-on = escreva um número inteiro a partir de 2
the-sobol-sequence-serves-up-to-most-inputs-and-have-are-drawn-use-latin-hypercube = a sequência de Sobol' serve para até { $most } dados, e { $have } são sorteados; use latin-hypercube
the-sobol-sequence-has-most-points-write-at-most-so-many-samples = a sequência de Sobol' tem { $most } pontos; escreva no máximo esse número de amostras
sobol-indices-want-a-distribution-of-every-input-that-varies-give-input-one-or-leave-it-at-its-value = os índices de Sobol' exigem uma distribuição de cada dado que varia; dê uma a { $input }, ou deixe-o no valor do problema
sobol-indices-are-shares-of-independent-inputs-take-the-correlations-out-of-the-plan-or-leave-the-indices-out = os índices de Sobol' são parcelas de dados independentes; retire do plano as correlações ou os índices
name-does-not-vary-in-this-plan-known-vary = `{ $name }` não varia neste plano; variam { $known }
write-two-different-inputs = escreva dois dados diferentes
sizes-points-are-more-than-most-write-fewer-points-or-samples = { $sizes } pontos são mais que { $most }; escreva menos pontos ou amostras
name-is-not-an-input-with-a-distribution-in-this-plan = `{ $name }` não é um dado com distribuição neste plano
write-two-different-inputs-and-a-coefficient-between-1-and-1 = escreva dois dados diferentes e um coeficiente entre -1 e 1
these-correlations-contradict-one-another-their-matrix-is-not-positive-definite = estas correlações se contradizem: sua matriz não é positiva definida
write-one-of-values-from-to-and-points-distribution-table = escreva uma destas formas: values; from, to e points; distribution; table
the-list-is-empty-write-at-least-one-value = a lista está vazia; escreva pelo menos um valor
does-not-belong-here-this-way-takes-takes = não pertence a esta forma, que aceita { $takes }
name-the-input-that-varies = indique o dado que varia
name-is-not-a-number-among-the-inputs-did-you-mean-near = `{ $name }` não é um número entre os dados; quis dizer `{ $near }`?
name-is-not-a-number-among-the-inputs-known = `{ $name }` não é um número entre os dados: { $known }
file-has-no-rows = { $file } não tem linhas
is-missing-for-this-distribution = falta para esta distribuição
is-missing-for-this-range = falta para este intervalo
must-be-above-zero = deve ser maior que zero
from-must-be-below-to = `from` deve ser menor que `to`
from-mode-and-to-must-ascend-and-from-be-below-to = `from`, `mode` e `to` devem ser crescentes, com `from` menor que `to`
the-mean-of-a-lognormal-distribution-must-be-above-zero = a média de uma distribuição lognormal deve ser maior que zero
mean-and-deviation-must-be-finite = a média e o desvio-padrão devem ser finitos
at-least-two-values-are-needed-to-draw-from = são necessários pelo menos dois valores para o sorteio
name-the-csv-file-of-the-measured-values = indique o arquivo CSV dos valores medidos
file-has-no-column-name-it-has-known = { $file } não tem a coluna `{ $name }`; tem { $known }
a-logarithmic-range-lies-above-zero-write-other-ends-or-scale-linear = um intervalo logarítmico fica acima de zero; escreva outros extremos ou scale = "linear"
is-not-a-finite-number = não é um número finito
unit-is-no-unit-of-input-which-is-in-own = `{ $unit }` não é unidade de `{ $input }`, que está em { $own }
this-problem-has-no-answer-that-is-a-number = este problema não tem resultado numérico
write-above-or-below-as-in-above-0-5-mm = escreva above ou below, como em above = "0.5 mm"
input-why = { $input }: { $why }
the-condition-is-not-met-answer-above-limit = a condição não é satisfeita: { $answer } acima de { $limit }
the-condition-is-not-met-answer-below-limit = a condição não é satisfeita: { $answer } abaixo de { $limit }
name-is-not-a-number-among-the-answers-did-you-mean-near = `{ $name }` não é um número entre os resultados; quis dizer `{ $near }`?
name-is-not-a-number-among-the-answers-known = `{ $name }` não é um número entre os resultados: { $known }
an-input-has-no-value = um dado não tem valor

## Optima and tolerances
optima-and-choices-the-best-first = Ótimos e opções, o melhor primeiro
pareto-front = Frente de Pareto
pareto-front-the-working-is-that-of-the-compromise-nearest-to-the-best-of-both = Frente de Pareto; a resolução é a do compromisso mais próximo do melhor de ambos
worst-case-the-answers-at-all-ends-of-the-tolerances = Pior caso: os resultados em todos os extremos das tolerâncias
worst-case-the-answers-at-all-ends-of-the-tolerances-refused-of-count-have-none = Pior caso: os resultados em todos os extremos das tolerâncias; { $refused } de { $count } não têm resultado
text-the-first-argument-is-the-number-of-one-of-the-others-from-1-to-count = `{ $text }`: o primeiro argumento é o número de um dos outros, de 1 a { $count }
a-limit-has-no-uncertainty-write-its-value-alone = um limite não tem incerteza: escreva só o valor
a-search-without-derivatives-finds-no-better-answer = uma busca sem derivadas não encontra valor melhor de { $answer }
no-values-of-the-unknowns-in-their-ranges-meet-every-requirement-the-nearest-limits-with-at = nenhum valor das incógnitas em suas faixas atende a todos os requisitos; o mais próximo: { $limits }, com { $at }
the-tolerance-behind-is-above-zero-as-in-40-kg-2 = a tolerância depois de ± é maior que zero, como em 40 kg ± 2 %
worked-out = resolvido
answer-as-large-as-possible = { $answer }: o maior possível
answer-as-small-as-possible = { $answer }: o menor possível
count-combinations-of-choices-at-most-most-are-tried-leave-some-out = { $count } combinações de opções: no máximo { $most } são testadas; retire algumas
count-tolerances-the-worst-case-is-found-of-at-most-most = { $count } tolerâncias: o pior caso é obtido com no máximo { $most }
limit-found-found = { $limit } (obtido: { $found })
unknown-has-no-influence-on-the-answers-that-something-is-required-of = { $unknown } não influi nos resultados dos quais algo é exigido
unknown-is-unknown-the-best-choice-for-givens = { $unknown } é incógnita: a melhor opção para { $givens }
unknown-is-unknown-the-compromise-nearest-to-the-best-of-both-on-the-pareto-front-from-from-to-to-for = { $unknown } é incógnita: o compromisso mais próximo do melhor de ambos na frente de Pareto, de { $from } a { $to }, para { $givens }
unknown-is-unknown-the-optimum-from-from-to-to-for-givens-ended-of-points-local-searches-end-here = { $unknown } é incógnita: o ótimo de { $from } a { $to } para { $givens }; { $ended } de { $points } buscas locais terminam aqui
unknown-lies-at-the-end-of-its-range-end-beyond-it-may-be-a-better-value = { $unknown } está no extremo de sua faixa, { $end }: além dele pode haver um valor melhor
answer-value = { $answer } ≤ { $value }
requirements = requisitos
met = atendidos
not-met = não atendidos
nominal = nominal
least = menor
largest = maior
this-input-cannot-be-varied-so-it-has-no-tolerance = este dado não pode ser variado e por isso não tem tolerância
a-limit-alone-determines-nothing-write-minimum-or-maximum-at-the-answer-that-is-to-be-least-or = um limite sozinho não determina nada: escreva minimum ou maximum no resultado que deve ser o menor ou o maior possível
a-choice-needs-an-answer-that-is-to-be-least-or-largest-as-in-given-amplitude-minimum = uma escolha precisa de um resultado que deve ser o menor ou o maior possível, como em [given] amplitude = "minimum"
at-most-two-answers-can-be-the-least-or-the-largest-give-a-limit-here-as-in-100-mpa = no máximo dois resultados podem ser o menor ou o maior possível: dê um limite aqui, como em < 100 MPa
n-8-2-hz-with-its-standard-uncertainty-8-2-hz-0-05-for-an-optimum-minimum-or-maximum-and-limits-100 = 8.2 Hz; com a incerteza-padrão, 8.2 Hz ± 0.05; para um ótimo, minimum ou maximum, e limites, < 100 MPa.
known-values-of-answers-or-requirements-from-which-inputs-written-as-are-found-natural-frequency-8-2 = Valores conhecidos de resultados, ou requisitos, dos quais se obtêm os dados escritos como ?: natural_frequency = 8.2 Hz.
optimum = Ótimo
the-inputs-with-which-an-answer-is-as-small-or-as-large-as-possible-under-limits-of-others = Os dados com os quais um resultado é o menor ou o maior possível, sob limites de outros.
value-or-requirement = Valor ou requisito

# Onde o problema está em um gráfico
at-value = em { $value }
curve-at-value = { $curve } em { $value }

# Curvas e estatísticas de estudos
the-problem-has-other-answers-there = ali o problema tem outros resultados
the-first-drawn-of-all-curves-are-drawn = são desenhadas as { $drawn } primeiras de { $all } curvas
one-other = { $one }, { $other }
quartiles-first-median-third = quartis { $first }, { $median }, { $third }
skewness-skewness-excess-kurtosis-kurtosis = assimetria { $skewness }, excesso de curtose { $kurtosis }
minimum-least-maximum-largest = mínimo { $least }, máximo { $largest }
above-limit-share-95-interval-low-to-high = acima de { $limit }: { $share }, intervalo de 95 % de { $low } a { $high }
below-limit-share-95-interval-low-to-high = abaixo de { $limit }: { $share }, intervalo de 95 % de { $low } a { $high }
mean = média
n-2-5 = 2,5 %
n-97-5 = 97,5 %
this-answer-is-not-a-scalar = esta resposta não é um escalar
write-the-statement-as-a-text-in-quotes = escreva o enunciado como um texto entre aspas
asked-needs-a-statement = `asked` precisa de um `statement`
write-the-answers-that-the-statement-asks-for-as-in-asked-amplitude = escreva as respostas que o enunciado pede como em `asked = ["amplitude"]`
write-the-range-of-path-as-in-mass-30-kg-60-kg-5-kg = escreva a faixa de { $path } como em `mass = "30 kg .. 60 kg : 5 kg"`

# Hints on an answer.
principle = Princípio
formulas = Fórmulas
numbers = Números
given-path = dado: { $path }
