analysis-name = Analysis name
topic-of-it = Topic of it
natural-frequency-period-and-maximum-speed-of-a-mass-on-a-spring-released-from-rest = Frequência natural, período e velocidade máxima de uma massa numa mola, solta do repouso.
mass = Massa
stiffness-of-the-spring = Rigidez da mola
deflection-at-the-start = Deslocamento inicial
from-the-rest-position-the-mass-is-released-without-initial-velocity = A partir da posição de repouso; a massa é solta sem velocidade inicial.
natural-frequency-without-damping = Frequência natural sem amortecimento
period-of-one-oscillation = Período de uma oscilação
maximum-speed-at-the-rest-position = Velocidade máxima, na posição de repouso
the-energy-of-the-motion-is-that-of-the-deflected-spring = a energia do movimento é a da mola deformada
natural-frequency = Frequência natural
period = Período
maximum-speed = Velocidade máxima
period-against-mass = Período em função da massa
the-mass-on-its-spring = A massa na mola
n-2-kg-on-800-n-m = 2 kg em 800 N/m
by-hand-800-2-20 = À mão: √(800/2) = 20
