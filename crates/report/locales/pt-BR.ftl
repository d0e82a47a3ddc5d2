# What reports say beside the words of an analysis.

answers = Respostas
checks = Verificações
count-rows = { $count } linhas
faults-of-the-program = Falhas do programa
internal-errors = Erros internos do programa
given-data = Dados
none-of-the-answers-of-name-can-be-shown-in-unit-found = nenhuma das respostas de `{ $name }` pode ser mostrada em { $unit }: { $found }
name-cannot-be-shown-in-unit-hint = { $name } não pode ser mostrado em { $unit }; { $hint }
name-cannot-be-shown-in-unit-write-a-unit-like-own = { $name } não pode ser mostrado em { $unit }; escreva uma unidade como { $own }
no = não
no-answer = Sem resposta
sources = Fontes
no-answer-name-did-you-mean-near = não há resposta `{ $name }`; seria `{ $near }`?
no-answer-name-use-one-of-known = não há resposta `{ $name }`; use uma de { $known }
warnings = Avisos
what-failed-relative-difference-gap-limit-limit = { $what }: FALHOU, diferença relativa { $gap }, limite { $limit }
what-relative-difference-gap = { $what }: diferença relativa { $gap }
what-relative-difference-gap-within-rounding-up-to-limit = { $what }: diferença relativa { $gap }, dentro do arredondamento (até { $limit })
working = Resolução
yes = sim
db-over-1-unit = dB sobre 1 { $unit }
curve-at-the-cursor = { $curve } no cursor
value-default = { $value } (padrão)
how-the-data-were-read = Como os dados foram lidos
before = antes
