# Balanceamento em dois planos
balancing-in-two-planes = Balanceamento em dois planos
the-corrections-in-two-planes-that-leave-a-rigid-rotor-with-neither-a-rotating-force-nor-a-rotating = As correções em dois planos que deixam um rotor rígido sem força nem conjugado girantes.

## Inputs
eccentric-masses = Massas excêntricas
position-of-plane-a = Posição do plano A
along-the-shaft-from-the-same-origin-as-the-masses = Ao longo do eixo, a partir da mesma origem das massas.
position-of-plane-b = Posição do plano B
correction-in-plane-a = Correção no plano A
correction-in-plane-b = Correção no plano B
way-of-correcting = Modo de corrigir
gravity = Gravidade
only-turns-masses-into-weights-the-balance-does-not-depend-on-it = Só transforma massas em pesos; o balanceamento não depende dela.
speed = Velocidade
for-the-force-and-the-couple-before-balancing = Para a força e o conjugado antes do balanceamento.
mass = Massa
radius = Raio
angle = Ângulo
counter-clockwise-from-a-mark-on-the-rotor = Anti-horário, a partir de uma marca no rotor.
position = Posição
along-the-shaft-from-any-origin = Ao longo do eixo, a partir de qualquer origem.
radius-given-mass-wanted = Raio dado, massa procurada
mass-given-radius-wanted = Massa dada, raio procurado
mass-is-added = Acrescenta-se massa
mass-is-removed-by-drilling = Retira-se massa por furação

## Steps
unbalance-of-each-mass-along-x = Desbalanceamento de cada massa ao longo de x
unbalance-of-each-mass-along-y = Desbalanceamento de cada massa ao longo de y
moments-about-plane-a-vanish = Os momentos em relação ao plano A se anulam
forces-vanish = As forças se anulam
size-of-the-correction = Módulo da correção
mass-at-the-given-radius = Massa no raio dado
radius-of-the-given-mass = Raio da massa dada
angle-where-the-mass-is-added-counter-clockwise-from-the-mark = Ângulo onde se acrescenta a massa, anti-horário a partir da marca
angle-where-the-mass-is-removed-opposite-to-where-it-would-be-added = Ângulo onde se retira a massa, oposto àquele onde seria acrescentada
weight-times-radius-as-textbooks-write-it = Peso vezes raio, como escrevem os livros
weight-of-the-correction = Peso da correção
rotating-force-before-balancing = Força girante antes do balanceamento
rotating-couple-about-plane-a-before-balancing = Conjugado girante em relação ao plano A antes do balanceamento

## Checks
plane-a-from-moments-about-plane-b = plano A a partir dos momentos em relação ao plano B
plane-a-from-both-equations-at-once = plano A a partir das duas equações juntas
plane-b-from-both-equations-at-once = plano B a partir das duas equações juntas
no-force-is-left = não resta força
no-moment-is-left-about-plane-b = não resta momento em relação ao plano B

## Answers
unbalance-of-the-correction-in-plane-a = Desbalanceamento da correção no plano A
unbalance-of-the-correction-in-plane-b = Desbalanceamento da correção no plano B
angle-in-plane-a = Ângulo no plano A
angle-in-plane-b = Ângulo no plano B
mass-in-plane-a = Massa no plano A
mass-in-plane-b = Massa no plano B
radius-in-plane-a = Raio no plano A
radius-in-plane-b = Raio no plano B
weight-in-plane-a = Peso no plano A
weight-in-plane-b = Peso no plano B
weight-times-radius-of-the-masses-together = Peso vezes raio das massas em conjunto
weight-times-radius-in-plane-a = Peso vezes raio no plano A
weight-times-radius-in-plane-b = Peso vezes raio no plano B

## Exhibits, warnings, refusals
masses-and-corrections = Massas e correções
mass-n = massa { $n }
plane-a = plano A
plane-b = plano B
sum = soma
unbalances-and-corrections-along-the-shaft = Desbalanceamentos e correções vistos ao longo do eixo
the-shaft-from-the-side = O eixo visto de lado
the-planes-are-so-close-together-that-a-correction-is-times-times-the-largest-unbalance = os planos estão tão próximos que uma correção é { $times } vezes o maior desbalanceamento
planes-a-and-b-are-the-same-plane-so-no-corrections-there-can-balance-a-couple-give-them-different = os planos A e B são o mesmo plano, portanto nenhuma correção ali equilibra um conjugado; dê-lhes posições diferentes
