# virtual-work/virtual-power
virtual-power = Potência virtual
driving-torque-or-force-of-a-plane-mechanism-with-known-motion-from-the-powers-of-forces-couples = Torque ou força motriz de um mecanismo plano de movimento conhecido, pelas potências de forças, conjugados, pesos e ações de inércia.

# Inputs
unknown = Incógnita
acceleration-of-gravity = Aceleração da gravidade
every-body-weighs-m-g-at-its-mass-centre-zero-for-a-mechanism-in-a-horizontal-plane = Cada corpo pesa m g no centro de massa; zero para um mecanismo em plano horizontal.
bodies = Corpos
forces = Forças
couples = Conjugados
the-mechanism-is-a-slider-crank = O mecanismo é um cursor-manivela
then-the-given-motion-is-held-against-the-closure-of-its-loop = Então o movimento dado é confrontado com o fechamento da cadeia.
driving-torque-on-a-link = Torque motor em uma peça
link-that-it-acts-on = Peça em que atua
driving-force-at-a-point = Força motriz em um ponto
direction-of-the-force = Direção da força
any-vector-along-its-line-the-force-is-positive-this-way = Qualquer vetor na sua linha de ação; a força é positiva nesse sentido.
point-that-it-acts-on = Ponto em que atua
turning-at = Girando com
angular-velocity-of-the-link = Velocidade angular da peça
one-of-the-bodies = Um dos corpos
body = Corpo
moving-at = Movendo-se com
velocity-of-the-point = Velocidade do ponto
mass-centre-of-a-body = Centro de massa de um corpo
name = Nome
mass = Massa
moment-of-inertia-about-the-mass-centre = Momento de inércia em relação ao centro de massa
velocity-of-the-mass-centre = Velocidade do centro de massa
acceleration-of-the-mass-centre = Aceleração do centro de massa
angular-velocity = Velocidade angular
angular-acceleration = Aceleração angular
force = Força
moment = Momento
geometry = Geometria
angular-velocity-of-the-crank = Velocidade angular da manivela
rod = Biela
slider = Cursor
angles-of-crank-and-rod = Ângulos da manivela e da biela
in-line-the-slider-s-line-passes-through-the-bearing-of-the-crank-the-lengths-follow-from-the = Centrado: a linha do cursor passa pelo mancal da manivela. Os comprimentos resultam da velocidade do cursor.
angle-of-the-crank = Ângulo da manivela
angle-of-the-connecting-rod = Ângulo da biela
negative-where-the-rod-falls-towards-the-slider = Negativo quando a biela desce em direção ao cursor.
lengths-and-angle-of-the-crank = Comprimentos e ângulo da manivela
length-of-the-crank = Comprimento da manivela
length-of-the-rod = Comprimento da biela
offset = Excentricidade
height-of-the-slider-s-line-above-the-bearing-of-the-crank = Altura da linha do cursor acima do mancal da manivela.
angular-acceleration-of-the-crank = Aceleração angular da manivela

# Powers
power-of-the-force-name = Potência da força { $name }
power-of-the-couple-name = Potência do conjugado { $name }
weight-of-name = Peso de { $name }
power-of-the-weight-of-name = Potência do peso de { $name }
inertia-force-of-name-against-the-acceleration = Força de inércia de { $name }, contrária à aceleração
power-of-the-inertia-force-of-name = Potência da força de inércia de { $name }
inertia-couple-of-name-against-the-angular-acceleration = Conjugado de inércia de { $name }, contrário à aceleração angular
power-of-the-inertia-couple-of-name = Potência do conjugado de inércia de { $name }
power-of-the-forces = Potência das forças
power-of-the-couples = Potência dos conjugados
power-of-the-weights = Potência dos pesos
power-of-the-inertia-forces = Potência das forças de inércia
power-of-the-inertia-couples = Potência dos conjugados de inércia
power-of-all-known-loads = Potência de todas as ações conhecidas
power-of-the-inertia-force-of-the-rod = Potência da força de inércia da biela
power-of-the-inertia-force-of-the-slider = Potência da força de inércia do cursor

# The unknown
driving-torque = Torque motor
driving-force = Força motriz
driving-torque-with-it-the-sum-of-all-powers-is-zero-t-t-p-0 = Torque motor: com ele a soma de todas as potências é nula, T ω_T + ΣP = 0
unit-vector-along-the-driving-force = Vetor unitário na direção da força motriz
velocity-of-its-point-along-the-driving-force = Velocidade do ponto na direção da força motriz
driving-force-with-it-the-sum-of-all-powers-is-zero-f-v-p-0 = Força motriz: com ela a soma de todas as potências é nula, F v + ΣP = 0
the-power-of-all-applied-loads-is-the-rate-of-the-kinetic-energy = a potência de todas as ações aplicadas é a taxa de variação da energia cinética

# Refusals
there-is-no-load-write-down-a-force-a-couple-or-a-body-with-a-mass = não há nenhuma ação: escreva uma força, um conjugado ou um corpo com massa
the-driven-link-stands-still-its-torque-has-no-power-so-the-sum-of-powers-cannot-tell-it = a peça acionada está parada: seu torque não tem potência, e a soma das potências não pode determiná-lo
the-driven-point-stands-still-its-force-has-no-power-so-the-sum-of-powers-cannot-tell-it = o ponto acionado está parado: sua força não tem potência, e a soma das potências não pode determiná-la
the-direction-of-the-driving-force-has-no-length-write-any-vector-along-its-line-such-as-1-0 = a direção da força motriz tem comprimento nulo: escreva qualquer vetor na sua linha de ação, como (1; 0)
the-driving-force-is-perpendicular-to-the-velocity-of-its-point-it-has-no-power-so-the-sum-of-powers = a força motriz é perpendicular à velocidade do seu ponto: não tem potência, e a soma das potências não pode determiná-la

# Table of powers
powers-of-the-loads = Potências das ações
load = Ação
power = Potência
share-of-the-power-brought-in = Parcela da potência fornecida
total = Total
force-name = Força { $name }
couple-name = Conjugado { $name }
inertia-force-of-name = Força de inércia de { $name }
inertia-couple-of-name = Conjugado de inércia de { $name }

# Closure of the slider-crank
angular-velocity-of-the-rod-that-closes-the-loop-in-line = Velocidade angular da biela que fecha a cadeia centrada
length-of-the-crank-that-gives-the-slider-its-velocity = Comprimento da manivela que dá ao cursor a sua velocidade
length-of-the-rod-that-closes-the-loop-in-line = Comprimento da biela que fecha a cadeia centrada
angle-of-the-rod-that-closes-the-loop = Ângulo da biela que fecha a cadeia
angular-velocity-of-the-rod-that-closes-the-loop = Velocidade angular da biela que fecha a cadeia
velocity-of-the-slider-that-closes-the-loop = Velocidade do cursor que fecha a cadeia
angular-acceleration-of-the-crank-that-goes-with-that-of-the-rod = Aceleração angular da manivela que acompanha a da biela
angular-acceleration-of-the-rod-that-closes-the-loop = Aceleração angular da biela que fecha a cadeia
acceleration-of-the-slider-that-closes-the-loop = Aceleração do cursor que fecha a cadeia
with-these-angles-the-loop-does-not-close-in-line-or-is-at-a-dead-centre-the-given-motion-could-not = com estes ângulos a cadeia centrada não fecha, ou está em ponto morto: o movimento dado não pôde ser confrontado com ela
no-crank-of-positive-length-gives-the-slider-the-given-velocity-at-these-angles = nenhuma manivela de comprimento positivo dá ao cursor a velocidade dada com estes ângulos
the-rod-does-not-reach-the-slider-s-line-at-this-crank-angle-or-stands-across-it-the-given-motion = neste ângulo da manivela a biela não alcança a linha do cursor, ou está perpendicular a ela: o movimento dado não pôde ser confrontado com a cadeia
the-given-vectors-belong-to-no-slider-crank-of-this-geometry-the-sum-of-powers-holds-for-the-vectors = os vetores dados não pertencem a nenhum cursor-manivela desta geometria; a soma das potências vale para os vetores como estão
what-given-given-the-loop-demands-demanded-they-are-apart-apart-share-of-the-larger = { $what }: dado { $given }, a cadeia exige { $demanded }; a diferença é de { $apart }, { $share } do maior
angular-velocity-of-the-rod = velocidade angular da biela
angular-acceleration-of-the-rod = aceleração angular da biela
velocity-of-the-slider = velocidade do cursor
acceleration-of-the-slider = aceleração do cursor
velocity-of-the-rod-s-mass-centre-in-magnitude = velocidade do centro de massa da biela, em módulo
acceleration-of-the-rod-s-mass-centre-in-magnitude = aceleração do centro de massa da biela, em módulo
the-given-motion-and-what-the-loop-demands = O movimento dado e o que a cadeia exige
quantity = Grandeza
given = Dado
demanded = Exigido
apart = Diferença
share-of-the-larger = Parcela do maior
the-slider-crank-with-given-velocities-and-forces = O cursor-manivela com as velocidades e forças dadas

# built
weight-link = Peso: { $link }
inertia-force-link = Força de inércia: { $link }
inertia-couple-link = Conjugado de inércia: { $link }
virtual-works = Trabalhos virtuais
work-for-a-unit-of-the-coordinate = Trabalho por unidade da coordenada
the-effort-by-the-equations-of-newton-and-euler-of-every-link = o esforço pelas equações de Newton e Euler de cada peça
the-links-do-not-close-gap-are-missing-change-a-length-or-the-position = as peças não fecham a cadeia: faltam { $gap }; mude um comprimento ou a posição
in-this-position-the-coordinate-does-not-determine-the-motion-a-dead-centre-move-it-a-little = nesta posição a coordenada não determina o movimento: ponto morto; afaste-a um pouco
the-friction-finds-no-balance-the-mechanism-jams = o atrito não encontra equilíbrio: o mecanismo trava
the-numbers-of-this-mechanism-are-too-far-apart-to-be-computed-with = os números deste mecanismo são díspares demais para o cálculo
the-forces-on-the-whole-mechanism-along-x-are-those-that-its-masses-demand = as forças sobre todo o mecanismo ao longo de x são as que suas massas exigem
the-forces-on-the-whole-mechanism-along-y-are-those-that-its-masses-demand = as forças sobre todo o mecanismo ao longo de y são as que suas massas exigem
by-the-equations-of-newton-and-euler-of-every-link-solved-together = Pelas equações de Newton e Euler de todas as peças, resolvidas em conjunto
force-in-the-joint = Força na junta
