analysis-name = Analysis name
free-vibration = Vibração livre
natural-frequency-period-and-greatest-speed-of-a-mass-on-a-spring-that-is-let-go = Frequência natural, período e maior velocidade de uma massa numa mola que é solta.
mass = Massa
stiffness-of-the-spring = Rigidez da mola
deflection-at-the-start = Deslocamento inicial
from-the-position-of-rest-the-mass-is-let-go-without-a-push = A partir da posição de repouso; a massa é solta sem impulso.
natural-frequency-without-damping = Frequência natural sem amortecimento
period-of-one-oscillation = Período de uma oscilação
greatest-speed-at-the-position-of-rest = Maior velocidade, na posição de repouso
the-energy-of-the-motion-is-that-of-the-deflected-spring = a energia do movimento é a da mola deformada
natural-frequency = Frequência natural
period = Período
greatest-speed = Maior velocidade
period-against-mass = Período em função da massa
the-mass-on-its-spring = A massa na mola
n-2-kg-on-800-n-m = 2 kg em 800 N/m
by-hand-800-2-20 = À mão: √(800/2) = 20
