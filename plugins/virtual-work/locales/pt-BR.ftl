# virtual-work/a-frame
step-ladder = Escada dupla
force-at-the-feet-or-tension-of-the-rope-of-two-ladders-leaning-against-each-other-or-the-equilibrium = Força nos pés ou tração da corda de duas escadas apoiadas uma na outra, ou o ângulo de equilíbrio para uma força dada.
length-of-each-ladder = Comprimento de cada escada
weight-of-each-ladder = Peso de cada escada
load-at-the-hinge = Carga na articulação
restraint-of-the-feet = Contenção dos pés
horizontal-forces-at-the-feet = Forças horizontais nos pés
a-rope-between-the-ladders = Uma corda entre as escadas
attachment-point-from-the-hinge-as-a-fraction-of-the-length = Ponto de amarração, a partir da articulação, como fração do comprimento
force-at-a-given-angle = Força em um ângulo dado
angle-of-each-ladder-from-the-vertical = Ângulo de cada escada com a vertical
equilibrium-angle-for-a-given-force = Ângulo de equilíbrio para uma força dada
force-at-each-foot-or-tension-of-the-rope = Força em cada pé, ou tração da corda
downward-virtual-displacement-of-the-hinge-per-unit-from-y-l-cos-that-of-each-centre-of-mass-is-half = Deslocamento virtual da articulação para baixo por unidade de δθ, de y = L cos θ; o de cada centro de massa é a metade
virtual-increase-of-the-restrained-distance-per-unit = Aumento virtual da distância restringida por unidade de δθ
the-total-virtual-work-of-weights-load-and-holding-force-is-zero-2-w-y-g-q-y-t-x-0 = O trabalho virtual total dos pesos, da carga e da força de sustentação é nulo: 2 W δy_G + Q δy + T δx = 0
force-at-each-foot = Força em cada pé
tension-of-the-rope = Tração da corda
force-of-the-floor-on-each-foot = Força do piso em cada pé
coefficient-of-friction-required-at-the-feet = Coeficiente de atrito necessário nos pés
the-force-from-the-moments-on-one-ladder-about-the-hinge = a força pelos momentos em uma escada em relação à articulação
the-force-from-the-newton-euler-equations-of-every-body = a força pelas equações de Newton–Euler de cada corpo
the-force-of-the-floor-from-the-newton-euler-equations = a força do piso pelas equações de Newton–Euler
the-ladders-are-nearly-horizontal-a-small-sliding-greatly-changes-the-force = as escadas estão quase na horizontal: um pequeno deslizamento muda muito a força
neither-ladders-nor-hinge-are-loaded-write-a-weight-or-a-load = nem as escadas nem a articulação estão carregadas: escreva um peso ou uma carga
holding-force-against-the-angle-of-the-ladders = Força de sustentação em função do ângulo das escadas
angle-from-the-vertical = ângulo com a vertical
holding-force = força de sustentação
the-step-ladder = A escada dupla

# virtual-work/bar-and-cord
bar-held-by-a-cord-over-a-pulley = Barra sustentada por um cabo sobre uma polia
the-hanging-mass-that-holds-a-hinged-bar-at-an-angle-or-all-angles-at-which-a-mass-holds-it-and = A massa suspensa que mantém uma barra articulada em um ângulo, ou todos os ângulos em que uma massa a mantém, e se são estáveis.
distance-of-the-cord-s-end-from-the-pin-along-the-bar = Distância da ponta do cabo à articulação, ao longo da barra
height-of-the-pulley-above-the-pin = Altura da polia acima da articulação
hanging-mass = Massa suspensa
the-angle-of-the-bar-is-measured-upwards-from-the-horizontal = O ângulo θ da barra é medido da horizontal para cima.
weight-of-the-hanging-mass = Peso da massa suspensa
upward-virtual-displacement-of-the-centre-of-mass-of-the-bar-per-unit = Deslocamento virtual do centro de massa da barra para cima por unidade de δθ
hanging-weight-for-equilibrium = Peso suspenso para o equilíbrio
hanging-mass-for-equilibrium = Massa suspensa para o equilíbrio
the-mass-is-negative-at-this-angle-the-cord-would-have-to-push = a massa é negativa: neste ângulo o cabo teria de empurrar
the-bar-its-cord-and-its-counterweight = A barra, o cabo e o contrapeso

# virtual-work/compound-lever
chain-of-levers = Cadeia de alavancas
force-or-couple-that-balances-the-loads-on-levers-connected-in-series-from-the-ratios-of-their = Força ou binário que equilibra as cargas em alavancas ligadas em série, pelas razões dos deslocamentos virtuais.
links-from-each-lever-to-the-next = Ligações de cada alavanca à seguinte
none-for-a-single-lever = Nenhuma para uma só alavanca.
loads = Cargas
arm-on-the-driving-lever = Braço na alavanca motora
arm-on-the-driven-lever = Braço na alavanca movida
negative-for-the-opposite-sense-of-rotation = Negativo para o sentido de rotação contrário.
lever-it-acts-on = Alavanca em que atua
kind = tipo
arm = Braço
couple = binário
force-on-a-lever = Força em uma alavanca
couple-on-a-lever = Binário em uma alavanca
virtual-work-of-name-for-a-unit-rotation-of-lever-1 = Trabalho virtual de { $name }, para uma rotação unitária da alavanca 1
virtual-work-of-all-loads = Trabalho virtual de todas as cargas
the-total-virtual-work-is-zero = O trabalho virtual total é nulo
virtual-displacement-of-the-unknown-force-for-a-unit-rotation-of-lever-1 = Deslocamento virtual da força incógnita, para uma rotação unitária da alavanca 1
virtual-rotation-of-the-lever-for-a-unit-rotation-of-lever-1-both-ends-of-the-link-have-the-same = Rotação virtual da alavanca para uma rotação unitária da alavanca 1: as duas pontas da ligação têm o mesmo deslocamento, b δφ = a δφ′
equilibrant-force = Força equilibrante
equilibrant-couple = Binário equilibrante
mechanical-advantage = Vantagem mecânica
mechanical-advantage-ratio-of-the-two-forces = Vantagem mecânica: razão entre as duas forças
the-balance-from-the-newton-euler-equations-of-every-lever-and-link = o equilíbrio pelas equações de Newton–Euler de cada alavanca e ligação
lever-lever-does-not-exist-with-links-links-there-are-levers-1-to-last = a alavanca { $lever } não existe: com { $links } ligações há as alavancas de 1 a { $last }
the-sought-force-has-no-virtual-displacement-its-arm-or-a-ratio-of-the-links-is-zero-so-it-cannot = a força procurada não tem deslocamento virtual: seu braço ou uma razão das ligações é nula, e ela nada pode equilibrar
link-link-meets-lever-lever-at-its-pivot-write-a-non-zero-arm = a ligação { $link } encontra a alavanca { $lever } no pivô: escreva um braço diferente de zero
virtual-work-for-a-unit-rotation-of-lever-1 = Trabalho virtual para uma rotação unitária da alavanca 1
virtual-work = Trabalho virtual
the-levers-horizontal-with-vertical-links-not-to-scale = As alavancas na horizontal, com ligações verticais (fora de escala)

# virtual-work/engine
reciprocating-engine = Motor alternativo
motion-of-the-piston-forces-in-piston-rod-guide-crank-pin-and-bearings-and-turning-moment-of-a-single = Movimento do pistão, forças no pistão, na biela, na guia, no pino da manivela e nos mancais, e o torque de um motor monocilíndrico, em um ângulo e ao longo do ciclo.
the-two-term-and-harmonic-formulas-hold-for-a-line-of-stroke-through-the-crankshaft-choose-the-exact = as fórmulas de dois termos e de harmônicos valem para uma linha de curso que passa pelo eixo da manivela: escolha o movimento exato, ou sem excentricidade
the-acceleration-of-the-piston-does-not-determine-that-of-the-rod-give-the-speed-or-leave-the-rod = a aceleração do pistão não determina a da biela: dê a rotação, ou deixe a biela sem massa e some a parcela dela à massa alternativa
the-crank-cannot-make-a-full-revolution-with-a-rod-of-rod-crank-and-offset-together-require-more-than = a manivela não dá a volta com uma biela de { $rod }: manivela e excentricidade juntas exigem mais de { $least }
offset-of-the-line-of-stroke = Excentricidade da linha de curso
height-above-the-crankshaft-on-the-side-to-which-the-crank-turns-first = Altura acima do eixo da manivela, do lado para o qual a manivela gira primeiro.
from-the-dead-centre-with-the-piston-farthest-from-the-crankshaft-inner-or-top-dead-centre-in-the = A partir do ponto morto em que o pistão está mais longe do eixo da manivela (ponto morto superior), no sentido de rotação; com excentricidade, a partir da linha de curso.
formulas-of-the-motion = Fórmulas do movimento
piston-piston-rod-crosshead = Pistão, haste, cruzeta.
mass-of-the-connecting-rod = Massa da biela
position-of-the-cylinder = Posição do cilindro
force-on-the-piston = Força sobre o pistão
friction-of-the-piston = Atrito do pistão
against-its-motion-as-the-crank-turns-forward = Contrário ao movimento do pistão quando a manivela gira para a frente.
flywheel-and-driven-load = Volante e carga acionada
of-an-engine-without-offset-twice-the-crank-radius = De um motor sem excentricidade: o dobro do raio da manivela.
ratio-to-the-crank-radius = Razão em relação ao raio da manivela
length-of-the-rod-over-the-crank-radius = Comprimento da biela dividido pelo raio da manivela
at-rest = Em repouso
equilibrium-without-inertia = Equilíbrio sem inércia.
acceleration-of-the-piston-given = Aceleração do pistão dada
acceleration-of-the-piston = Aceleração do pistão
towards-the-crank = Em direção à manivela.
two-terms = Dois termos
cos-cos-2-n-as-in-most-books = cos θ + cos 2θ/n, como na maioria dos livros.
harmonics-up-to-an-order = Harmônicos até uma ordem
beyond-the-first-only-even-orders-occur = Além da primeira, só há ordens pares.
weights-neglected = Pesos desprezados
vertical-above-the-crankshaft = Vertical, acima do eixo da manivela
horizontal = Horizontal
angle-of-the-stroke-above-the-horizontal = Ângulo do curso acima da horizontal
the-turning-moment-over-the-cycle-cannot-be-represented-check-the-inputs = o torque ao longo do ciclo não pode ser representado: confira os dados
mean-turning-moment-at-constant-speed-integrated-over-the-cycle = Torque médio em rotação constante, integrado ao longo do ciclo
maximum-turning-moment-of-the-cycle = Torque máximo do ciclo
crank-angle-at-the-maximum-turning-moment = Ângulo da manivela no torque máximo
minimum-turning-moment-of-the-cycle = Torque mínimo do ciclo
crank-angle-at-the-minimum-turning-moment = Ângulo da manivela no torque mínimo
root-mean-square-of-the-turning-moment = Valor eficaz do torque
mean-turning-moment-over-the-cycle = Torque médio ao longo do ciclo
maximum-turning-moment = Torque máximo
minimum-turning-moment = Torque mínimo
mean-power-at-this-speed = Potência média nesta rotação
fluctuation-of-energy-work-of-the-moment-above-its-mean-from-the-minimum-to-the-maximum-sum = Flutuação de energia: o trabalho do torque acima da média, da soma mínima à máxima
fluctuation-of-energy = Flutuação de energia
coefficient-of-fluctuation-of-speed-speed-range-divided-by-the-mean-speed-against-a-constant = Coeficiente de flutuação de velocidade: faixa de velocidade dividida pela média, contra uma resistência constante
coefficient-of-fluctuation-of-speed = Coeficiente de flutuação de velocidade
maximum-turning-moment-from-the-virtual-work-at-its-crank-angle = torque máximo pelos trabalhos virtuais no seu ângulo da manivela
minimum-turning-moment-from-the-virtual-work-at-its-crank-angle = torque mínimo pelos trabalhos virtuais no seu ângulo da manivela
fluctuation-of-energy-as-the-range-of-the-kinetic-energy-of-piston-and-rod = flutuação de energia como a faixa da energia cinética de pistão e biela
maximum-turning-moment-from-the-newton-euler-equations-at-its-crank-angle = torque máximo pelas equações de Newton–Euler no seu ângulo da manivela
minimum-turning-moment-from-the-newton-euler-equations-at-its-crank-angle = torque mínimo pelas equações de Newton–Euler no seu ângulo da manivela
mean-turning-moment-from-the-work-of-gas-and-friction-per-cycle = torque médio pelo trabalho do gás e do atrito por ciclo
displacement-of-the-piston = Deslocamento do pistão
velocity-of-the-piston = Velocidade do pistão
net-piston-effort = Esforço líquido no pistão
turning-moment-on-the-crankshaft = Torque no eixo da manivela
motion-and-turning-moment-by-all-formulas = Movimento e torque por todas as fórmulas
acceleration-of-the-piston-at-this-speed = Aceleração do pistão nesta rotação
acceleration-towards-the-crank = Aceleração, em direção à manivela
gas = gás
inertia-weight-and-friction = inércia, peso e atrito
net-effort = esforço líquido
forces-along-the-stroke-over-the-cycle = Forças ao longo do curso durante o ciclo
forces-along-the-stroke-without-the-gas-force-which-is-known-only-at-this-angle = Forças ao longo do curso sem a força do gás, conhecida só neste ângulo
force-towards-the-crank = Força em direção à manivela
turning-moment = Torque na manivela
turning-moment-without-the-gas-which-is-known-only-at-this-angle = Torque sem o gás, conhecido só neste ângulo
turning-moment-over-the-cycle = Torque ao longo do ciclo
mean = média
force-at-the-crank-pin-in-axes-of-the-crank = Força no pino da manivela, em eixos da manivela
outward-along-the-crank = ao longo da manivela, para fora
along-its-motion = no sentido do movimento
over-the-cycle = ao longo do ciclo
force-on-the-main-bearings-in-axes-of-the-frame = Força nos mancais principais, em eixos da estrutura
along-the-stroke-towards-the-cylinder = ao longo do curso, em direção ao cilindro
across-the-stroke = transversal ao curso
the-engine-at-this-crank-angle-with-its-forces = O motor neste ângulo da manivela, com as suas forças
the-engine-over-its-cycle-with-its-forces = O motor ao longo do ciclo, com as suas forças
the-engine-over-one-revolution = O motor ao longo de uma volta
moment-of-inertia-of-the-flywheel = Momento de inércia do volante
a-power-determines-the-resisting-torque-only-for-a-running-engine-give-the-torque-or-the-speed = uma potência só determina o torque resistente de um motor em rotação: dê o torque, ou a rotação
torque-that-absorbs-the-power-at-this-speed = Torque que absorve a potência nesta rotação
angular-acceleration-of-the-flywheel-from-the-excess-of-the-turning-moment-over-the-resistance = Aceleração angular do volante, pelo excesso do torque sobre a resistência
angular-acceleration-of-the-flywheel = Aceleração angular do volante
inertia-of-the-flywheel = Inércia do volante
resisting-load = Carga resistente
resisting-torque = Torque resistente
power-at-this-speed = Potência nesta rotação
gravity-along-the-stroke-towards-the-crank = Gravidade ao longo do curso, em direção à manivela
gravity-transverse-to-the-stroke = Gravidade transversal ao curso
reciprocating-mass-including-the-rod-s-equivalent-mass-at-the-gudgeon-pin = Massa alternativa, incluindo a massa equivalente da biela no pino do pistão
inertia-force-of-the-reciprocating-masses-opposite-to-their-acceleration = Força de inércia das massas alternativas, contrária à aceleração
inertia-force-along-the-stroke-away-from-the-crank = Força de inércia ao longo do curso, afastando-se da manivela
weight-of-the-reciprocating-masses-along-the-stroke = Peso das massas alternativas ao longo do curso
weight-along-the-stroke = Peso ao longo do curso
net-effort-along-the-stroke-towards-the-crank = Esforço líquido ao longo do curso, em direção à manivela
virtual-work-of-the-weight-of-the-rod-s-share-at-the-crank-pin-for = Trabalho virtual do peso da parcela da biela no pino da manivela, para δθ
inertia-couple-that-corrects-the-two-masses-of-the-rod = Binário de inércia que corrige as duas massas da biela
correction-couple-of-the-rod = Binário de correção da biela
virtual-work-of-the-correction-couple-for = Trabalho virtual do binário de correção, para δθ
virtual-work-of-the-inertia-of-the-rod-s-share-at-the-crank-pin-for = Trabalho virtual da inércia da parcela da biela no pino da manivela, para δθ
at-a-dead-centre-no-force-on-the-piston-turns-the-crank-choose-another-crank-angle = em um ponto morto nenhuma força no pistão gira a manivela: escolha outro ângulo da manivela
virtual-work-f-p-s-t-m-the-effort-that-produces-the-turning-moment = Trabalho virtual F_P δs + ΣT δθ = M δθ: o esforço que produz o torque
force-on-the-piston-towards-the-crank = Força sobre o pistão, em direção à manivela
load-of-the-piston-on-the-gudgeon-pin-without-the-rod-s-equivalent-mass = Carga do pistão sobre o seu pino, sem a massa equivalente da biela
load-of-the-piston-on-the-gudgeon-pin-along-the-stroke = Carga do pistão sobre o seu pino, ao longo do curso
virtual-work-of-the-piston-effort-t-f-p-s = Trabalho virtual do esforço no pistão: T δθ = F_P δs
moment-of-the-piston-effort = Torque do esforço no pistão
moment-of-the-correction-couple = Torque do binário de correção
moment-of-the-weight-at-the-crank-pin = Torque do peso no pino da manivela
the-virtual-work-of-all-loads-equals-that-of-the-turning-moment = O trabalho virtual de todas as ações é igual ao do torque
force-transverse-to-the-stroke-at-the-gudgeon-pin-moments-of-the-rod-about-the-crank-pin = Força transversal ao curso no pino do pistão: momentos da biela em relação ao pino da manivela
force-at-the-crank-pin-in-the-direction-of-its-motion-with-the-loads-of-the-rod-s-equivalent-mass = Força no pino da manivela no sentido do movimento, com as ações da massa equivalente da biela ali
force-at-the-crank-pin-towards-the-crankshaft = Força no pino da manivela em direção ao eixo
thrust-in-the-rod-whose-component-along-the-stroke-is-the-effort = Força na biela, cuja componente ao longo do curso é o esforço
thrust-in-the-rod = Força na biela
thrust-on-the-guide-the-component-of-the-rod-s-thrust-across-the-stroke = Força na guia: a componente transversal da força na biela
thrust-on-the-guide = Força na guia
force-at-the-crank-pin-in-the-direction-of-its-motion = Força no pino da manivela no sentido do movimento
thrust-on-the-bearings-along-the-crank-towards-the-crankshaft = Força nos mancais ao longo da manivela, em direção ao eixo
tangential-force-at-the-crank-pin = Força tangencial no pino da manivela
radial-force-at-the-crank-pin-towards-the-crankshaft = Força radial no pino da manivela, em direção ao eixo
force-at-the-crank-pin-with-a-balanced-crank-also-the-force-on-the-main-bearings = Força no pino da manivela; com a manivela balanceada, também a força nos mancais principais
force-at-the-crank-pin = Força no pino da manivela
the-turning-moment-is-the-tangential-force-times-the-crank = o torque é a força tangencial vezes a manivela
speed-at-which-the-inertia-force-growing-with-balances-all-other-forces-the-load-on-the-gudgeon-pin = Rotação em que a força de inércia, que cresce com ω², equilibra todas as outras forças: a carga no pino do pistão é nula
speed-at-which-the-load-on-the-gudgeon-pin-reverses = Rotação em que a carga no pino do pistão se inverte
no-load-on-the-gudgeon-pin-at-that-speed = nenhuma carga no pino do pistão nessa rotação
gauge-pressure = Pressão manométrica
an-absolute-pressure-is-negative-write-gauge-pressures-not-below-minus-the-atmospheric-pressure-or = uma pressão absoluta é negativa: escreva pressões manométricas não inferiores a menos a pressão atmosférica, ou escolha pressões absolutas
absolute-pressure = Pressão absoluta
fraction-of-the-stroke-travelled-by-the-piston = Fração do curso percorrida pelo pistão
exhaust-on-the-side-away-from-the-crankshaft = Escape no lado oposto ao eixo da manivela
exhaust-on-the-side-towards-the-crankshaft = Escape no lado do eixo da manivela
before-the-cut-off-full-admission-pressure = Antes do corte: pressão plena de admissão
after-the-cut-off-the-steam-expands = Depois do corte o vapor se expande
mean-effective-pressure-work-per-stroke-over-its-volume-less-the-back-pressure = Pressão média efetiva: o trabalho de um curso dividido pela cilindrada, menos a contrapressão
mean-effective-pressure = Pressão média efetiva
work-of-the-steam-per-revolution = Trabalho do vapor por volta
work-of-the-gas-per-revolution = Trabalho do gás por volta
the-indicator-diagram-needs-at-least-two-rows-in-ascending-order-of-the-fraction-of-stroke-from-0-to = o diagrama indicador precisa de pelo menos duas linhas em ordem crescente da fração do curso, de 0 a 1
the-indicator-diagram-needs-at-least-two-rows-in-ascending-order-of-crank-angle-within-one-cycle = o diagrama indicador precisa de pelo menos duas linhas em ordem crescente do ângulo da manivela, dentro de um ciclo
gauge-pressure-read-from-the-diagram-between-its-rows = Pressão manométrica, lida no diagrama entre as suas linhas
force-of-the-gas-on-the-piston-towards-the-crank = Força do gás sobre o pistão, em direção à manivela
area-of-the-piston = Área do pistão
the-piston-rod-of-rod-fills-the-whole-bore-of-bore-reduce-its-diameter = a haste de { $rod } ocupa todo o cilindro de { $bore }: reduza o seu diâmetro
area-of-the-piston-on-the-side-towards-the-crankshaft = Área do pistão do lado do eixo da manivela
force-given = Força dada
towards-the-crank-at-this-crank-angle = Em direção à manivela; neste ângulo da manivela.
sought-the-force-for-a-turning-moment = Procurada: a força para um torque
turning-moment-of-the-engine = Torque do motor
torque-to-be-held-or-driven-in-the-sense-of-rotation = Torque a segurar ou acionar, no sentido de rotação.
pressures-at-this-crank-angle = Pressões neste ângulo da manivela
bore = Diâmetro do cilindro
pressure = Pressão
on-the-side-opposite-to-the-crankshaft = Do lado oposto ao eixo da manivela.
other-side-of-the-piston = Outro lado do pistão
pressure-reference = Referência das pressões
admission-cut-off-and-expansion = Admissão, corte e expansão
of-a-steam-engine-over-the-whole-cycle = De uma máquina a vapor, ao longo de todo o ciclo.
working-sides-of-the-piston = Lados ativos do pistão
admission-pressure = Pressão de admissão
exhaust-pressure = Pressão de escape
cut-off = Corte da admissão
fraction-of-the-stroke-during-which-the-cylinder-is-filled = Fração do curso durante a qual o cilindro é enchido.
clearance = folga
closed-form-f-p-b-a-h-p-a-s-a-k-p-a-r-s-0-62646-of-the-return-stroke = forma fechada: F = p_b A_h − p_a ((ε + κ)/(s + κ))ᵏ A_k − p₀ A_r, s = 0,62646 do curso de retorno
clearance-volume-at-the-dead-centre-divided-by-the-swept-volume = Volume morto, no ponto morto, dividido pela cilindrada.
expansion-law = Lei da expansão
indicator-diagram-over-the-stroke = Diagrama indicado em função do curso
pressures = Pressões
indicator-diagram-over-the-crank-angle = Diagrama indicado em função do ângulo da manivela
the-atmosphere = A atmosfera
a-pressure = Uma pressão
on-the-side-towards-the-crankshaft = Do lado do eixo da manivela.
diameter-of-the-piston-rod = Diâmetro da haste do pistão
single-acting = De simples efeito
atmospheric-pressure-acts-on-the-side-towards-the-crankshaft = A pressão atmosférica atua no lado do eixo da manivela.
double-acting = De duplo efeito
the-same-on-both-sides-half-a-revolution-apart = O mesmo dos dois lados, com meia volta de diferença.
the-atmosphere-gauge-pressures = A atmosfera: pressões manométricas
atmospheric-pressure = Pressão atmosférica
vacuum-absolute-pressures = O vácuo: pressões absolutas
hyperbolic-p-v-constant = Hiperbólica, p v constante
polytropic-p-v-constant = Politrópica, p vᵏ constante
exponent = Expoente
fraction-of-the-stroke = Fração do curso
pressure-on-the-stroke-towards-the-crankshaft = Pressão no curso em direção ao eixo da manivela
pressure-on-the-return-stroke = Pressão no curso de retorno
with-an-offset-the-stroke-is-not-twice-the-crank-radius-give-the-crank-radius = com excentricidade o curso não é o dobro do raio da manivela: dê o raio da manivela
ratio-of-rod-and-crank = Razão entre biela e manivela
obliquity-of-the-rod-crank-pin-and-gudgeon-pin-are-at-the-ends-of-both = Obliquidade da biela: o pino da manivela e o do pistão estão nas extremidades de ambas
obliquity-of-the-rod = Obliquidade da biela
virtual-displacement-of-the-piston-for-that-of-the-crank-s-h-the-arm-of-the-effort-along-the-stroke = Deslocamento virtual do pistão para o da manivela, δs = h δθ: o braço do esforço ao longo do curso
arm-of-the-piston-effort-about-the-crankshaft = Braço do esforço no pistão em relação ao eixo da manivela
distance-of-the-gudgeon-pin-from-the-crankshaft-along-the-stroke = Distância do pino do pistão ao eixo da manivela, ao longo do curso
distance-of-the-gudgeon-pin-from-the-crankshaft = Distância do pino do pistão ao eixo da manivela
displacement-of-the-piston-from-the-dead-centre-farthest-from-the-crankshaft = Deslocamento do pistão a partir do ponto morto mais afastado do eixo da manivela
amplitude-of-this-order-of-the-acceleration-over-r-by-its-series-in-1-n = Amplitude desta ordem da aceleração dividida por r ω², pela sua série em 1/n
the-same-amplitude-by-its-fourier-integral-over-one-revolution = a mesma amplitude pela sua integral de Fourier em uma volta
virtual-rotation-of-the-rod-for-that-of-the-crank = Rotação virtual da biela para a da manivela, δφ = φ′ δθ
velocity-of-the-piston-towards-the-crank = Velocidade do pistão, em direção à manivela
angular-acceleration-of-the-rod-positive-for-increasing-obliquity = Aceleração angular da biela, positiva quando a obliquidade cresce
acceleration-of-the-piston-towards-the-crank = Aceleração do pistão, em direção à manivela
crank-angle-with-the-piston-moving-towards-the-crank-at-which-its-acceleration-is-zero-and-its = Ângulo da manivela, com o pistão indo em direção a ela, em que a aceleração do pistão é nula e a velocidade é máxima
crank-angle-at-zero-piston-acceleration = Ângulo da manivela com aceleração nula do pistão
sin-n-sin-n-sin-n-0-at-the-angle-of-zero-acceleration = sin⁶θ₀ − n² sin⁴θ₀ − n⁴ sin²θ₀ + n⁴ = 0 no ângulo de aceleração nula
zero-acceleration-there-from-the-loop-closure-of-the-slider-crank = aceleração nula ali pelo fechamento da cadeia do cursor-manivela
the-harmonics-cancel-at-the-angle-of-zero-acceleration = os harmônicos se cancelam no ângulo de aceleração nula
mass-of-the-rod = Massa da biela
distance-of-its-centre-of-mass-from-the-crank-pin = Distância do seu centro de massa ao pino da manivela
moment-of-inertia-of-two-masses-at-the-pins = Momento de inércia de duas massas nos pinos
distance-of-the-rod-s-centre-of-mass-from-the-gudgeon-pin = Distância do centro de massa da biela ao pino do pistão
distance-of-the-rod-s-centre-of-mass-from-the-crank-pin = Distância do centro de massa da biela ao pino da manivela
the-centre-of-mass-of-the-rod-lies-beyond-its-pins-its-distance-must-not-be-above-the-length-of-the = o centro de massa da biela está além dos seus pinos: a distância não pode passar do comprimento da biela, { $rod }
share-of-the-rod-s-mass-at-the-gudgeon-pin-keeping-the-centre-of-mass-unchanged = Parcela da massa da biela no pino do pistão, mantendo o centro de massa
share-of-the-rod-s-mass-at-the-crank-pin = Parcela da massa da biela no pino da manivela
moment-of-inertia-of-the-rod = Momento de inércia da biela
moment-of-inertia-deficit-of-the-two-masses-negative-for-an-excess = Déficit de momento de inércia das duas massas; negativo se houver excesso
the-acceleration-of-the-centre-of-mass-is-interpolated-between-those-of-the-two-pins-towards-the = A aceleração do centro de massa é interpolada entre as dos dois pinos: em direção à manivela
fraction-of-the-rod-length-from-the-crank-pin-to-its-centre-of-mass = Fração do comprimento da biela do pino da manivela ao seu centro de massa
transverse-to-the-stroke-towards-the-line-of-stroke = Transversal ao curso, em direção à linha de curso
inertia-force-of-the-rod = Força de inércia da biela
massless = Sem massa
or-counted-with-the-reciprocating-mass = Ou contada com a massa alternativa.
a-rigid-body = Um corpo rígido
position-of-its-centre-of-mass = Posição do seu centro de massa
its-moment-of-inertia = O seu momento de inércia
masses-at-its-two-pins = Massas nos seus dois pinos
mass-at-the-gudgeon-pin = Massa no pino do pistão
mass-at-the-crank-pin = Massa no pino da manivela
from-the-crank-pin = A partir do pino da manivela
distance-from-the-crank-pin = Distância ao pino da manivela
from-the-gudgeon-pin = A partir do pino do pistão
distance-from-the-gudgeon-pin = Distância ao pino do pistão
radius-of-gyration-about-the-centre-of-mass = Raio de giração em relação ao centro de massa
inertia-of-masses-at-the-two-pins = Inércia das massas nos dois pinos
the-rod-then-needs-no-correction-couple = A biela então não precisa de binário de correção.
obliquity-of-the-rod-from-the-loop-closure-of-the-slider-crank = obliquidade da biela pelo fechamento da cadeia do cursor-manivela
velocity-of-the-piston-from-the-loop-closure-of-the-slider-crank = velocidade do pistão pelo fechamento da cadeia do cursor-manivela
acceleration-of-the-piston-from-the-loop-closure-of-the-slider-crank = aceleração do pistão pelo fechamento da cadeia do cursor-manivela
acceleration-of-the-piston-as-the-sum-of-its-primary-and-secondary-components = aceleração do pistão como soma das componentes primária e secundária
velocity-of-the-piston-as-the-derivative-of-its-displacement = velocidade do pistão como derivada do seu deslocamento
turning-moment-from-the-newton-euler-equations-of-piston-and-rod = torque pelas equações de Newton–Euler do pistão e da biela
thrust-on-the-guide-from-the-newton-euler-equations = força na guia pelas equações de Newton–Euler
load-on-the-gudgeon-pin-from-the-newton-euler-equations = carga no pino do pistão pelas equações de Newton–Euler
radial-force-at-the-crank-pin-from-the-newton-euler-equations = força radial no pino da manivela pelas equações de Newton–Euler
moment-of-the-inertia-forces-as-de-d-of-the-kinetic-energy = torque das forças de inércia como −dE/dθ da energia cinética
the-turning-moment-in-crank-axes-by-the-equilibrium-of-rod-and-piston = o torque em eixos da manivela pelo equilíbrio de biela e pistão
thrust-on-the-guide-by-the-equilibrium-of-rod-and-piston = força na guia pelo equilíbrio de biela e pistão
running = Marcha
speed-of-the-crank = Velocidade da manivela
motion = movimento
crank = Manivela
reciprocating-mass = Massa alternativa
crank-angle = Ângulo da manivela
crank-radius = Raio da manivela
stroke = Curso
inclined = inclinada
highest-order = Maior ordem
mass-and-radius-of-gyration = Massa e raio de giração
radius-of-gyration = Raio de giração
torque = torque
mean-power = Potência média
the-crank-is-half-the-stroke = A manivela é a metade do curso
harmonics = Harmônicos
exact = exato
at-this-angle = neste ângulo
four-strokes = Quatro tempos
two-strokes = Dois tempos
strokes-of-a-cycle = Tempos de um ciclo
moment-of-inertia-about-the-centre-of-mass = Momento de inércia em relação ao centro de massa
moment-of-inertia = Momento de inércia
no-force = Nenhuma força

# Equilibria of machines with one freedom
all-equilibrium-positions-in-a-range = Todas as posições de equilíbrio em um intervalo
minimum-angle = Ângulo mínimo
largest-angle = Maior ângulo
maximum-angle = Ângulo máximo
at-a-given-angle = Em um ângulo dado
leave-one-load-or-stiffness-blank-to-solve-for-it-with-none-blank-the-equilibrant-couple-is-computed = Deixe uma carga ou rigidez em branco para calculá-la; sem nenhuma em branco, calcula-se o binário equilibrante.
stable-equilibrium = Equilíbrio estável
unstable-equilibrium = Equilíbrio instável
neutral-critical-equilibrium = Equilíbrio indiferente (crítico)
second-derivative-of-the-potential-energy-at-the-stable-equilibrium = Segunda derivada da energia potencial no equilíbrio estável
second-derivative-of-the-potential-energy-at-the-unstable-equilibrium = Segunda derivada da energia potencial no equilíbrio instável
second-derivative-of-the-potential-energy-at-the-critical-equilibrium = Segunda derivada da energia potencial no equilíbrio crítico
second-derivative-of-the-potential-energy-positive-at-a-stable-equilibrium = Segunda derivada da energia potencial: positiva no equilíbrio estável
equilibrium-v-0-sign-change-of-v-in-the-range-refined-by-brent-s-method = Equilíbrio, δV = 0: mudança de sinal de δV/δθ no intervalo, refinada pelo método de Brent
v-there-the-total-virtual-work-is-zero = δV/δθ nesse ponto: o trabalho virtual total é nulo
d-v-d-0-the-potential-energy-is-a-minimum-the-equilibrium-is-stable = d²V/dθ² > 0: a energia potencial é mínima, o equilíbrio é estável
d-v-d-0-the-potential-energy-is-a-maximum-the-equilibrium-is-unstable = d²V/dθ² < 0: a energia potencial é máxima, o equilíbrio é instável
d-v-d-0-critical-equilibrium-decided-by-higher-derivatives = d²V/dθ² = 0: equilíbrio crítico, decidido pelas derivadas de ordem superior
the-derivative-of-the-potential-energy-is-zero-in-equilibrium = a derivada da energia potencial é nula no equilíbrio
no-holding-effort-is-needed-there-from-the-newton-euler-equations-of-every-body = nenhum esforço de sustentação é necessário ali, pelas equações de Newton–Euler de cada corpo
the-range-of-angles-ends-where-it-begins-or-before-write-the-smaller-angle-first = o intervalo de ângulos termina onde começa ou antes: escreva primeiro o menor ângulo
the-potential-energy-is-not-finite-everywhere-in-the-range-of-angles-choose-a-range-without-the = a energia potencial não é finita em todo o intervalo de ângulos: escolha um intervalo sem a posição singular
every-position-is-an-equilibrium-the-potential-energy-is-the-same-at-all-angles-and-the-equilibrium = toda posição é de equilíbrio: a energia potencial é a mesma em todos os ângulos, e o equilíbrio é indiferente
the-search-for-equilibria-did-not-converge = a procura das posições de equilíbrio não convergiu
there-is-no-equilibrium-between-from-and-to-write-a-wider-range-of-angles-or-other-loads = não há equilíbrio entre { $from } e { $to }: escreva um intervalo de ângulos mais largo, ou outras cargas
there-are-number-equilibria-in-the-range-of-angles-write-a-narrower-one = há { $number } posições de equilíbrio no intervalo de ângulos: escreva um intervalo mais estreito
stable = estável
unstable = instável
critical = Crítico
potential-energy-and-its-equilibria = Energia potencial e suas posições de equilíbrio
potential-energy = energia potencial
equilibria-in-the-range = Posições de equilíbrio no intervalo
second-derivative = Segunda derivada
equilibrium = Equilíbrio
a-load-or-stiffness-is-left-blank-write-it-0-if-there-is-none-or-write-the-angle-of-equilibrium-from = uma carga ou rigidez está em branco: escreva-a, 0 se não houver, ou escreva o ângulo de equilíbrio, do qual se obtém a que falta
more-than-one-load-or-stiffness-is-missing-the-angle-determines-only-one-of-them = mais de uma carga ou rigidez está em branco: o ângulo determina apenas uma delas
all-known-loads-are-zero-write-down-a-load = todas as cargas conhecidas são nulas: escreva uma carga
at-this-angle-load-does-no-virtual-work-equilibrium-does-not-determine-it = neste ângulo { $load } não realiza trabalho virtual: o equilíbrio não a determina
virtual-work-per-unit-load = Trabalho virtual por unidade de δθ: { $load }
the-total-virtual-work-of-all-loads-is-zero = O trabalho virtual total de todas as cargas é nulo
equilibrant-couple-on-the-bar-in-the-sense-of-t-plus-the-virtual-work-of-all-loads-is-zero = Binário equilibrante na barra, no sentido de θ: a soma de T δθ com os trabalhos virtuais de todas as cargas é nula
equilibrant-couple-of-the-machine = Binário equilibrante da máquina
the-holding-couple-from-the-newton-euler-equations-of-every-body = o binário de sustentação pelas equações de Newton–Euler de cada corpo
equilibrium-load-against-the-angle = Carga de equilíbrio em função do ângulo
if-left-blank-it-is-computed-from-the-position = Em branco, é calculada a partir da posição.
enter-0-if-there-is-none-leave-it-blank-to-find-it-from-the-position = Escreva 0 se não houver; deixe em branco para obtê-la a partir da posição.
uniform-its-weight-acts-in-the-middle = Uniforme: o peso atua no meio.
weight-of-the-bar = Peso da barra
weight-of-each-bar = Peso de cada barra
extension-of-the-spring-times-its-virtual-change-per-unit = Alongamento da mola vezes sua variação virtual por unidade de δθ
angle-at-which-the-spring-is-unstretched = Ângulo com a mola sem deformação
length-of-each-bar = Comprimento de cada barra
mass-of-each-bar = Massa de cada barra
forces-in-the-joints = Forças nas articulações
weights-of-the-bars = pesos das barras
force-at-a = força em A
force-at-b = força em B
force-at-c = força em C
guide-of-a = Guia de A
guide-of-b = Guia de B
guide-of-c = Guia de C
pin-a = Pino A
joint-b = Articulação B
pin-of-the-bar = Pino da barra
upper-corner-left-bar = Vértice superior, barra esquerda
upper-corner-right-bar = Vértice superior, barra direita
left-corner = Vértice esquerdo
right-corner = Vértice direito
lower-corner = Vértice inferior
pivot = Pivô
fixed-pin = Pino fixo
knee = Joelho
guide-of-the-ram = Guia do êmbolo
upper-end-of-bar-bar = Extremidade superior da barra { $bar }

# virtual-work/equivalent-rod
equivalent-masses-of-a-connecting-rod = Massas equivalentes de uma biela
two-masses-dynamically-equivalent-to-a-connecting-rod-the-masses-at-its-two-pins-and-the-correction = Duas massas dinamicamente equivalentes a uma biela, as massas nos seus dois pinos e o binário de correção.
the-centre-of-mass-lies-beyond-the-crank-pin-its-distance-must-be-below-the-length-of-the-rod-length = o centro de massa está além do pino da manivela: a distância tem de ser menor que o comprimento da biela, { $length }
distance-of-the-centre-of-mass-from-the-crank-pin = Distância do centro de massa ao pino da manivela
length-of-the-simple-pendulum-equivalent-to-the-rod-about-the-gudgeon-pin = Comprimento do pêndulo simples equivalente à biela em torno do pino do pistão
with-one-mass-at-the-gudgeon-pin-the-other-is-beyond-the-centre-of-mass-where-a-b-k = Com uma massa no pino do pistão, a outra fica além do centro de massa, onde a b′ = k²
mass-at-the-gudgeon-pin-total-mass-and-centre-of-mass-are-preserved = Massa no pino do pistão: a massa total e o centro de massa se mantêm
the-other-mass = A outra massa
mass-at-the-gudgeon-pin-when-the-other-is-at-the-crank-pin = Massa no pino do pistão quando a outra está no pino da manivela
moment-of-inertia-deficit-of-masses-at-the-two-pins-negative-for-an-excess = Déficit de momento de inércia de massas nos dois pinos; negativo se houver excesso
distance-of-the-second-mass-from-the-centre-of-mass = Distância da segunda massa ao centro de massa
mass-at-the-gudgeon-pin-of-the-equivalent-rod = Massa no pino do pistão da biela equivalente
second-mass-of-the-equivalent-rod = Segunda massa da biela equivalente
mass-at-the-gudgeon-pin-with-the-other-at-the-crank-pin = Massa no pino do pistão, com a outra no pino da manivela
moment-of-inertia-deficit-of-masses-at-the-pins = Déficit de momento de inércia de massas nos pinos
length-of-the-equivalent-pendulum-about-the-gudgeon-pin = Comprimento do pêndulo equivalente em torno do pino do pistão
couple-to-be-added-to-the-inertia-of-masses-at-the-pins = Binário a somar à inércia de massas nos pinos
correction-couple = Binário de correção
the-correction-couple-as-m-a-l-l = o binário de correção como m a (l − L) α
the-two-masses-add-up-to-the-mass-of-the-rod = a soma das duas massas é a massa da biela
the-two-masses-have-the-same-centre-of-mass-as-the-rod = as duas massas têm o mesmo centro de massa da biela
the-two-masses-have-the-same-moment-of-inertia-as-the-rod = as duas massas têm o mesmo momento de inércia da biela
moment-of-inertia-of-the-rod-as-that-of-the-masses-at-the-pins-plus-the-difference = momento de inércia da biela como o das massas nos pinos mais a diferença
length-of-the-simple-pendulum-of-this-period = Comprimento do pêndulo simples deste período
no-rod-of-this-length-has-these-two-periods-its-centre-of-mass-would-be-beyond-a-pin-check-periods = nenhuma biela deste comprimento tem estes dois períodos: o centro de massa ficaria além de um pino; confira os períodos e o comprimento
both-oscillations-give-the-same-radius-of-gyration-a-l-g-a-l-a-l-c-l-a = As duas oscilações dão o mesmo raio de giração: a (L_g − a) = (l − a)(L_c − l + a)
distance-of-the-centre-of-mass-from-the-gudgeon-pin = Distância do centro de massa ao pino do pistão
the-rod-swings-faster-than-a-simple-pendulum-with-all-its-mass-at-the-centre-of-mass-check-the-period = a biela oscila mais depressa do que um pêndulo simples com toda a massa no centro de massa: confira o período e a distância
gudgeon-pin = pino do pistão
crank-pin = pino da manivela
the-rod-and-its-equivalent-masses = A biela e as suas massas equivalentes
between-its-pins = Entre os seus pinos.
for-the-couple-that-corrects-masses-at-its-pins = Para o binário que corrige massas nos seus pinos.
centre-of-mass-and-radius-of-gyration = Centro de massa e raio de giração
centre-of-mass-and-moment-of-inertia = Centro de massa e momento de inércia
centre-of-mass-and-oscillation-about-the-gudgeon-pin = Centro de massa e oscilação em torno do pino do pistão
period-of-small-oscillations-about-the-gudgeon-pin = Período das pequenas oscilações em torno do pino do pistão
oscillations-about-both-pins = Oscilações em torno dos dois pinos
period-of-small-oscillations-about-the-crank-pin = Período das pequenas oscilações em torno do pino da manivela

# virtual-work/flywheel
flywheel = Volante
the-turning-moment-is-constant-and-equal-to-its-mean-no-flywheel-is-needed = o torque é constante e igual à média: não é preciso volante
moment-of-inertia-the-energy-i-i-c-s-absorbs-the-fluctuation = Momento de inércia: a energia ½ I (ω₁² − ω₂²) = I ω² C_s absorve a flutuação
mass-of-the-flywheel = Massa do volante
coefficient-of-fluctuation-of-speed-from-i-c-s-e = Coeficiente de flutuação de velocidade, de I ω² C_s = ΔE
the-speed-would-vary-by-more-than-half-its-value-the-turning-moment-at-a-constant-speed-is-no-longer = a rotação variaria mais da metade do seu valor: o torque em rotação constante já não é válido
greatest-speed = Maior rotação
maximum-speed = Rotação máxima
least-speed = Menor rotação
minimum-speed = Rotação mínima
the-flywheel-s-kinetic-energies-at-both-speeds-differ-by-the-fluctuation = as energias cinéticas do volante nas duas rotações diferem pela flutuação
fluctuation-of-energy-from-the-integrals-of-the-harmonics = flutuação de energia pelas integrais dos harmônicos
the-table-needs-at-least-two-rows-in-ascending-order-of-crank-angle-within-one-cycle = a tabela precisa de pelo menos duas linhas em ordem crescente do ângulo da manivela, dentro de um ciclo
mean-turning-moment-from-the-trapezia-between-the-rows = torque médio pelos trapézios entre as linhas
crank-angles-at-which-the-turning-moment-crosses-its-mean = Ângulos da manivela em que o torque cruza a média
minimum-of-the-same-work-the-speed-is-minimum-there = Mínimo do mesmo trabalho: ali a rotação é mínima
coefficient-of-fluctuation-of-energy-ratio-to-the-work-per-cycle = Coeficiente de flutuação de energia: razão entre a flutuação e o trabalho por ciclo
coefficient-of-fluctuation-of-energy = Coeficiente de flutuação de energia
one-area-alone-cannot-close-a-cycle-write-all-areas-in-order-with-their-signs = uma só área não fecha um ciclo: escreva todas as áreas em ordem, com os seus sinais
energy-of-a-square-millimetre-of-the-diagram = Energia de um milímetro quadrado do diagrama
the-areas-above-and-below-the-mean-differ-by-rest-the-curve-does-not-close-over-the-cycle = as áreas acima e abaixo da média diferem em { $rest }: a curva não se fecha no ciclo
maximum-cumulative-area-at-a-crossing-the-speed-is-maximum-there = Área acumulada máxima, em um cruzamento: ali a rotação é máxima
minimum-cumulative-area-at-a-crossing = Área acumulada mínima, em um cruzamento
the-fluctuation-from-the-areas-between-the-two-crossings = a flutuação pelas áreas entre os dois cruzamentos
without-harmonics-the-turning-moment-is-its-mean-write-at-least-one-harmonic = sem harmônicos o torque é a sua média: escreva pelo menos um harmônico
an-order-is-neither-an-integer-nor-a-half-integer-so-the-turning-moment-is-not-periodic-over-two = uma ordem não é inteira nem semi-inteira, e o torque não é periódico em duas voltas
crossings-of-the-mean = cruzamentos da média
mean-speed = Rotação média
mean-and-harmonics = Média e harmônicos
mean-turning-moment = Torque médio
table-against-the-crank-angle = Tabela em função do ângulo da manivela
linear-interpolation-between-its-rows = Interpolação linear entre as suas linhas.
areas-between-the-curve-and-its-mean = Áreas entre a curva e a sua média
in-order-above-the-mean-positive-and-below-it-negative = Em ordem, positivas acima da média e negativas abaixo.
areas = Áreas
scale-of-the-moments = Escala dos torques
scale-of-the-angles = Escala dos ângulos
fluctuation-of-energy-given = Flutuação de energia dada
an-integer-or-a-half-integer-in-a-cycle-of-two-revolutions = Inteira, ou semi-inteira em um ciclo de duas voltas.
sine-coefficient = Coeficiente do seno
cosine-coefficient = Coeficiente do cosseno
inertia-for-a-given-fluctuation-of-speed = Inércia para uma flutuação de velocidade dada
maximum-minus-minimum-speed-divided-by-the-mean-twice-the-value-stated-as-of-the-mean = Rotação máxima menos a mínima, dividida pela média; o dobro do valor dado como ± da média.
used-to-find-the-mass-of-the-flywheel = Usado para obter a massa do volante.
fluctuation-of-speed-of-a-flywheel = Flutuação de velocidade de um volante
order = Ordem
find = Determinar
unknown = Incógnita

# virtual-work/guided-bar
bar-in-two-guides = Barra em duas guias
equilibria-and-stability-of-a-bar-whose-ends-slide-in-guides-at-right-angles-or-the-force-or = Equilíbrio e estabilidade de uma barra cujas extremidades deslizam em guias perpendiculares, ou a força ou rigidez para um ângulo dado.
end-a = Extremidade A
above-the-horizontal-guide = Acima da guia horizontal
below-the-horizontal-guide = Abaixo da guia horizontal
vertical-force-at-a-downwards = Força vertical em A, para baixo
horizontal-force-at-b-towards-the-vertical-guide = Força horizontal em B, em direção à guia vertical
the-angle-is-measured-between-the-bar-and-the-vertical-guide = O ângulo θ é medido entre a barra e a guia vertical.
none = nenhuma
vertical = Vertical
distance-of-its-end-on-the-bar-from-a = Distância de sua ponta na barra a A
distance-of-its-end-on-the-bar-from-b = Distância de sua ponta na barra a B
upward-virtual-displacement-of-the-centre-of-mass-per-unit = Deslocamento virtual do centro de massa para cima por unidade de δθ
upward-virtual-displacement-of-a-per-unit = Deslocamento virtual de A para cima por unidade de δθ
virtual-displacement-of-b-per-unit-away-from-the-vertical-guide = Deslocamento virtual de B por unidade de δθ, afastando-se da guia vertical
vertical-force-at-a = Força vertical em A
horizontal-force-at-b = Força horizontal em B
the-bar-in-its-guides = A barra em suas guias

# virtual-work/hanging-chain
hanging-chain-of-bars = Cadeia suspensa de barras
angles-of-a-chain-of-hinged-bars-pulled-at-its-free-end-with-the-stability-in-each-degree-of-freedom = Ângulos de uma cadeia de barras articuladas puxada na extremidade livre, com a estabilidade em cada grau de liberdade, ou a força para um ângulo dado.
bars-from-the-pin-to-the-free-end = Barras, da articulação fixa à extremidade livre
vertical-force-at-the-free-end-downwards = Força vertical na extremidade livre, para baixo
weight = Peso
uniform-it-acts-in-the-middle = Uniforme: atua no meio.
angles-under-a-horizontal-force = Ângulos sob uma força horizontal
horizontal-force-at-the-free-end = Força horizontal na extremidade livre
horizontal-force-for-a-given-angle-of-a-bar = Força horizontal para um ângulo dado de uma barra
bar-number-from-the-pin = Número da barra, a partir da articulação fixa
its-angle-from-the-vertical = Seu ângulo com a vertical
the-chain-has-more-than-30-bars-write-fewer = a cadeia tem mais de 30 barras: escreva menos
downward-force-on-the-bar-half-its-own-weight-plus-everything-below-it-its-virtual-work-is-g-l-sin = Força para baixo na barra, metade do próprio peso mais tudo abaixo dela: o seu trabalho virtual é −G l sen θ δθ
bar-bar-does-not-exist-the-chain-has-bars = a barra { $bar } não existe: a cadeia tem { $bars }
horizontal-force-from-a-virtual-rotation-of-this-bar-alone-f-l-cos-g-l-sin-0 = Força horizontal, pela rotação virtual só desta barra: F l cos θ − G l sen θ = 0
no-force-pulls-on-bar-bar-every-angle-is-an-equilibrium = nenhuma força puxa a barra { $bar }: todo ângulo é de equilíbrio
angle-from-the-vertical-u-f-l-cos-g-l-sin-0-for-a-virtual-rotation-of-this-bar-alone-tan-f-g = Ângulo com a vertical: δU = (F l cos θ − G l sen θ) δθ = 0 para a rotação virtual só desta barra, tan θ = F/G
angle-of-bar-from-the-vertical = Ângulo com a vertical da barra
v-v-is-a-sum-with-one-angle-in-each-term-so-the-hessian-is-diagonal-positive-for-a-stable-equilibrium = ∂²V/∂θ²: V é uma soma com um só ângulo em cada termo, e a Hessiana é diagonal; positiva para um equilíbrio estável
second-derivative-of-the-potential-energy-for-bar = Segunda derivada da energia potencial para a barra
distance-of-the-free-end-from-the-vertical-through-the-pin = Distância da extremidade livre à vertical pela articulação fixa
depth-of-the-free-end-below-the-pin = Profundidade da extremidade livre abaixo da articulação fixa
upward-reaction-of-the-pin-all-weights-and-the-vertical-force = Reação da articulação para cima: todos os pesos e a força vertical
upward-reaction-of-the-pin = Reação da articulação para cima
no-effort-is-needed-to-hold-the-bar-there-from-the-newton-euler-equations-of-every-body = nenhum esforço é necessário para manter a barra ali, pelas equações de Newton–Euler de cada corpo
the-upward-reaction-of-the-pin-from-the-newton-euler-equations = a reação da articulação para cima pelas equações de Newton–Euler
the-bars-and-their-lower-ends = As barras e suas extremidades inferiores
bar = barra
depth = Profundidade
horizontal-distance = Distância horizontal
the-chain-in-equilibrium = A cadeia em equilíbrio

# virtual-work/lazy-tongs
lazy-tongs = Tesoura articulada
reactions-at-the-two-supports-of-a-row-of-crossed-bars-under-vertical-loads-each-found-by-releasing = Reações nos dois apoios de uma fileira de barras cruzadas sob cargas verticais, cada uma obtida liberando-se o seu apoio.
squares = Quadrados
side-of-a-square = Lado de um quadrado
angle-of-the-bars-from-the-line-ab = Ângulo das barras com a linha AB
square-counted-from-a = Quadrado, contado a partir de A
hinge = Articulação
load-downwards = Carga, para baixo
upper = Superior
lower = Inferior
square-square-does-not-exist-there-are-squares = o quadrado { $square } não existe: há { $squares }
b-released-along-the-line-virtual-displacement-y-of-the-upper-hinges-from-y-l-sin-the-lower-ones-move = B liberado ao longo da linha: deslocamento virtual δy/δθ das articulações superiores, de y = l sen θ; as inferiores descem o mesmo tanto
virtual-approach-of-b-to-a-per-unit-from-x-b-2-n-l-cos = Aproximação virtual de B a A por unidade de δθ, de x_B = 2 n l cos θ
virtual-work-against-the-load-per-unit = Trabalho virtual contra a carga por unidade de δθ
reaction-of-b-towards-a-the-total-virtual-work-of-reaction-and-loads-is-zero = Reação de B em direção a A: o trabalho virtual total da reação e das cargas é nulo
distance-between-the-supports = Distância entre os apoios
b-released-upwards-virtual-work-against-the-load-when-the-whole-linkage-rotates-about-a-by = B liberado para cima: trabalho virtual contra a carga quando todo o mecanismo gira δφ em torno de A
reaction-of-b-upwards-the-sum-of-y-b-x-b-and-the-virtual-work-of-the-loads-is-zero = Reação de B para cima: a soma de Y_B x_B δφ com o trabalho virtual das cargas é nula
reaction-of-a-upwards-both-supports-carry-all-loads = Reação de A para cima: os dois apoios sustentam todas as cargas
reaction-of-a-towards-b-equal-and-opposite-to-that-of-b = Reação de A em direção a B, igual e oposta à de B
reaction-of-b-towards-a = Reação de B em direção a A
reaction-of-b-upwards = Reação de B para cima
reaction-of-a-upwards = Reação de A para cima
reaction-of-a-towards-b = Reação de A em direção a B
the-reaction-of-b-along-the-line-from-the-newton-euler-equations-of-every-bar = a reação de B ao longo da linha pelas equações de Newton–Euler de cada barra
the-reaction-of-b-upwards-from-the-newton-euler-equations-of-every-bar = a reação de B para cima pelas equações de Newton–Euler de cada barra
the-tongs-are-nearly-fully-extended-the-support-reactions-grow-without-bound-near-that-position = a tesoura está quase toda estendida: a reação nos apoios cresce sem limite perto dessa posição
reaction-along-the-line-against-the-angle-of-the-bars = Reação ao longo da linha em função do ângulo das barras
angle-of-the-bars = ângulo das barras
reaction-towards-the-other-support = reação em direção ao outro apoio
the-tongs-between-their-supports = A tesoura entre os apoios

# virtual-work/mechanism
plane-mechanism = Mecanismo plano
motion-driving-forces-and-torques-by-virtual-power-and-reactions-of-an-arbitrary-plane-mechanism = Movimento, forças e torques motores por potência virtual e reações de um mecanismo plano qualquer: corpos, juntas, acionamentos e cargas.
points = Pontos
joints = Juntas
drivers = Acionamentos
one-for-each-degree-of-freedom-what-moves-the-mechanism-or-holds-it-in-place = Um para cada grau de liberdade: o que move o mecanismo, ou o mantém na posição.
points-whose-motion-is-computed = Pontos cujo movimento é calculado
polytropic-expansion-late-in-the-return-stroke = Expansão politrópica no fim do curso de retorno
range-of-the-first-driver-in-the-plots = Faixa do primeiro acionamento nos gráficos
point = Ponto
one-revolution-or-up-to-the-limit-positions = Uma volta, ou até as posições-limite
angles = Ângulos
from = de
to = a
lengths = Comprimentos
this-position-only = Só esta posição
angle-of-name-joint-constraints-q-0-solved-by-newton-s-method = Ângulo de { $name }: restrições das juntas, Φ(q) = 0, resolvidas pelo método de Newton
angle-of-the-body = Ângulo do corpo
angular-velocity-of-name-from-the-joint-and-driving-constraints-q-q-t = Velocidade angular de { $name }, das restrições das juntas e dos acionamentos, Φ_q q̇ = −Φ_t
angular-velocity-of-the-body = Velocidade angular do corpo
angular-acceleration-of-name-from-q-q = Aceleração angular de { $name }, de Φ_q q̈ = γ
angular-acceleration-of-the-body = Aceleração angular do corpo
position-of-name = Posição de { $name }
position-of-the-point = Posição do ponto
velocity-of-name = Velocidade de { $name }
acceleration-of-name = Aceleração de { $name }
acceleration-of-the-point = Aceleração do ponto
redundant-constraints-at-joints-the-mechanism-moves-but-statics-does-not-determine-how-the-joints = vínculos redundantes em { $joints }: o mecanismo se move, mas a estática não determina como as juntas repartem as forças
torque-of-name-the-total-virtual-power-of-all-loads-is-zero-t-w-0 = Torque de { $name }: a potência virtual total de todas as cargas é nula, T + Σ W = 0
force-of-name-from-the-principle-of-virtual-power-t-w-0 = Força de { $name }, pelo princípio das potências virtuais, T + Σ W = 0
driving-force-or-torque = Força ou torque motor
virtual-power-and-the-newton-euler-equations-give-the-same-effort-for-name = a potência virtual e as equações de Newton–Euler dão o mesmo esforço para { $name }
the-power-of-loads-and-drivers-equals-the-rate-of-change-of-the-kinetic-energy = a potência das cargas e dos acionamentos é a taxa de variação da energia cinética
rotation-of-name-per-unit-displacement-of-the-driver = Rotação de { $name } por unidade de deslocamento do acionamento
elongation-of-name-per-unit-displacement-of-the-driver = Alongamento de { $name } por unidade de deslocamento do acionamento
virtual-power-of-name = Potência virtual de { $name }
displacement-of-the-centre-of-mass-of-name-per-unit-displacement-of-the-driver = Deslocamento do centro de massa de { $name } por unidade de deslocamento do acionamento
acceleration-of-the-centre-of-mass-of-name = Aceleração do centro de massa de { $name }
displacement-of-the-point-of-name-per-unit-displacement-of-the-driver = Deslocamento do ponto de { $name } por unidade de deslocamento do acionamento
force-name-rotated-with-the-body-in-whose-axes-it-is-given = Força { $name }, girada com o corpo em cujos eixos é dada
length-of-name = Comprimento de { $name }
force-of-name-positive-when-it-pushes-its-ends-apart = Força de { $name }, positiva quando afasta as extremidades
angle-at-name = Ângulo em { $name }
couple-of-name = Binário de { $name }
rate-of-extension-of-name = Velocidade de alongamento de { $name }
force-of-the-gas-of-name-a-p-l-l-p = Força do gás de { $name }, A (p₁ (L₁/L)ⁿ − p₀)
virtual-power-of-the-friction-of-name-proportional-to-the-force-transmitted-by-its-joint = Potência virtual do atrito de { $name }, proporcional à força transmitida pela junta
force-transmitted-by-name-by-the-equations-of-newton-and-euler-m-q-q-q = Força que { $name } transmite, pelas equações de Newton e Euler, M q̈ = Q + Φ_qᵀ λ
driving-force-or-torque-of-name = Força ou torque motor de { $name }
angular-velocities = Velocidades angulares
speed-of-name = Velocidade escalar de { $name }
speed = Velocidade
acceleration = aceleração
angle-of-the-first-driver = Ângulo do primeiro acionamento
length-of-the-first-driver = Comprimento do primeiro acionamento
path-of-name = Trajetória de { $name }
here = aqui
virtual-power-of-the-loads = Potência virtual das cargas
per-unit-velocity-of-the-first-driver = Por velocidade unitária do primeiro acionamento
reaction-of-each-joint-on-its-second-point = Reação de cada junta sobre o seu segundo ponto
reaction-of-each-joint-on-each-body-in-body-axes = Reação de cada junta sobre cada corpo, nos eixos do corpo
along-its-x-axis = No seu eixo x
transverse-along-its-y-axis = Transversal, no seu eixo y
instant-centres = Centros instantâneos
transmission-angles-of-the-links-between-two-pins = Ângulos de transmissão dos elos entre dois pinos
link-at-pin = { $link } em { $pin }
link-and-pin = Elo e pino
link = Peça
minimum-over-the-range = Mínimo no percurso
instant-centres-for-the-given-motion-of-the-drivers = Centros instantâneos para o movimento dado dos acionamentos
instant-centres-when-only-the-first-driver-moves = Centros instantâneos quando só o primeiro acionamento se move
one-and-other = { $one } e { $other }
the-ground = a base
remark = Observação
at-infinity-in-the-direction-angle = no infinito, na direção { $angle }
they-do-not-move-relative-to-each-other = não se movem um em relação ao outro
forces-of-the-pins-in-the-axes-of-the-ground = Forças nos pinos, nos eixos da base
name-on-body = { $name } sobre { $body }
shaking-force-resultant-force-on-the-ground = Força de trepidação: força resultante sobre a base
joint = Junta
force-along-x = Força em x
force-along-y = Força em y
force-along-its-own-line = Força na sua própria linha
mechanism = Mecanismo
zero-for-a-body-whose-weight-and-inertia-are-neglected = Zero para um corpo com peso e inércia desprezados.
centre-of-mass-in-the-axes-of-the-body = Centro de massa, nos eixos do corpo
initial-guess-of-the-angle = Estimativa inicial do ângulo
position-in-the-axes-of-its-body = Posição, nos eixos do seu corpo
ground = Base
kind-of-joint = Tipo de junta
pin = Pino
point-that-is-pinned-to-it = Ponto preso a ele pelo pino
point-of-the-guide = Ponto da guia
direction-of-the-guide-in-the-axes-of-its-body = Direção da guia, nos eixos do seu corpo
point-that-slides-along-it = Ponto que desliza por ela
angle-of-the-sliding-body-relative-to-the-body-with-the-guide = Ângulo do corpo que desliza em relação ao corpo com a guia
pin-in-a-straight-slot = Pino em rasgo reto
point-of-the-slot = Ponto do rasgo
direction-of-the-slot-in-the-axes-of-its-body = Direção do rasgo, nos eixos do seu corpo
distance-of-the-pin-to-the-left-of-the-line = Distância do pino à esquerda da linha
weld = Solda
point-that-is-fixed-to-it = Ponto fixado a ele
angle-of-the-second-body-relative-to-the-first = Ângulo do segundo corpo em relação ao primeiro
rod-with-a-pin-at-each-end = Barra com um pino em cada extremidade
one-end = Uma extremidade
other-end = Outra extremidade
length = Comprimento
gears-in-mesh = Par de engrenagens
gear = Engrenagem
gear-that-it-meshes-with = Engrenagem com que engrena
body-that-carries-both-gears = Corpo que leva as duas engrenagens
teeth-or-pitch-radius-of-the-first = Dentes ou raio primitivo da primeira
teeth-or-pitch-radius-of-the-second = Dentes ou raio primitivo da segunda
the-second-has-internal-teeth = A segunda tem dentes internos
wheel-that-rolls-on-a-line-or-pinion-on-a-rack = Roda que rola sobre uma linha, ou pinhão em cremalheira
point-of-the-line = Ponto da linha
direction-of-the-line-in-the-axes-of-its-body = Direção da linha, nos eixos do seu corpo
centre-of-the-wheel-to-the-left-of-the-line = Centro da roda, à esquerda da linha
radius = Raio
the-line-alone-supports-the-wheel-at-this-distance = Só a linha mantém a roda a esta distância
no-for-a-pinion-that-has-a-bearing-of-its-own = Não, para um pinhão com mancal próprio.
cord-over-pulleys-and-drums = Cabo sobre polias e tambores
straight-runs = Trechos retos
drums-that-wind-the-cord = Tambores que enrolam o cabo
cam-a-rotating-body-that-moves-a-point = Came: um corpo em rotação que move um ponto
cam-body = Corpo da came
point-of-the-guide-of-the-follower = Ponto da guia do seguidor
direction-of-motion-of-the-follower-in-the-axes-of-the-body-with-the-guide = Direção do movimento do seguidor, nos eixos do corpo com a guia
point-of-the-follower = Ponto do seguidor
lift-against-the-cam-angle-over-one-revolution = Levantamento em função do ângulo da came, em uma volta
angle-of-the-cam = Ângulo da came
lift = Levantamento
rotating-body = Corpo que gira
body-relative-to-which-it-turns = Corpo em relação ao qual gira
positive-if-a-counter-clockwise-rotation-winds-in-the-cord = Positivo se uma rotação anti-horária recolhe o cabo.
driven-coordinate = Coordenada acionada
angle-of-a-body = Ângulo de um corpo
position-of-a-point = Posição de um ponto
point-from-which-it-is-measured = Ponto a partir do qual se mede
direction-of-measurement-in-the-axes-of-the-body-of-the-first-point = Direção de medição, nos eixos do corpo do primeiro ponto
position = Posição
velocity = Velocidade
distance-between-two-points-a-cylinder-a-cord-that-is-pulled = Distância entre dois pontos: um cilindro, um cabo puxado
distance = distância
kind-of-load = Tipo de carga
force-at-a-point = Força em um ponto
body-in-whose-axes-it-is-given = Corpo em cujos eixos é dada
body-it-acts-on = Corpo em que atua
body-that-takes-the-reaction = Corpo que recebe a reação
force-between-two-points = Força entre dois pontos
positive-when-it-pushes-them-apart = Positiva quando os afasta.
spring = mola
stiffness = Rigidez
length-of-the-unstretched-spring = Comprimento da mola sem deformação
torsion-spring = Mola de torção
angle-of-the-untwisted-spring = Ângulo da mola sem torção
damper = Amortecedor
damping-coefficient = Coeficiente de amortecimento
gas-between-two-points = Gás entre dois pontos
a-p-l-l-p-pushing-them-apart = `A (p₁ (L₁/L)ⁿ − p₀)`, afastando-os.
absolute-pressure-at-the-given-length = Pressão absoluta no comprimento dado
length-of-the-gas-column-at-that-pressure = Comprimento da coluna de gás nessa pressão
n-1-for-constant-temperature-1-4-for-air-without-heat = 1 para temperatura constante, 1,4 para ar sem troca de calor.
absolute-pressure-outside = Pressão absoluta externa
friction-in-a-joint = Atrito em uma junta
pin-slider-or-slot = Pino, cursor ou rasgo
coefficient-of-friction = Coeficiente de atrito
radius-of-the-pin = Raio do pino
the-lift-of-the-cam-name-needs-at-least-three-points-with-increasing-angles-within-one-revolution = o levantamento da came { $name } precisa de ao menos três pontos com ângulos crescentes dentro de uma volta
no-body-is-given-write-down-at-least-one = nenhum corpo foi dado: escreva ao menos um
the-mechanism-cannot-be-assembled-joint-remains-open-by-gap-check-the-lengths-the-driver-values-and = o mecanismo não pode ser montado: { $joint } fica aberta em { $gap }; confira os comprimentos, os valores dos acionamentos e os ângulos dos corpos
the-mechanism-does-not-reach-the-value-of-driver-choose-another = o mecanismo não alcança o valor de { $driver }; escolha outro
free-degrees-of-freedom-have-no-driver-add-a-driver-or-a-joint-for-each = { $free } graus de liberdade estão sem acionamento: acrescente um acionamento, ou uma junta, para cada
driver-is-redundant-the-joints-and-the-other-drivers-already-determine-it-remove-it = { $driver } é redundante: as juntas e os outros acionamentos já o determinam; retire-o
driver-reaches-a-limit-position-at-at-the-mechanism-does-not-move-further = { $driver } chega à posição-limite em { $at }: o mecanismo não vai além
driver-would-move-too-far-at-once-more-than-about-thirty-revolutions-choose-a-nearer-value = { $driver } se moveria demais de uma só vez: mais de cerca de trinta voltas; escolha um valor mais próximo
driver-is-at-a-dead-centre-in-this-position-it-cannot-move-the-mechanism-choose-another-value = { $driver } está em ponto morto: nesta posição não consegue mover o mecanismo; escolha outro valor
no-equilibrium-was-found-with-the-friction-in-joint-the-mechanism-is-self-locking-lower-the = não se achou equilíbrio com o atrito em { $joint }: ocorre autotravamento do mecanismo; diminua o coeficiente de atrito
load-has-an-invalid-value-or-is-friction-in-a-joint-without-sliding = { $load } tem um valor inválido, ou é atrito em uma junta que não desliza
no-equilibrium-was-found-near-the-drawn-position-draw-the-bodies-at-other-angles = nenhum equilíbrio foi encontrado perto da posição desenhada; desenhe os corpos em outros ângulos
a-length-or-a-result-is-too-large-or-too-small-for-the-mechanism-to-be-computed = um comprimento ou resultado é grande ou pequeno demais para o cálculo do mecanismo

# virtual-work/motion
a-body-comes-to-rest = Um corpo chega ao repouso
a-body-reaches-an-angle = Um corpo atinge um ângulo
angle-of-name-at-the-end = Ângulo de { $name } no fim
angular-acceleration-at-the-start = Aceleração angular no início
angular-acceleration-of-name-at-the-end = Aceleração angular de { $name } no fim
angular-acceleration-of-name-at-the-start = Aceleração angular de { $name } no início
angular-acceleration-of-name-at-the-start-of-all-accelerations-a-n-s-allowed-by-the-joints-the-one = Aceleração angular de { $name } no início: de todas as acelerações a + N s̈ que as juntas permitem, aquela com (Nᵀ M N) s̈ = Nᵀ (Q − M a), potência virtual em cada movimento livre N
angular-velocity-of-name-at-the-end = Velocidade angular de { $name } no fim
energy = Energia
energy-gained-by-weights-springs-and-constant-forces-since-the-start = Energia ganha por pesos, molas e forças constantes desde o início
energy-stored-since-the-start = Energia armazenada desde o início
force-along-the-line-of-the-joint-at-the-start = Força ao longo da linha da junta no início
force-in-the-joint-at-the-start = Força na junta no início
force-that-name-exerts-on-its-second-point-at-the-start = Força que { $name } exerce sobre o seu segundo ponto no início
force-that-name-exerts-on-its-second-point-at-the-start-from-m-q-q-q = Força que { $name } exerce sobre o seu segundo ponto no início, de M q̈ = Q + Φ_qᵀ λ
free-motion-of-a-plane-mechanism-of-any-shape-from-a-start-accelerations-by-virtual-power-joint = Movimento livre de um mecanismo plano de qualquer forma a partir de um início: acelerações pela potência virtual, forças nas juntas, energia, um filme.
kinetic = Cinética
kinetic-energy-at-the-end = Energia cinética no fim
kinetic-energy-at-the-end-t-m-v-i-g-2 = Energia cinética no fim, T = Σ (m v² + I_G ω²)/2
motion-of-a-plane-mechanism-under-its-loads = Movimento de um mecanismo plano sob suas cargas
initial-positions-and-velocities-if-none-are-given-at-rest-at-the-angles-given-for-the-bodies = Posições e velocidades iniciais; se nenhuma for dada, em repouso nos ângulos dados para os corpos.
stored = Armazenada
the-equations-of-motion-are-integrated-from-the-start-by-the-dormand-prince-method-of-order-8-with = As equações do movimento são integradas desde o início pelo método de Dormand–Prince de ordem 8, com passo controlado pelo erro; depois de cada passo as restrições das juntas são reimpostas
time-at-the-end = Tempo no fim
two-points-reach-a-distance = Dois pontos atingem uma distância
what-ends-the-motion-before = O que encerra o movimento antes
given-quantity = Grandeza dada
undriven-coordinates-move-freely-the-accelerations-of-the-drivers-stay-constant = As coordenadas sem acionamento movem-se livremente; as acelerações dos acionamentos são mantidas.
work-done = Trabalho realizado
work-done-since-the-start = Trabalho realizado desde o início
two-points-come-to-relative-rest = Dois pontos entram em repouso um em relação ao outro
friction-at-the-start = Atrito no início
sliding-velocity-against-friction-at-the-end = Velocidade de deslizamento contra o atrito no fim
name-at-the-start-its-pin-slides-with-a-friction-couple-of-r-times-the-joint-force-opposite-to-the = { $name } no início: o pino desliza, com binário de atrito de μ r vezes a força na junta, oposto ao deslizamento
name-at-the-start-its-joint-slides-with-friction-times-the-joint-force-opposite-to-the-sliding = { $name } no início: a junta desliza, com atrito de μ vezes a força na junta, oposto ao deslizamento
the-friction-at-the-onset-of-motion = o atrito no início do movimento
name-at-the-start-positive-in-the-direction-of-sliding-its-joint-sticks-since-no-possible-motion = { $name } no início, positivo no sentido do deslizamento: a junta fica em aderência, pois nenhum movimento possível venceria o atrito que encontraria
sliding-velocity-against-name-at-the-end = Velocidade de deslizamento contra { $name } no fim
at-the-end-name-is-sticking-its-joint-does-not-slide = No fim, { $name } está em aderência: a junta não desliza
at-the-start-several-joints-keep-each-other-at-rest-statics-alone-does-not-determine-how-their = no início várias juntas se mantêm em repouso umas às outras: a estática sozinha não determina como o atrito se reparte entre elas, nem as forças nas juntas
work-of-the-drivers-dampers-friction-and-follower-forces-since-the-start = Trabalho dos acionamentos, amortecedores, atrito e forças que giram com um corpo desde o início
no-free-motion-remains-the-drivers-and-joints-determine-everything-remove-a-driver-or-use-the-plane = não resta movimento livre: os acionamentos e as juntas determinam tudo; retire um acionamento ou use o mecanismo plano
the-accelerations-at-the-end-from-the-equations-of-all-bodies = as acelerações no fim pelas equações de todos os corpos
the-energy-balance-t-v-w-over-the-motion = o balanço de energia T + V − W ao longo do movimento
the-energy-balance-closes-only-to-within-left-of-size-at-a-dead-centre-or-change-point-the-motion = o balanço de energia só fecha a menos de { $left }, de { $size }: num ponto morto ou de mudança o movimento depende de algarismos perdidos ali
the-motion-does-not-come-to-its-end-within-the-duration-make-this-longer = o movimento não chega ao seu fim dentro da duração; aumente-a
the-end-condition-of-the-motion-is-not-reached-within-the-duration-increase-the-duration = a condição de fim do movimento não é atingida dentro da duração; aumente-a
load-is-friction-in-one-of-the-joints-at-rest-too-many-to-determine-which-one-begins-to-move-remove = { $load } é atrito em uma das juntas em repouso, que são demais para determinar qual começa a se mover; retire parte dele
body-can-move-freely-but-it-and-all-that-moves-with-it-are-massless-give-it-a-mass-or-drive-it = { $body } pode mover-se livremente, mas nada do que se move com ele tem massa; dê-lhe uma massa ou acione-o
row-row-of-the-start-is-redundant-it-follows-from-the-joints-the-drivers-and-the-rows-before-it = a linha { $row } da partida é redundante: resulta das juntas, dos acionamentos e das linhas anteriores; retire-a
the-motion-requires-too-many-steps-beyond-time-the-duration-is-too-long-shorten-it = o movimento exige passos demais além de { $time }: a duração é longa demais; encurte-a
the-motion-could-not-be-integrated-with-an-error-of-wanted-per-step-held-was-used-relative-to-the = o movimento não pôde ser integrado com um erro de { $wanted } por passo: foi usado { $held }, relativo ao tamanho do mecanismo e à sua velocidade máxima
the-motion-cannot-be-integrated-beyond-time-one-part-of-it-is-much-faster-than-the-rest-remove-what = o movimento não pode ser integrado além de { $time }: uma parte dele é muito mais rápida que o resto; retire o que for muito rígido ou muito leve, ou encurte a duração
the-motion-cannot-be-integrated-beyond-time-there-the-mechanism-locks-or-its-joints-no-longer = o movimento não pode ser integrado além de { $time }: ali o mecanismo trava, ou as juntas já não determinam o movimento; encurte a duração
the-duration-must-be-a-positive-number = a duração precisa ser um número positivo

# virtual-work/rack-press
rack-press = Prensa de cremalheira
ram-force-of-a-rack-press-from-the-force-on-its-handle-or-vice-versa-with-the-stroke-per-revolution = Força do êmbolo de uma prensa de cremalheira a partir da força na alavanca, ou o inverso, com o curso por volta.
length-of-the-handle = Comprimento da alavanca
pinion = Pinhão
pitch-radius-given = Raio primitivo dado
pitch-radius = Raio primitivo
module-and-number-of-teeth-given = Módulo e número de dentes dados
module = Módulo
number-of-teeth = Número de dentes
turns-of-the-handle-per-turn-of-the-pinion = Voltas da alavanca por volta do pinhão
efficiency = Rendimento
force-of-the-ram = Força do êmbolo
force-on-the-handle = Força na alavanca
force-on-the-handle-perpendicular-to-it = Força na alavanca, perpendicular a ela
a-pinion-must-have-a-whole-number-of-teeth-at-least-4 = um pinhão deve ter um número inteiro de dentes, no mínimo 4
pitch-radius-of-the-pinion = Raio primitivo do pinhão
virtual-displacement-of-the-hand-for-a-unit-rotation-of-the-handle = Deslocamento virtual da mão para uma rotação unitária δψ da alavanca
virtual-displacement-of-the-ram-per-unit-its-rack-rolls-on-the-pinion = Deslocamento virtual do êmbolo por unidade de δψ: a cremalheira rola sobre o pinhão
ideal-force-ratio-displacement-of-the-hand-over-that-of-the-ram = Razão ideal das forças: deslocamento da mão sobre o do êmbolo
the-virtual-work-of-the-hand-less-the-losses-balances-that-of-the-ram-f-s-q-x = O trabalho virtual da mão, descontadas as perdas, equilibra o do êmbolo: η F δs = Q δx
mechanical-advantage-ratio-of-ram-force-to-handle-force = Vantagem mecânica: razão entre a força do êmbolo e a da alavanca
travel-of-the-ram-per-turn-of-the-handle = Curso do êmbolo por volta da alavanca
torque-on-the-pinion = Torque no pinhão
the-torque-of-the-hand-less-the-losses-from-the-newton-euler-equations-of-handle-pinion-and-rack = o torque da mão, descontadas as perdas, pelas equações de Newton–Euler da alavanca, do pinhão e da cremalheira
the-press = A prensa

# virtual-work/rhombus
rhombus-with-a-spring = Losango com mola
equilibria-and-stability-of-a-hanging-rhombus-of-four-bars-with-a-spring-across-or-the-load-or = Equilíbrio e estabilidade de um losango suspenso de quatro barras com uma mola na diagonal, ou a carga ou rigidez para um ângulo dado.
load-at-the-lower-corner = Carga no vértice inferior
direction-of-the-spring = Direção da mola
between-the-corners-at-the-sides = Entre os vértices laterais
between-the-upper-and-the-lower-corner = Entre os vértices superior e inferior
the-angle-of-each-bar-is-measured-from-the-vertical = O ângulo θ de cada barra é medido da vertical.
sum-of-the-upward-virtual-displacements-of-the-four-centres-of-mass-per-unit = Soma dos deslocamentos virtuais dos quatro centros de massa para cima por unidade de δθ
upward-virtual-displacement-of-the-lower-corner-per-unit = Deslocamento virtual do vértice inferior para cima por unidade de δθ
the-rhombus = O losango

# virtual-work/roberval-balance
roberval-balance = Balança de Roberval
equilibrant-couple-of-a-roberval-balance-or-the-mass-that-balances-it-and-the-effect-of-the-mass = Binário equilibrante de uma balança de Roberval, ou a massa que a equilibra, e o efeito dos afastamentos das massas nas suas barras.
arm-of-the-beams-on-the-left = Braço das barras à esquerda
arm-of-the-beams-on-the-right = Braço das barras à direita
distance-between-the-beams = Distância entre as barras
mass-on-the-left-pan = Massa no prato esquerdo
distance-of-the-left-mass-from-its-stem-outwards = Distância da massa esquerda à sua haste, para fora
mass-on-the-right-pan = Massa no prato direito
if-left-blank-the-balancing-mass-is-computed = Em branco, a massa que equilibra é calculada.
distance-of-the-right-mass-from-its-stem-outwards = Distância da massa direita à sua haste, para fora
inclination-of-the-beams-the-right-side-up = Inclinação das barras, com o lado direito para cima
weight-on-the-left-pan = Peso no prato esquerdo
weight-on-the-right-pan = Peso no prato direito
downward-virtual-displacement-of-the-left-pan-per-unit-the-pans-translate-without-rotating-so-the = Deslocamento virtual do prato esquerdo para baixo por unidade de δφ: os pratos transladam sem girar, e o afastamento não importa
upward-virtual-displacement-of-the-right-pan-per-unit = Deslocamento virtual do prato direito para cima por unidade de δφ
equilibrant-couple-on-the-beams-raising-the-right-side-its-virtual-work-and-those-of-the-weights-sum = Binário equilibrante nas barras, no sentido de levantar o lado direito: a soma do seu trabalho virtual com os dos pesos é nula
equilibrant-couple-on-the-beams = Binário equilibrante nas barras
the-beams-are-vertical-no-weight-does-virtual-work = as barras estão na vertical: nenhum peso realiza trabalho virtual
weight-on-the-right-pan-the-total-virtual-work-of-both-weights-is-zero = Peso no prato direito: o trabalho virtual total dos dois pesos é nulo
balancing-mass = Massa de equilíbrio
pull-of-the-left-stem-on-the-upper-beam-and-push-on-the-lower-one-they-hold-the-stem-vertical-against = Tração da haste esquerda na barra superior e compressão na inferior: mantêm a haste na vertical contra W₁ e₁
pull-of-the-right-stem-on-the-upper-beam-and-push-on-the-lower-one-they-hold-the-stem-vertical = Tração da haste direita na barra superior e compressão na inferior: mantêm a haste na vertical contra W₂ e₂
pull-of-the-left-stem-on-the-beams = Tração da haste esquerda nas barras
pull-of-the-right-stem-on-the-beams = Tração da haste direita nas barras
the-couple-on-the-beams-from-the-newton-euler-equations-with-the-masses-at-their-offsets = o binário nas barras pelas equações de Newton–Euler, com as massas em seus afastamentos
the-balance = A balança

# virtual-work/scissor-lift
scissor-lift = Plataforma pantográfica
force-of-the-cylinder-of-a-scissor-lift-of-any-number-of-stages-or-the-load-that-it-lifts-with = Força do cilindro de uma plataforma pantográfica de qualquer número de estágios, ou a carga que ela levanta, com a velocidade de subida e as forças nos pinos.
stages = Estágios
angle-of-the-bars-from-the-horizontal = Ângulo das barras com a horizontal
number-of-frames-side-by-side-each-with-a-cylinder = Número de armações lado a lado, cada uma com um cilindro
they-share-the-load-evenly = Dividem a carga igualmente.
lower-end-of-the-cylinder = Extremidade inferior do cilindro
upper-end-of-the-cylinder = Extremidade superior do cilindro
extension-speed-of-the-cylinder = Velocidade de extensão do cilindro
if-given-the-speed-of-the-table-is-also-calculated = Se dada, a velocidade da mesa também é calculada.
on-the-ground = No solo
distance-to-the-right-of-the-fixed-foot = Distância à direita do pé fixo
height-above-the-fixed-foot = Altura acima do pé fixo
on-the-table = Na mesa
distance-to-the-right-of-the-left-joint = Distância à direita da articulação esquerda
height-above-the-joints = Altura acima das articulações
on-a-bar-that-rises-to-the-right = Em uma barra que sobe para a direita
on-a-bar-that-rises-to-the-left = Em uma barra que sobe para a esquerda
stage-numbered-from-the-bottom = Estágio, numerado de baixo para cima
distance-from-its-lower-end = Distância à sua extremidade inferior
force-of-the-cylinder = Força do cilindro
load-on-the-table = Carga na mesa
force-of-each-cylinder = Força de cada cilindro
the-cylinder-is-fixed-to-a-stage-that-the-lift-does-not-have-choose-a-lower-stage-or-more-stages = o cilindro está preso a um estágio que a plataforma não tem: escolha um estágio mais baixo ou mais estágios
horizontal-distance-between-the-ends-of-the-cylinder = Distância horizontal entre as extremidades do cilindro
vertical-distance-between-the-ends-of-the-cylinder = Distância vertical entre as extremidades do cilindro
both-ends-of-the-cylinder-are-at-the-same-point-it-has-no-length = as duas extremidades do cilindro estão no mesmo ponto: ele não tem comprimento
length-of-the-cylinder = Comprimento do cilindro
its-virtual-variation-per = Sua variação virtual por δθ
in-this-position-the-length-of-the-cylinder-does-not-change-with-the-height-of-the-table-dead-centre = nesta posição o comprimento do cilindro não muda com a altura da mesa (ponto morto): nenhuma força a levanta
virtual-elongation-of-the-cylinder-per-unit-2-c-c-2-x-x-2-y-y = Alongamento virtual do cilindro por unidade de δθ: 2 c δc = 2 Δx δΔx + 2 Δy δΔy
upward-virtual-displacement-of-the-table-per-unit-from-h-n-l-sin = Deslocamento virtual da mesa para cima por unidade de δθ, de h = n L sen θ
virtual-work-against-the-weights-of-the-2-n-bars-of-a-frame-whose-mean-rise-is-half-that-of-the-table = Trabalho virtual contra os pesos das 2 n barras de um quadro, cuja subida média é a metade da subida da mesa
the-total-virtual-work-of-cylinder-load-and-weights-of-a-frame-is-zero = O trabalho virtual total do cilindro, da carga e dos pesos de um quadro é nulo
the-cylinder-pulls-it-becomes-shorter-as-the-table-rises = o cilindro puxa: fica mais curto quando a mesa sobe
height-of-the-table = Altura da mesa
displacement-ratio-table-over-cylinder = Razão de deslocamentos, mesa sobre cilindro
speed-of-the-table = Velocidade da mesa
the-force-of-the-cylinder-from-the-newton-euler-equations-of-every-bar = a força do cilindro pelas equações de Newton–Euler de cada barra
fixed-foot = Pé fixo
sliding-foot = Pé deslizante
crossing-of-stage-stage = Cruzamento do estágio { $stage }
left-joint-over-stage-stage = Articulação esquerda sobre o estágio { $stage }
right-joint-over-stage-stage = Articulação direita sobre o estágio { $stage }
left-joint-of-the-table = Articulação esquerda da mesa
right-joint-of-the-table = Articulação direita da mesa
forces-in-the-pins-of-a-frame-the-load-in-the-middle = Forças nos pinos de um quadro, com a carga no meio
size = Tamanho
force-of-the-cylinder-against-the-angle-of-the-bars = Força do cilindro em função do ângulo das barras
the-lift = A plataforma

# virtual-work/screw-jack
screw-jack = Macaco de parafuso
axial-force-and-torque-of-a-screw-jack-a-rhombus-jack-or-a-scissor-jack-with-friction-efficiency-and = Força axial e torque de um macaco de parafuso, de losango ou de tesoura, com atrito, rendimento e autotravamento.
frame = Suporte
screw = Parafuso
if-left-blank-only-the-axial-force-is-computed = Em branco, só a força axial é calculada.
the-load-rests-on-the-screw = A carga apoia-se no parafuso
rhombus-with-the-screw-across = Losango com o parafuso na diagonal
length-of-each-link = Comprimento de cada barra
angle-of-the-links-from-the-horizontal = Ângulo das barras com a horizontal
scissors-with-the-screw-between-the-feet = Tesoura com o parafuso entre os pés
mean-diameter-of-the-thread = Diâmetro médio da rosca
lead = Avanço da rosca
travel-of-a-nut-per-turn = Deslocamento de uma porca por volta.
coefficient-of-friction-in-the-thread = Coeficiente de atrito na rosca
half-the-thread-angle = Metade do ângulo da rosca
zero-for-a-square-thread-15-for-a-trapezoidal-one = Zero para rosca quadrada, 15° para trapezoidal.
threads = Roscas
mean-diameter-of-the-collar = Diâmetro médio do colar
coefficient-of-friction-in-the-collar = Coeficiente de atrito no colar
one-nut = Uma porca
two-nuts-on-a-right-hand-and-a-left-hand-thread = Duas porcas, em rosca direita e rosca esquerda
force-and-torque-for-a-given-load = Força e torque para uma carga dada
load-raised-by-a-torque = Carga levantada por um torque
torque-on-the-screw = Torque no parafuso
load-balanced-by-an-axial-force = Carga equilibrada por uma força axial
axial-force-in-the-screw = Força axial no parafuso
axial-force-in-the-screw-from-p-y-t-x-0 = Força axial no parafuso, de P δy + T δx = 0
a-torque-needs-a-screw-write-its-diameter-and-lead = um torque precisa de um parafuso: escreva seu diâmetro e avanço
axial-force-overcome-by-the-torque = Força axial vencida pelo torque
the-axial-force-from-the-newton-euler-equations-of-every-link = a força axial pelas equações de Newton–Euler de cada barra
the-links-are-nearly-horizontal-the-axial-force-grows-without-bound-near-that-position = as barras estão quase na horizontal: a força axial cresce sem limite perto dessa posição
upward-virtual-displacement-of-the-load-per-unit-from-y-2-l-sin = Deslocamento virtual da carga para cima por unidade de δθ, de y = 2 L sen θ
upward-virtual-displacement-of-the-load-per-unit-from-y-n-l-sin = Deslocamento virtual da carga para cima por unidade de δθ, de y = n L sen θ
virtual-approach-of-the-nuts-per-unit-from-x-2-l-cos = Aproximação virtual das porcas por unidade de δθ, de x = 2 L cos θ
virtual-approach-of-the-feet-per-unit-from-x-l-cos = Aproximação virtual dos pés por unidade de δθ, de x = L cos θ
height-of-the-load = Altura da carga
ratio-of-axial-force-to-load-displacement-of-the-load-over-that-of-the-screw = Razão entre força axial e carga: deslocamento da carga sobre o do parafuso
ratio-of-axial-force-to-load = Razão entre força axial e carga
load-from-p-y-t-x-0 = Carga, de P δy + T δx = 0
lead-angle-of-the-thread = Ângulo de hélice da rosca
angle-of-friction-on-the-flanks-of-the-thread = Ângulo de atrito nos flancos da rosca
angle-of-friction = Ângulo de atrito
lead-angle-and-friction-angle-of-the-thread-together-reach-90-the-thread-jams-and-no-torque-raises = o ângulo de hélice e o de atrito da rosca somam 90°: a rosca trava e nenhum torque levanta a carga
torque-per-unit-axial-force-raising = Torque por unidade de força axial, ao levantar
torque-per-unit-axial-force-lowering-negative-where-the-load-drives-the-screw = Torque por unidade de força axial, ao baixar; negativo quando a carga gira o parafuso
torque-per-unit-axial-force-without-friction-m-t-2-for-each-nut = Torque por unidade de força axial sem atrito: M δψ = T ℓ δψ/2π para cada porca
torque-to-raise-the-load = Torque para levantar a carga
torque-to-lower-the-load = Torque para baixar a carga
efficiency-torque-without-friction-divided-by-the-torque-with-friction = Rendimento: torque sem atrito dividido pelo torque com atrito
the-screw-is-not-self-locking-when-released-it-turns-back-under-the-load = o parafuso não é autotravante: ao ser solto, gira de volta sob a carga
the-raising-torque-from-t-d-2-d-d = o torque de levantamento por T d/2 (ℓ + π μ′ d)/(π d − μ′ ℓ)
axial-force-against-the-angle-of-the-links = Força axial em função do ângulo das barras
angle-of-the-links = ângulo das barras
axial-force = Força axial
the-jack = O macaco

# virtual-work/spring-lever
arm-with-a-spring = Braço com mola
all-equilibria-of-a-loaded-arm-restrained-by-a-spring-with-their-stability-or-the-load-or-stiffness = Todas as posições de equilíbrio de um braço carregado e preso por mola, com a sua estabilidade; ou a carga ou rigidez para um ângulo dado.
the-arm-at-0 = O braço em θ = 0
upright = Para cima
vertical-upwards = Na vertical, para cima
horizontal-to-the-right = Horizontal, para a direita
the-load-on-the-arm-moves-down-as-increases = A carga no braço desce quando θ cresce.
hanging = Pendente
inclined-from-the-vertical-position = Inclinado em relação à posição vertical
angle-from-the-vertical-inverted-position-clockwise = Ângulo a partir da posição vertical (invertida), no sentido horário
mass-on-the-arm = Massa no braço
distance-of-its-centre-from-the-pivot = Distância do seu centro ao pivô
vertical-force-on-the-arm = Força vertical no braço
force-downwards = Força, para baixo
distance-of-its-point-from-the-pivot = Distância do seu ponto ao pivô
couple-on-the-arm = Binário no braço
couple-in-the-sense-of = Binário, no sentido de θ
torsion-spring-at-the-pivot = Mola de torção no pivô
angle-at-which-the-spring-is-untwisted = Ângulo com a mola sem torção
zero-if-omitted = Zero se omitido.
spring-on-a-cord-around-a-drum = Mola em um cabo ao redor de um tambor
the-drum-is-fixed-to-the-arm = O tambor é solidário ao braço.
radius-of-the-drum = Raio do tambor
spring-between-the-arm-and-a-fixed-point = Mola entre o braço e um ponto fixo
distance-of-its-end-on-the-arm-from-the-pivot = Distância de sua ponta no braço ao pivô
angle-of-that-end-from-the-line-of-the-arm-clockwise = Ângulo dessa ponta em relação à linha do braço, no sentido horário
n-180-on-the-other-side-of-the-pivot = 180° do outro lado do pivô.
distance-of-its-fixed-end-from-the-pivot = Distância de sua ponta fixa ao pivô
angle-of-the-fixed-end-from-the-arm-at-0-clockwise = Ângulo da ponta fixa em relação ao braço em θ = 0, no sentido horário
unstretched = Sem alongamento
at-a-given-angle-of-the-arm = Em um ângulo dado do braço
angle-of-the-arm = Ângulo do braço
at-a-given-length = Em um comprimento dado
unstretched-length = Comprimento natural
two-springs-one-on-each-side = Duas molas, uma de cada lado
perpendicular-to-the-arm-at-0-unstretched-there-and-long-enough-to-keep-their-direction = Perpendiculares ao braço em θ = 0, ali sem alongamento, e longas o bastante para conservar a direção.
stiffness-of-each = Rigidez de cada uma
distance-from-the-pivot = Distância ao pivô
moment-of-the-load-about-the-pivot-with-the-arm-horizontal = Momento da carga em relação ao pivô com o braço horizontal
angle-at-the-pivot-between-the-two-ends-of-the-spring-at-0-at-it-is = Ângulo no pivô entre as duas pontas da mola em θ = 0; em θ é θ + ψ₀
unstretched-length-by-the-law-of-cosines = Comprimento natural, pela lei dos cossenos
length-of-the-spring-by-the-law-of-cosines = Comprimento da mola, pela lei dos cossenos
its-virtual-variation-per-2-s-s-2-b-d-sin = Sua variação virtual por δθ: 2 s δs = 2 b d sen(θ + ψ₀) δθ
derivative-of-that-change = Derivada dessa variação
derivative-of-the-spring-length-at-0 = Derivada do comprimento da mola em θ = 0
extension-of-the-spring-times-its-virtual-change-per-unit-the-couple-of-the-spring-is-k-u = Alongamento da mola vezes sua variação virtual por unidade de δθ: o binário da mola é k u′
equilibrant-couple-on-the-arm = Binário equilibrante no braço
equilibrant-couple-on-the-arm-in-the-sense-of-t-plus-the-virtual-work-of-spring-and-load-is-zero = Binário equilibrante no braço, no sentido de θ: a soma de T δθ com os trabalhos virtuais da mola e da carga é nula
load-whose-virtual-work-balances-that-of-the-spring = Carga cujo trabalho virtual equilibra o da mola
mass-of-that-weight = Massa desse peso
mass-for-equilibrium-at-this-angle = Massa para o equilíbrio neste ângulo
force-for-equilibrium-at-this-angle = Força para o equilíbrio neste ângulo
couple-for-equilibrium-at-this-angle = Binário para o equilíbrio neste ângulo
stiffness-for-equilibrium-at-this-angle = Rigidez para o equilíbrio neste ângulo
stiffness-for-which-the-virtual-work-of-the-spring-equals-that-of-the-load = Rigidez para a qual o trabalho virtual da mola é igual ao da carga
stiffness-at-which-d-v-d-0-at-0-a-larger-stiffness-holds-the-arm-vertical = Rigidez em que d²V/dθ² = 0 em θ = 0: uma rigidez maior mantém o braço na vertical
load-at-which-d-v-d-0-at-0-with-a-smaller-load-the-vertical-inverted-position-is-stable = Carga em que d²V/dθ² = 0 em θ = 0: com carga menor a posição vertical (invertida) é estável
critical-stiffness-of-the-vertical-inverted-position = Rigidez crítica da posição vertical (invertida)
critical-mass-of-the-vertical-inverted-position = Massa crítica da posição vertical (invertida)
critical-force-of-the-vertical-inverted-position = Força crítica da posição vertical (invertida)
the-second-derivative-of-the-potential-energy-at-0-with-the-critical-stiffness = a segunda derivada da energia potencial em θ = 0 com a rigidez crítica
the-holding-couple-from-the-newton-euler-equations = o binário de sustentação pelas equações de Newton–Euler
load-or-stiffness-is-missing-write-it-or-write-the-angle-at-which-the-arm-is-to-be-in-equilibrium = a carga ou a rigidez está em branco: escreva-a, ou escreva o ângulo em que o braço deve estar em equilíbrio
both-load-and-stiffness-are-missing-the-angle-determines-only-one-of-them = a carga e a rigidez estão ambas em branco: o ângulo determina apenas uma delas
at-this-angle-the-arm-is-vertical-the-load-does-no-work-and-cannot-be-determined = neste ângulo o braço está na vertical: a carga não realiza trabalho e não pode ser determinada
at-this-angle-the-spring-is-unstretched-or-its-force-passes-through-the-pivot-the-stiffness-cannot-be = neste ângulo a mola não está alongada ou a sua força passa pelo pivô: a rigidez não pode ser determinada
the-stiffness-is-negative-at-this-angle-load-and-spring-turn-the-arm-in-the-same-sense = a rigidez é negativa: neste ângulo a carga e a mola giram o braço no mesmo sentido
the-arm-about-its-position = O braço em torno de sua posição
load-balanced-by-the-spring-against-the-angle = Carga equilibrada pela mola, em função do ângulo
load-in-equilibrium = carga em equilíbrio
couple-in-equilibrium = binário em equilíbrio
held = sustentada
this-load = esta carga
angle = Ângulo

# virtual-work/toggle-press
toggle-press = Prensa de joelho
thrust-of-a-toggle-press-from-the-force-on-its-knee-or-vice-versa-with-the-forces-in-its-links = Empuxo de uma prensa de joelho a partir da força no joelho, ou o inverso, com as forças em suas barras.
length-of-the-link-at-the-fixed-pin = Comprimento da barra no pino fixo
length-of-the-link-at-the-ram = Comprimento da barra no êmbolo
angle-of-the-link-at-the-fixed-pin-from-the-line-of-thrust = Ângulo da barra no pino fixo com a linha de empuxo
thrust-of-the-ram = Empuxo do êmbolo
force-on-the-knee-perpendicular-to-the-line-of-thrust = Força no joelho, perpendicular à linha de empuxo
force-on-the-knee = Força no joelho
height-of-the-knee-above-the-line-of-thrust = Altura do joelho acima da linha de empuxo
the-link-at-the-ram-does-not-reach-the-line-of-thrust-it-is-short-too-short = a barra no êmbolo não alcança a linha de empuxo: faltam { $short }
angle-of-the-link-at-the-ram-both-links-meet-at-the-knee-l-sin-l-sin = Ângulo da barra no êmbolo: as duas barras se encontram no joelho, L₁ sen α = L₂ sen β
upward-virtual-displacement-of-the-knee-per-unit = Deslocamento virtual do joelho para cima por unidade de δα
virtual-rotation-of-the-link-at-the-ram-l-cos-l-cos = Rotação virtual da barra no êmbolo: L₂ cos β δβ = L₁ cos α δα
virtual-retraction-of-the-ram-per-unit-from-x-l-cos-l-cos = Recuo virtual do êmbolo por unidade de δα, de x = L₁ cos α + L₂ cos β
mechanical-advantage-displacement-of-the-knee-over-that-of-the-ram = Vantagem mecânica: deslocamento do joelho sobre o do êmbolo
p-y-q-x-0-the-virtual-works-of-the-knee-force-and-of-the-thrust-cancel = P δy + Q δx = 0: os trabalhos virtuais da força no joelho e do empuxo se anulam
compression-of-the-link-at-the-fixed-pin-from-the-forces-on-the-knee-perpendicular-to-the-line-of = Compressão da barra no pino fixo, pelas forças no joelho perpendiculares à linha de empuxo
compression-of-the-link-at-the-ram-along-the-line-of-thrust-it-is-q = Compressão da barra no êmbolo: na direção da linha de empuxo é Q
force-of-the-guide-on-the-ram-perpendicular-to-the-line-of-thrust = Força da guia no êmbolo, perpendicular à linha de empuxo
remaining-stroke-of-the-ram-until-the-links-are-collinear = Curso restante do êmbolo até o alinhamento das barras
compression-of-the-link-at-the-fixed-pin = Compressão da barra no pino fixo
compression-of-the-link-at-the-ram = Compressão da barra no êmbolo
force-of-the-guide-on-the-ram = Força da guia no êmbolo
the-thrust-from-p-q-tan-tan = o empuxo por P = Q (tan α + tan β)
the-forces-along-the-line-of-thrust-at-the-knee = as forças no joelho ao longo da linha de empuxo
the-thrust-from-the-newton-euler-equations-of-every-body = o empuxo pelas equações de Newton–Euler de cada corpo
the-force-on-the-fixed-pin-from-the-newton-euler-equations = a força no pino fixo pelas equações de Newton–Euler
the-links-are-nearly-collinear-clearances-and-the-stiffness-of-the-frame-not-this-ratio-limit-the = as barras estão quase alinhadas: as folgas e a rigidez da estrutura, e não esta razão, limitam o empuxo
mechanical-advantage-against-the-angle = Vantagem mecânica em função do ângulo
angle-of-the-link-at-the-fixed-pin = ângulo da barra no pino fixo
thrust-over-force-on-the-knee = empuxo sobre força no joelho
the-press-closing = A prensa fechando
length-of-the-cord-between-bar-and-pulley-by-the-law-of-cosines = Comprimento do cabo entre a barra e a polia, pela lei dos cossenos
its-virtual-elongation-per-equal-to-the-rise-of-the-hanging-mass-2-s-s-2-b-h-cos = Seu alongamento virtual por δθ, igual à subida da massa suspensa: 2 s δs = −2 b h cos θ δθ
upward-virtual-displacement-of-the-hanging-mass-per-unit = Deslocamento virtual da massa suspensa para cima por unidade de δθ

# virtual-work/two-bar-linkage
two-bars-with-a-sliding-end = Duas barras com extremidade deslizante
equilibria-and-stability-of-two-equal-hinged-bars-with-a-sliding-end-or-the-force-or-stiffness-for-a = Equilíbrio e estabilidade de duas barras articuladas iguais com extremidade deslizante, ou a força ou rigidez para um ângulo dado.
joint-b-between-the-bars = Articulação B entre as barras
below-the-line-ac = Abaixo da linha AC
above-the-line-ac = Acima da linha AC
vertical-force-at-the-joint-b-downwards = Força vertical na articulação B, para baixo
horizontal-force-at-c-away-from-a = Força horizontal em C, afastando-se de A
spring-between-a-and-c = Mola entre A e C
the-angle-of-each-bar-is-measured-from-the-line-ac = O ângulo θ de cada barra é medido da linha AC.
sum-of-the-upward-virtual-displacements-of-the-two-centres-of-mass-per-unit = Soma dos deslocamentos virtuais dos dois centros de massa para cima por unidade de δθ
upward-virtual-displacement-of-b-per-unit = Deslocamento virtual de B para cima por unidade de δθ
virtual-displacement-of-c-towards-a-per-unit = Deslocamento virtual de C em direção a A por unidade de δθ
vertical-force-at-b = Força vertical em B
horizontal-force-at-c = Força horizontal em C
the-two-bars = As duas barras

# virtual-work/virtual-power
virtual-power = Potência virtual
driving-torque-or-force-of-a-plane-mechanism-with-known-motion-from-the-powers-of-forces-couples = Torque ou força motriz de um mecanismo plano de movimento conhecido, pelas potências de forças, binários, pesos e ações de inércia.

# Inputs
acceleration-of-gravity = Aceleração da gravidade
every-body-has-the-weight-m-g-at-its-centre-of-mass-zero-for-a-mechanism-in-a-horizontal-plane = Cada corpo tem o peso m g no centro de massa; zero para um mecanismo em plano horizontal.
bodies = Corpos
forces = Forças
couples = Binários
the-mechanism-is-a-slider-crank = O mecanismo é um cursor-manivela
the-given-motion-is-then-checked-against-loop-closure = O movimento dado é então verificado pelo fechamento da cadeia.
driving-torque-on-a-link = Torque motor em um elo
link-it-acts-on = Elo em que atua
driving-force-at-a-point = Força motriz em um ponto
direction-of-the-force = Direção da força
any-vector-along-its-line-the-force-is-positive-in-this-direction = Qualquer vetor na sua linha de ação; a força é positiva nesse sentido.
point-that-it-acts-on = Ponto em que atua
rotating-at = Girando com
angular-velocity-of-the-link = Velocidade angular do elo
one-of-the-bodies = Um dos corpos
body = Corpo
moving-at = Movendo-se com
velocity-of-the-point = Velocidade do ponto
centre-of-mass-of-a-body = Centro de massa de um corpo
name = Nome
given-name = { $given_name }
mass = Massa
velocity-of-the-centre-of-mass = Velocidade do centro de massa
acceleration-of-the-centre-of-mass = Aceleração do centro de massa
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
negative-where-the-rod-slopes-down-towards-the-slider = Negativo quando a biela desce em direção ao cursor.
lengths-and-angle-of-the-crank = Comprimentos e ângulo da manivela
length-of-the-crank = Comprimento da manivela
length-of-the-rod = Comprimento da biela
offset = Excentricidade
height-of-the-slider-s-line-above-the-bearing-of-the-crank = Altura da linha do cursor acima do mancal da manivela.
angular-acceleration-of-the-crank = Aceleração angular da manivela

# Powers
power-of-the-force-name = Potência da força { $name }
power-of-the-couple-name = Potência do binário { $name }
weight-of-name = Peso de { $name }
power-of-the-weight-of-name = Potência do peso de { $name }
inertia-force-of-name-opposite-to-the-acceleration = Força de inércia de { $name }, contrária à aceleração
power-of-the-inertia-force-of-name = Potência da força de inércia de { $name }
inertia-couple-of-name-opposite-to-the-angular-acceleration = Binário de inércia de { $name }, contrário à aceleração angular
power-of-the-inertia-couple-of-name = Potência do binário de inércia de { $name }
power-of-the-forces = Potência das forças
power-of-the-couples = Potência dos binários
power-of-the-weights = Potência dos pesos
power-of-the-inertia-forces = Potência das forças de inércia
power-of-the-inertia-couples = Potência dos binários de inércia
power-of-all-known-loads = Potência de todas as cargas conhecidas
power-of-the-inertia-force-of-the-rod = Potência da força de inércia da biela
power-of-the-inertia-force-of-the-slider = Potência da força de inércia do cursor

# The unknown
driving-torque = Torque motor
driving-force = Força motriz
driving-torque-from-the-principle-of-virtual-power-t-t-p-0 = Torque motor, pelo princípio das potências virtuais, T ω_T + ΣP = 0
unit-vector-along-the-driving-force = Vetor unitário na direção da força motriz
velocity-of-its-point-along-the-driving-force = Velocidade do ponto na direção da força motriz
driving-force-from-the-principle-of-virtual-power-f-v-p-0 = Força motriz, pelo princípio das potências virtuais, F v + ΣP = 0
the-power-of-all-applied-loads-equals-the-rate-of-change-of-the-kinetic-energy = a potência de todas as ações aplicadas é a taxa de variação da energia cinética

# Refusals
no-load-is-given-write-down-a-force-a-couple-or-a-body-with-a-mass = nenhuma ação foi dada: escreva uma força, um binário ou um corpo com massa
the-driven-link-is-at-rest-its-torque-has-no-power-so-the-sum-of-powers-cannot-determine-it = o elo acionado está parado: seu torque não tem potência, e a soma das potências não pode determiná-lo
the-driven-point-is-at-rest-its-force-has-no-power-so-the-sum-of-powers-cannot-determine-it = o ponto acionado está parado: sua força não tem potência, e a soma das potências não pode determiná-la
the-direction-of-the-driving-force-has-no-length-write-any-vector-along-its-line-such-as-1-0 = a direção da força motriz tem comprimento nulo: escreva qualquer vetor na sua linha de ação, como (1; 0)
the-driving-force-is-perpendicular-to-the-velocity-of-its-point-it-has-no-power-so-the-sum-of-powers = a força motriz é perpendicular à velocidade do seu ponto: não tem potência, e a soma das potências não pode determiná-la

# Table of powers
powers-of-the-loads = Potências das ações
load = Carga
power = Potência
share-of-the-power-input = Parcela da potência fornecida
total = Total
force-name = Força { $name }
couple-name = Binário { $name }
inertia-force-of-name = Força de inércia de { $name }
inertia-couple-of-name = Binário de inércia de { $name }

# Closure of the slider-crank
angular-velocity-of-the-rod-from-loop-closure-in-line-mechanism = Velocidade angular da biela pelo fechamento da cadeia centrada
length-of-the-crank-from-the-velocity-of-the-slider = Comprimento da manivela, pela velocidade do cursor
length-of-the-rod-from-loop-closure-in-line-mechanism = Comprimento da biela pelo fechamento da cadeia centrada
angle-of-the-rod-from-loop-closure = Ângulo da biela pelo fechamento da cadeia
angular-velocity-of-the-rod-from-loop-closure = Velocidade angular da biela pelo fechamento da cadeia
velocity-of-the-slider-that-closes-the-loop = Velocidade do cursor que fecha a cadeia
angular-acceleration-of-the-crank-corresponding-to-that-of-the-rod = Aceleração angular da manivela correspondente à da biela
angular-acceleration-of-the-rod-from-loop-closure = Aceleração angular da biela pelo fechamento da cadeia
acceleration-of-the-slider-from-loop-closure = Aceleração do cursor pelo fechamento da cadeia
with-these-angles-the-in-line-loop-does-not-close-or-is-at-a-dead-centre-the-given-motion-could-not = com estes ângulos a cadeia centrada não fecha, ou está em ponto morto: o movimento dado não pôde ser verificado com ela
no-crank-of-positive-length-gives-the-slider-the-given-velocity-at-these-angles = nenhuma manivela de comprimento positivo dá ao cursor a velocidade dada com estes ângulos
the-rod-does-not-reach-the-slider-s-line-at-this-crank-angle-or-is-perpendicular-to-it-the-given = neste ângulo da manivela a biela não alcança a linha do cursor, ou está perpendicular a ela: o movimento dado não pôde ser verificado pelo fechamento da cadeia
the-given-vectors-belong-to-no-slider-crank-of-this-geometry-the-sum-of-powers-holds-for-the-vectors = os vetores dados não pertencem a nenhum cursor-manivela desta geometria; a soma das potências vale para os vetores como estão
what-given-given-loop-closure-requires-demanded-difference-apart-share-of-the-larger = { $what }: dado { $given }, o fechamento da cadeia exige { $demanded } (diferença de { $apart }, { $share } do maior)
angular-velocity-of-the-rod = velocidade angular da biela
angular-acceleration-of-the-rod = aceleração angular da biela
velocity-of-the-slider = Velocidade do cursor
acceleration-of-the-slider = aceleração do cursor
velocity-of-the-rod-s-centre-of-mass-in-magnitude = velocidade do centro de massa da biela, em módulo
acceleration-of-the-rod-s-centre-of-mass-in-magnitude = aceleração do centro de massa da biela, em módulo
given-motion-and-motion-required-by-loop-closure = Movimento dado e movimento exigido pelo fechamento da cadeia
quantity = Grandeza
given = Dado
demanded = Exigido
required = Exigido
apart = Diferença
difference = Diferença
fraction-of-the-larger-value = Fração do valor maior
the-slider-crank-with-given-velocities-and-forces = O cursor-manivela com as velocidades e forças dadas

# built
weight-link = Peso: { $link }
inertia-force-link = Força de inércia: { $link }
inertia-couple-link = Binário de inércia: { $link }
virtual-work-of-each-load = Trabalho virtual de cada carga
work-per-unit-of-the-coordinate = Trabalho por unidade da coordenada
the-effort-from-the-newton-euler-equations-of-every-link = o esforço pelas equações de Newton–Euler de cada elo
the-links-do-not-close-the-loop-gap-short-change-a-length-or-the-position = os elos não fecham a cadeia: faltam { $gap }; mude um comprimento ou a posição
in-this-position-the-coordinate-does-not-determine-the-motion-dead-centre-change-it-slightly = nesta posição a coordenada não determina o movimento (ponto morto); altere-a um pouco
no-equilibrium-was-found-with-friction-the-mechanism-jams = não se achou equilíbrio com o atrito: o mecanismo trava
the-numbers-of-this-mechanism-differ-too-much-in-magnitude-to-be-computed-with = os números deste mecanismo têm ordens de grandeza díspares demais para o cálculo
f-x-m-a-gx-for-the-whole-mechanism = ΣF_x = Σm a_Gx para o mecanismo inteiro
f-y-m-a-gy-for-the-whole-mechanism = ΣF_y = Σm a_Gy para o mecanismo inteiro
from-the-equations-of-newton-and-euler-of-every-link-solved-together = Pelas equações de Newton e Euler de todos os elos, resolvidas em conjunto
force-in-the-joint = Força na junta

# works
uniform-slender-bar = Barra esbelta uniforme
its-centre-of-mass-is-in-the-middle-and-its-moment-of-inertia-is-m-l-12 = O centro de massa fica no meio e o momento de inércia é m l²/12.
mass-centre-of-mass-and-moment-of-inertia = Massa, centro de massa e momento de inércia
distance-of-the-centre-of-mass-from-the-first-pin = Distância do centro de massa ao primeiro pino
the-first-pin-of-a-crank-or-rocker-is-the-fixed-one-that-of-a-coupler-is-the-crank-pin = O primeiro pino de uma manivela ou de um balancim é o fixo; o de um acoplador é o pino da manivela.
angle-of-the-centre-of-mass-from-the-line-of-the-pins = Ângulo do centro de massa em relação à linha dos pinos
virtual-displacement-of-point-per-unit-of-the-coordinate = Deslocamento virtual de { $point } por unidade da coordenada
acceleration-of-point = Aceleração de { $point }
virtual-work-of-the-force-at-point-force-times-displacement = Trabalho virtual da força em { $point }: força vezes deslocamento
virtual-work-of-the-couple-on-link-n-couple-times-rotation = Trabalho virtual do binário no elo { $n }: binário vezes rotação
virtual-work-of-the-weight-of-link-n = Trabalho virtual do peso do elo { $n }
virtual-work-of-the-inertia-force-m-a-of-link-n = Trabalho virtual da força de inércia −m a do elo { $n }
link-n-is-a-uniform-bar-from-its-first-pin-to-its-middle = O elo { $n } é uma barra uniforme: do primeiro pino ao meio
moment-of-inertia-of-the-uniform-bar-link-n = Momento de inércia da barra uniforme, elo { $n }
from-the-first-pin-of-link-n-to-its-centre-of-mass = Do primeiro pino do elo { $n } ao seu centro de massa
virtual-work-of-the-inertia-couple-i-of-link-n = Trabalho virtual do binário de inércia −I α do elo { $n }
virtual-work-of-all-known-loads = Trabalho virtual de todas as ações conhecidas

# dyad
angle-of-link-n = Ângulo do elo { $n }
angle-of-that-line = Ângulo dessa linha
angular-acceleration-of-link-n = Aceleração angular do elo { $n }
angular-velocity-of-link-n = Velocidade angular do elo { $n }
from-from-to-to = De { $from } a { $to }
distance-of-the-slider-s-line-to-the-left-of-point = Distância da linha do cursor à esquerda de { $point }
law-of-cosines-angle-between-that-line-and-link-n = Lei dos cossenos: ângulo entre essa linha e o elo { $n }
link-n-has-its-length = o elo { $n } tem o seu comprimento
link-n-is-perpendicular-to-the-line-of-its-slider-limit-position-change-the-coordinate-slightly = o elo { $n } está perpendicular à linha do seu cursor (posição-limite): altere um pouco a coordenada
links-one-and-two-are-collinear-dead-centre-the-coordinate-does-not-determine-their-motion-change-it = os elos { $one } e { $two } estão alinhados (ponto morto): a coordenada não determina o seu movimento; altere-a um pouco
position-of-the-slider-along-its-line = Posição do cursor ao longo da sua linha
the-loop-does-not-close-from-and-to-are-distance-apart-gap-less-than-links-one-and-two-can-fold-to = a cadeia não fecha: { $from } e { $to } distam { $distance }, { $gap } menos do que os elos { $one } e { $two } alcançam dobrados
the-loop-does-not-close-from-and-to-are-distance-apart-gap-more-than-links-one-and-two-can-span = a cadeia não fecha: { $from } e { $to } distam { $distance }, { $gap } mais do que os elos { $one } e { $two } alcançam
the-loop-does-not-close-the-line-of-the-slider-is-distance-away-from-point-and-link-n-is-gap-too = a cadeia não fecha: a linha do cursor dista { $distance } de { $point }, e faltam { $gap } ao elo { $n }
vector-of-link-n = Vetor do elo { $n }
vector-of-link-n-which-closes-the-loop = Vetor do elo { $n }, que fecha a cadeia
virtual-displacement-of-the-slider-per-unit-of-the-coordinate = Deslocamento virtual do cursor por unidade da coordenada
virtual-rotation-of-link-n-displacement-of-the-common-pin-along-both-paths-dotted-with-the-vector-of = Rotação virtual do elo { $n }: deslocamento do pino comum pelos dois caminhos, em produto escalar com o vetor do elo { $m }
virtual-rotation-of-link-n-the-slider-stays-on-its-line = Rotação virtual do elo { $n }: o cursor permanece na sua linha
relative-acceleration-to-be-compensated-by-the-angular-accelerations-of-the-pair = Aceleração relativa a compensar pelas acelerações angulares do par

# slider-crank
angle-of-the-rod-r-sin-2-l-sin-3-e = Ângulo da biela: r sen θ_2 + l sen θ_3 = e
angular-velocity-of-the-rod-from-the-closure-of-the-loop = velocidade angular da biela pelo fechamento da cadeia
at-this-angle-the-rod-has-to-span-distance-from-the-crank-pin-to-the-line-of-the-slider-it-is-gap-too = neste ângulo a biela precisa vencer { $distance } do pino da manivela à linha do cursor: faltam { $gap }
crank-and-rod-are-collinear-dead-centre-no-force-on-the-slider-can-balance-a-torque-rotate-the-crank = manivela e biela estão alinhadas (ponto morto): nenhuma força no cursor equilibra um torque; gire um pouco a manivela
force-in-the-bearing-of-the-crank = Força no mancal da manivela
force-in-the-crank-pin = Força no pino da manivela
force-in-the-pin-of-the-slider = Força no pino do cursor
force-of-the-guide-on-the-slider = Força da guia sobre o cursor
force-of-the-guide-on-the-slider-perpendicular-to-its-line-by-the-same-equations = Força da guia sobre o cursor, perpendicular à sua linha, pelas mesmas equações
force-on-the-crank-pin = Força aplicada ao pino da manivela
force-on-the-slider = Força no cursor
ratio-of-the-force-on-the-slider-to-the-force-perpendicular-to-the-crank-at-its-pin-t-r-neglecting = Razão entre a força no cursor e a força perpendicular à manivela no seu pino, T/r, sem massas
force-over-one-revolution = Força ao longo da volta
force-from-the-principle-of-virtual-work-f-b-u-b-w-0 = Força, pelo princípio dos trabalhos virtuais, F_B u_B + ΣδW = 0
from-the-bearing-to-the-crank-pin = Do mancal ao pino da manivela
from-the-slider-s-line-counter-clockwise = A partir da linha do cursor, no sentido anti-horário.
it-acts-on-the-crank = Atua na manivela.
mass-of-the-crank = Massa da manivela
position-of-the-slider = Posição do cursor
positive-away-from-the-bearing-of-the-crank-along-x = Positiva ao afastar-se do mancal da manivela, ao longo de x.
positive-counter-clockwise = Positivo no sentido anti-horário.
the-rod-is-perpendicular-to-the-line-of-the-slider-limit-position-the-crank-angle-does-not-determine = a biela está perpendicular à linha do cursor (posição-limite): o ângulo da manivela não determina o movimento; altere-o um pouco
the-slider-crank = O cursor-manivela
torque-on-the-crank-or-force-on-the-slider-of-a-slider-crank-at-rest-or-in-motion-with-masses-by = Torque na manivela ou força no cursor de um cursor-manivela, em repouso ou em movimento com massas, por trabalho virtual; movimento, ângulo de transmissão e reações.
torque-over-one-revolution = Torque ao longo da volta
velocity-of-the-slider-from-the-closure-of-the-loop = velocidade do cursor pelo fechamento da cadeia
virtual-displacement-of-the-slider-for-2-1-x-b-r-sin-2-2-l-sin-3-3 = Deslocamento virtual do cursor para δθ_2 = 1: δx_B = −r sen θ_2 δθ_2 − l sen θ_3 δθ_3
virtual-rotation-of-the-rod-for-2-1-r-cos-2-2-l-cos-3-3-0 = Rotação virtual da biela para δθ_2 = 1: r cos θ_2 δθ_2 + l cos θ_3 δθ_3 = 0
virtual-work-of-the-force-on-the-slider = Trabalho virtual da força no cursor
virtual-work-of-the-torque-for-2-1 = Trabalho virtual do torque para δθ_2 = 1
zero-for-a-mechanism-in-a-horizontal-plane = Zero para um mecanismo em plano horizontal.
zero-in-statics = Zero em problemas de estática.
no-load-does-work-there-is-nothing-to-balance = Nenhuma carga realiza trabalho: não há o que equilibrar

# four-bar
angle-of-the-coupler = Ângulo do acoplador
angle-of-the-rocker = Ângulo do balancim
angular-acceleration-of-the-coupler = Aceleração angular do acoplador
angular-acceleration-of-the-coupler-from-the-derivatives-of-the-loop-equation = aceleração angular do acoplador pelas derivadas da equação da cadeia
angular-acceleration-of-the-rocker = Aceleração angular do balancim
angular-acceleration-of-the-rocker-from-the-derivatives-of-the-loop-equation = aceleração angular do balancim pelas derivadas da equação da cadeia
angular-accelerations = Acelerações angulares
angular-velocity-of-the-coupler = Velocidade angular do acoplador
ratio-of-angular-velocities-coupler-to-crank = Razão de velocidades angulares, acoplador/manivela
angular-velocity-of-the-rocker = Velocidade angular do balancim
ratio-of-angular-velocities-rocker-to-crank = Razão de velocidades angulares, balancim/manivela
ratio-of-angular-velocity-to-that-of-the-crank = Razão entre a velocidade angular e a da manivela
between-the-fixed-pins = Entre os pinos fixos.
change-point-all-links-can-become-collinear = ponto de mudança: todos os elos podem ficar colineares
grashof-class = Classe de Grashof
coupler-curve = Curva do acoplador
crank-and-coupler-are-collinear-and-the-rocker-reverses-no-torque-on-the-rocker-can-balance-one-on = manivela e acoplador estão alinhados e o balancim inverte o movimento: nenhum torque no balancim equilibra um na manivela; gire um pouco a manivela
crank-angle-from = Ângulo da manivela desde
crank-angle-to = Ângulo da manivela até
crank-from-o-to-a = Manivela, de O a A
crank-rocker-the-crank-rotates-fully = manivela-balancim: a manivela dá a volta completa
distance-from-the-crank-pin-along-the-coupler = Distância ao pino da manivela ao longo do acoplador
distance-from-the-line-of-the-pins-to-its-left = Distância à linha dos pinos, para a sua esquerda
distance-of-the-crank-pin-from-instant-centre-13 = Distância do pino da manivela ao centro instantâneo 13
distance-of-the-crank-pin-from-instant-centre-13-a-2-i13-a-3 = Distância do pino da manivela ao centro instantâneo 13: a ω_2 = |I13 A| ω_3
double-crank-crank-and-rocker-rotate-fully = dupla manivela: manivela e balancim dão a volta completa
non-grashof-double-rocker-no-link-rotates-fully = duplo balancim, não Grashof: nenhum elo dá a volta completa
grashof-double-rocker-the-coupler-rotates-fully = duplo balancim de Grashof: o acoplador dá a volta completa
force-in-the-fixed-pin-of-the-crank = Força no pino fixo da manivela
force-in-the-fixed-pin-of-the-rocker = Força no pino fixo do balancim
force-in-the-pin-of-coupler-and-rocker = Força no pino entre acoplador e balancim
force-on-the-point-of-the-coupler = Força no ponto do acoplador
from-the-crank-pin-to-the-point-of-the-coupler = Do pino da manivela ao ponto do acoplador
instant-centre-24-is-on-the-line-of-the-coupler = o centro instantâneo 24 está na linha do acoplador
instant-centre-24-on-the-line-of-the-frame-from-o = Centro instantâneo 24 na linha da base, a partir de O
instant-centre-24-on-the-line-of-the-frame-x-2-x-d-4 = Centro instantâneo 24, na linha da base: x ω_2 = (x − d) ω_4
maximum-angle-of-the-crank-coupler-and-rocker-collinear-extended = Ângulo máximo da manivela: acoplador e balancim colineares (estendidos)
maximum-angle-of-the-crank-from-the-frame = Ângulo máximo da manivela, a partir da base
minimum-angle-of-the-crank-coupler-and-rocker-collinear-folded = Ângulo mínimo da manivela: acoplador e balancim colineares (dobrados)
minimum-angle-of-the-crank-from-the-frame = Ângulo mínimo da manivela, a partir da base
minimum-transmission-angle-sampled-over-the-revolution = Ângulo de transmissão mínimo, amostrado na volta
length-of-the-coupler = Comprimento do acoplador
length-of-the-frame = Comprimento da base
length-of-the-rocker = Comprimento do balancim
mass-of-the-coupler = Massa do acoplador
mass-of-the-rocker = Massa do balancim
mechanical-advantage-ratio-of-rocker-torque-to-crank-torque-neglecting-masses = Vantagem mecânica: razão entre o torque do balancim e o da manivela, sem massas
point-of-the-coupler = Ponto do acoplador
positive-counter-clockwise-as-it-acts-on-the-rocker = Positivo no sentido anti-horário, como atua no balancim.
property = Propriedade
rocker-crank-the-driven-link-rotates-fully-the-crank-oscillates = balancim-manivela: o elo movido dá a volta completa, a manivela oscila
the-four-bar-linkage = O quadrilátero articulado
the-transmission-angle-is-angle-below-40-force-transmission-is-poor-and-the-joint-forces-are-large = o ângulo de transmissão é { $angle }: abaixo de 40° a transmissão de força é ruim e as forças nas juntas são grandes
torque-on-crank-or-rocker-of-a-four-bar-linkage-at-rest-or-in-motion-with-masses-by-virtual-work = Torque na manivela ou no balancim de um quadrilátero articulado, em repouso ou em movimento com massas, por trabalho virtual; curva do acoplador, centros instantâneos, ângulo de transmissão, reações.
torque-on-the-rocker = Torque no balancim
torque-on-the-rocker-the-total-virtual-work-is-zero-t-4-h-4-w-0 = Torque no balancim: o trabalho virtual total é nulo, T_4 h_4 + ΣδW = 0
torque-the-total-virtual-work-is-zero-t-2-2-w-0 = Torque: o trabalho virtual total é nulo, T_2 δθ_2 + ΣδW = 0
transmission-angle = Ângulo de transmissão
transmission-angle-the-acute-angle-between-the-rod-and-the-normal-of-the-slider-s-line-90-3 = Ângulo de transmissão: o ângulo agudo entre a biela e a normal à linha do cursor, 90° − |θ_3|
minimum-transmission-angle-over-a-revolution = Ângulo de transmissão mínimo na volta
minimum-transmission-angle-over-a-revolution-crank-perpendicular-to-the-slider-s-line-crank-pin = Ângulo de transmissão mínimo na volta: manivela perpendicular à linha do cursor, com o seu pino o mais longe dela
transmission-angle-the-acute-angle-between-coupler-and-rocker = Ângulo de transmissão: o ângulo agudo entre acoplador e balancim
rotation-of-the-coupler-from-the-derivatives-of-the-loop-equation = rotação do acoplador pelas derivadas da equação da cadeia
rotation-of-the-rocker-from-the-derivatives-of-the-loop-equation = rotação do balancim pelas derivadas da equação da cadeia
value = Valor
velocity-ratios = Razões de velocidades
kinematic-properties-of-the-linkage = Propriedades cinemáticas do mecanismo

# quick-return
a-force-perpendicular-to-the-lever-at-its-end = Uma força perpendicular à alavanca na sua ponta
a-slider-through-a-link-shaper = Um cursor por meio de uma biela: plaina limadora
above-the-pivot-of-the-lever-the-slider-moves-along-x = Acima do pivô da alavanca; o cursor move-se ao longo de x.
ahead = À frente
angle-of-the-lever = Ângulo da alavanca
angular-acceleration-of-the-lever = Aceleração angular da alavanca
angular-velocity-of-the-lever = Velocidade angular da alavanca
ratio-of-angular-velocities-lever-to-crank = Razão de velocidades angulares, alavanca/manivela
behind = Atrás
distance-of-the-crank-pin-from-the-pivot-of-the-lever = Distância do pino da manivela ao pivô da alavanca
distance-between-the-pivots = Distância entre os pivôs
force-in-the-pivot-of-the-lever = Força no pivô da alavanca
force-of-the-lever-on-the-crank-pin-perpendicular-to-the-lever = Força da alavanca sobre o pino da manivela, perpendicular à alavanca
force-of-the-lever-on-the-crank-pin-perpendicular-to-the-lever-by-the-same-equations = Força da alavanca sobre o pino da manivela, perpendicular à alavanca, pelas mesmas equações
force-on-the-output = Força na saída
force-from-the-principle-of-virtual-work-f-u-w-0 = Força, pelo princípio dos trabalhos virtuais, F u + ΣδW = 0
from-its-pivot-to-its-end = Do pivô à ponta.
from-the-pivot-of-the-lever-to-the-crank-pin = Do pivô da alavanca ao pino da manivela
from-the-x-axis-counter-clockwise-at-90-the-crank-points-away-from-the-lever-s-pivot = A partir do eixo x, no sentido anti-horário; a 90° a manivela aponta para longe do pivô da alavanca.
height-of-the-slider-s-line = Altura da linha do cursor
length-of-the-lever = Comprimento da alavanca
length-of-the-link = Comprimento da biela
lever-from-c-to-its-end-b = Alavanca, de C à ponta B
mass-of-the-lever = Massa da alavanca
mass-of-the-link = Massa da biela
on-the-slider-along-x-on-the-lever-perpendicular-to-it-at-its-end-counter-clockwise = No cursor, ao longo de x; na alavanca, perpendicular a ela na ponta, no sentido anti-horário.
quick-return-mechanism = Mecanismo de retorno rápido
viewed-from-the-end-of-the-lever-along-x = Visto da ponta da alavanca, ao longo de x.
side-of-the-slider = Lado do cursor
swing-of-the-lever = Oscilação da alavanca
the-crank-pivot-is-above-the-lever-pivot = O pivô da manivela fica acima do da alavanca.
the-crank-pin-is-at-the-pivot-of-the-lever-the-lever-has-no-direction-turn-the-crank-or-change-a = o pino da manivela está no pivô da alavanca: a alavanca não tem direção; gire a manivela ou mude um comprimento
the-lever-is-perpendicular-to-the-line-of-the-pivots-sin-d-r = A alavanca é perpendicular à linha dos pivôs: sen ψ = d/r
the-lever-is-tangent-to-the-crank-pin-circle-half-its-swing-sin-r-d = A alavanca tangencia o círculo do pino da manivela: metade da oscilação, sen ψ = r/d
the-output-reverses-here-dead-centre-no-force-on-it-can-balance-a-torque-on-the-crank-rotate-the = a saída inverte aqui o movimento (ponto morto): nenhuma força nela equilibra um torque na manivela; gire um pouco a manivela
the-quick-return-mechanism = O mecanismo de retorno rápido
forward-over-return-time-at-constant-speed-from-the-crank-angles-between-the-ends = Tempo de avanço sobre o de retorno, a velocidade constante, pelos ângulos da manivela entre os extremos
time-ratio-forward-over-return = Razão de tempos, avanço sobre retorno
torque-or-force-motion-with-coriolis-acceleration-time-ratio-and-reactions-of-crank-and-slotted-lever = Torque ou força, movimento com aceleração de Coriolis, razão de tempos e reações de manivela e alavanca ranhurada, Whitworth e plaina limadora.
unit-vector-along-the-lever = Vetor unitário ao longo da alavanca
velocity-of-the-crank-pin-along-the-lever = Velocidade do pino da manivela ao longo da alavanca
velocity-of-the-crank-pin-along-the-slot = Velocidade do pino da manivela ao longo da ranhura
velocity-of-the-lever-under-the-crank-pin = Velocidade da alavanca sob o pino da manivela
velocity-ratio = Razão de velocidades
virtual-displacement-of-the-end-of-the-lever-across-it = Deslocamento virtual da ponta da alavanca, transversal a ela
virtual-rotation-of-the-lever-it-follows-the-crank-pin-across-its-slot = Rotação virtual da alavanca: acompanha o pino da manivela transversalmente à ranhura
virtual-work-of-the-force-on-the-output = Trabalho virtual da força na saída
output-of-the-lever = Saída da alavanca

# scotch-yoke
acceleration-of-the-yoke = Aceleração do garfo
amplitude-of-the-torque-of-the-force = Amplitude do torque da força
force-of-the-yoke-on-the-crank-pin-along-x = Força do garfo sobre o pino da manivela, ao longo de x
force-of-the-yoke-on-the-crank-pin-along-x-by-the-same-equations = Força do garfo sobre o pino da manivela, ao longo de x, pelas mesmas equações
force-on-the-yoke = Força no garfo
maximum-torque-over-a-revolution-in-magnitude = Torque máximo na volta, em módulo
position-of-the-yoke = Posição do garfo
position-of-the-yoke-that-of-the-crank-pin-along-x = Posição do garfo: a do pino da manivela ao longo de x
scotch-yoke = Garfo escocês
the-crank-lies-along-the-line-of-the-yoke-dead-centre-no-force-on-the-yoke-can-balance-a-torque = a manivela está na linha do garfo (ponto morto): nenhuma força no garfo equilibra um torque; gire um pouco a manivela
the-scotch-yoke = O garfo escocês
torque-on-the-crank-or-force-on-the-yoke-of-a-scotch-yoke-at-rest-or-in-motion-by-virtual-work = Torque na manivela ou força no garfo de um garfo escocês, em repouso ou em movimento, por trabalho virtual; movimento harmônico e reações.
twice-the-amplitude-of-the-torque-of-the-inertia-force = O dobro da amplitude do torque da força de inércia
velocity-of-the-yoke = Velocidade do garfo
virtual-displacement-of-the-yoke-for-2-1-x-r-sin-2-2 = Deslocamento virtual do garfo para δθ_2 = 1: δx = −r sen θ_2 δθ_2
virtual-work-of-the-force-on-the-yoke = Trabalho virtual da força no garfo
where-sin-a-b-cos-is-a-maximum-2b-cos-a-cos-b-0-in-magnitude-of-the-cosine = Onde sen θ (A + B cos θ) é máximo: 2B cos² θ + A cos θ − B = 0, em módulo do cosseno
from-the-line-of-the-yoke-counter-clockwise = A partir da linha do garfo, no sentido anti-horário.
mass-of-the-yoke = Massa do garfo
along-x = Ao longo de x.
yoke = garfo

# rolling-disc
acceleration-of-the-centre = Aceleração do centro
acceleration-of-the-centre-of-the-disc = Aceleração do centro do disco
angle-of-the-rod-r-sin-2-l-sin-3-0 = Ângulo da biela: r sen θ_2 + l sen θ_3 = 0
crank-and-rod-are-collinear-dead-centre-no-force-on-the-disc-can-balance-a-torque-rotate-the-crank = manivela e biela estão alinhadas (ponto morto): nenhuma força no disco equilibra um torque; gire um pouco a manivela
rolling-disc-driven-by-a-crank = Disco em rolamento acionado por manivela
force-on-the-centre-of-the-disc = Força no centro do disco
friction-at-the-floor-turns-the-disc-r-f-i-with-a-r-positive-along-x = O atrito no piso gira o disco: R f = I α com α = −a/R, positivo ao longo de x
friction-force-of-the-floor = Força de atrito do piso
minimum-coefficient-of-friction-to-prevent-slip = Coeficiente de atrito mínimo para não deslizar
length-of-the-spring = Comprimento da mola
moment-of-inertia-of-a-thin-ring = Momento de inércia de um anel fino
moment-of-inertia-of-a-uniform-disc = Momento de inércia de um disco uniforme
normal-force-of-the-floor = Força normal do piso
normal-force-of-the-floor-upwards-by-the-same-equations = Força normal do piso, para cima, pelas mesmas equações
position-of-the-centre = Posição do centro
position-of-the-centre-of-the-disc = Posição do centro do disco
the-centre-of-the-disc-is-not-on-the-far-side-of-the-wall-move-the-wall-away-from-the-disc = o centro do disco não está do outro lado da parede: afaste a parede do disco
the-friction-is-the-effort-that-keeps-the-disc-from-slipping = o atrito é o esforço que impede o disco de escorregar
the-rod-lifts-the-disc-off-the-floor-it-cannot-roll-here = a biela levanta o disco do piso: aqui ele não pode rolar
the-rolling-disc = O disco que rola
torque-on-a-crank-that-rolls-a-disc-without-slip-against-spring-and-damper-by-virtual-work-friction = Torque numa manivela que faz rolar um disco sem escorregar contra mola e amortecedor, por trabalho virtual; atrito no piso e o coeficiente necessário.
velocity-of-the-centre = Velocidade do centro
velocity-of-the-centre-of-the-disc = Velocidade do centro do disco
virtual-displacement-of-the-centre-for-2-1 = Deslocamento virtual do centro para δθ_2 = 1
virtual-work-of-the-damper-c-v-u = Trabalho virtual do amortecedor, −c v u
virtual-work-of-the-force-on-the-centre-of-the-disc = Trabalho virtual da força no centro do disco
virtual-work-of-the-inertia-couple-the-disc-turns-by-u-r-a-r = Trabalho virtual do binário de inércia: o disco gira de −u/R, α = −a/R
virtual-work-of-the-spring-k-s-l-0-u = Trabalho virtual da mola, −k (s − L_0) u

# six-bar
a-force-along-the-line-of-a-slider-or-a-torque-on-a-second-rocker = Uma força ao longo da linha de um cursor, ou um torque em um segundo balancim.
a-point-of-its-line = Um ponto da sua linha
a-second-rocker = Um segundo balancim
a-slider = Um cursor
angle-of-link-5 = Ângulo do elo 5
angle-of-the-second-rocker = Ângulo do segundo balancim
angular-acceleration-of-the-second-rocker = Aceleração angular do segundo balancim
angular-velocity-of-the-second-rocker = Velocidade angular do segundo balancim
ratio-of-angular-velocities-second-rocker-to-crank = Razão de velocidades angulares, segundo balancim/manivela
direction-of-its-line = Direção da sua linha
displacement-of-the-slider-per-unit-rotation-of-the-crank = Deslocamento do cursor por rotação unitária da manivela
distance-from-the-fixed-pin-along-the-rocker = Distância ao pino fixo, ao longo do balancim
distance-from-the-line-of-its-pins-to-its-left = Distância à linha dos seus pinos, para a esquerda dela
force-along-its-line = Força ao longo da sua linha
force-in-the-pin-of-the-second-pair = Força no pino do segundo par
from-the-first-pin-of-its-link-to-d = Do primeiro pino do seu elo até D
from-the-x-axis-counter-clockwise-positive-direction-of-the-slider = A partir do eixo x, no sentido anti-horário; sentido positivo do cursor.
its-fixed-pin = Seu pino fixo
its-length = Seu comprimento
length-of-link-5 = Comprimento do elo 5
link-5 = elo 5
load-on-the-output = Carga na saída
load-from-the-principle-of-virtual-work = Carga, pelo princípio dos trabalhos virtuais
mass-of-link-5 = Massa do elo 5
mass-of-the-second-rocker = Massa do segundo balancim
on-the-coupler-stephenson = No acoplador: Stephenson
on-the-rocker-watt = No balancim: Watt
open-the-pin-of-links-5-and-6-is-to-the-left-of-the-line-from-d-to-e = Aberta: o pino dos elos 5 e 6 está à esquerda da linha de D a E.
output = saída
point-d-from-the-origin = Ponto D, a partir da origem
second-rocker = segundo balancim
viewed-from-the-attachment-point-of-the-pair-along-the-line = Visto do ponto de fixação do par, ao longo da linha.
six-bar-linkage = Mecanismo de seis barras
swing-of-the-second-rocker = Oscilação do segundo balancim
the-output-is-a-rocker-give-its-load-as-a-torque-on-the-second-rocker = a saída é um balancim: dê a sua carga como torque no segundo balancim
the-output-is-a-slider-give-its-load-as-a-force-on-the-slider = a saída é um cursor: dê a sua carga como força no cursor
the-output-reverses-here-dead-centre-no-load-on-it-can-balance-a-torque-on-the-crank-rotate-the-crank = a saída inverte aqui o movimento (ponto morto): nenhuma carga nela equilibra um torque na manivela; gire um pouco a manivela
the-six-bar-linkage = O mecanismo de seis barras
torque-on-the-second-rocker = Torque no segundo balancim
torque-or-load-of-watt-and-stephenson-six-bars-with-a-slider-or-a-second-rocker-at-rest-or-in-motion = Torque ou carga de mecanismos de seis barras de Watt e Stephenson com cursor ou segundo balancim, em repouso ou em movimento com massas, por trabalho virtual.
torque-positive-counter-clockwise = Torque, positivo no sentido anti-horário
unit-vector-along-the-line-of-the-slider = Vetor unitário ao longo da linha do cursor
unknown-with-a-given-torque-on-the-crank = Incógnita, com torque dado na manivela
virtual-work-of-the-load-on-the-output = Trabalho virtual da carga na saída
displacement-of-the-slider = Deslocamento do cursor
output-of-link-5 = Saída do elo 5
attachment-of-the-second-pair = Fixação do segundo par

# rolling-disc, inputs
along-x-from-the-bearing-of-the-crank-on-the-side-opposite-to-the-travel-of-the-disc = Ao longo de x, a partir do mancal da manivela; do lado oposto ao percurso do disco.
damper-along-the-floor = Amortecedor ao longo do piso
free-length = Comprimento livre
from-the-line-of-the-disc-s-centre-counter-clockwise = A partir da linha do centro do disco, no sentido anti-horário.
moment-of-inertia-of-the-disc = Momento de inércia do disco
position-of-the-wall = Posição da parede
spring-from-a-wall-to-the-centre = Mola de uma parede ao centro
thin-ring = Anel fino
uniform-disc = Disco uniforme

# five-bar
angle-of-the-first-crank = Ângulo da primeira manivela
angle-of-the-first-rod = Ângulo da primeira biela
angle-of-the-second-crank = Ângulo da segunda manivela
independent-two-degrees-of-freedom = Independentes: dois graus de liberdade
geared-together-one-degree-of-freedom = Engrenadas entre si: um grau de liberdade
length-of-the-first-crank = Comprimento da primeira manivela
length-of-the-first-rod = Comprimento da primeira biela
length-of-the-second-crank = Comprimento da segunda manivela
length-of-the-second-rod = Comprimento da segunda biela
mesh = Engrenamento
external-teeth-opposite-senses = Dentes externos: sentidos opostos
path = trajetória
side-on-which-the-rods-meet = Lado em que as bielas se encontram
teeth-of-the-gear-on-the-first-crank = Dentes da engrenagem da primeira manivela
teeth-of-the-gear-on-the-second-crank = Dentes da engrenagem da segunda manivela
through-an-idler-or-internal-teeth-the-same-sense = Por roda intermediária ou dentes internos: o mesmo sentido
to-the-left-looking-from-a-to-b = À esquerda, olhando de A para B
to-the-right-looking-from-a-to-b = À direita, olhando de A para B
torques-on-the-cranks = Torques nas manivelas
angle-of-the-second-rod = Ângulo da segunda biela
b-from-the-origin = B, a partir da origem
both-cranks-move-the-point-p-along-the-same-line-the-torques-do-not-determine-the-force-perpendicular = as duas manivelas movem o ponto P na mesma linha: os torques não determinam a força transversal a ela; gire um pouco uma manivela
determinant-of-the-two-displacements-of-p = Determinante dos dois deslocamentos de P
displacement-of-p-for-2-1-by-the-first-crank-and-through-the-gears-by-the-second = Deslocamento de P para δθ_2 = 1: pela primeira manivela e, por meio das engrenagens, pela segunda
first-crank = primeira manivela
first-crank-from-o-to-a = Primeira manivela, de O a A
first-rod = primeira biela
five-bar-linkage = Mecanismo de cinco barras
force-in-the-fixed-pin-of-the-first-crank = Força no pino fixo da primeira manivela
force-in-the-fixed-pin-of-the-second-crank = Força no pino fixo da segunda manivela
force-at-the-common-pin-of-the-rods = Força no pino comum das bielas
force-at-the-common-pin-of-the-rods-along-x = Força no pino comum das bielas, ao longo de x
force-at-the-common-pin-of-the-rods-along-y = Força no pino comum das bielas, ao longo de y
holding-torques-of-a-five-bar-linkage-with-two-driven-cranks-or-geared-to-one-degree-of-freedom-for-a = Torques equilibrantes de um mecanismo de cinco barras com duas manivelas acionadas, ou engrenado com um grau de liberdade, para uma força no pino comum das bielas, por trabalho virtual; ou a força pelos torques.
path-of-the-common-pin-of-the-rods = Trajetória do pino comum das bielas
second-crank = segunda manivela
second-crank-from-c-to-b = Segunda manivela, de C a B
second-rod = segunda biela
t-2-f-u-p2-0-and-t-5-f-u-p5-0-solved-for-the-force-along-x = T_2 + F · u_P2 = 0 e T_5 + F · u_P5 = 0, resolvidas para a força ao longo de x
teeth-as-given = Dentes, como dados
the-five-bar-linkage = O mecanismo de cinco barras
the-gears-leave-one-degree-of-freedom-one-torque-cannot-determine-both-components-of-the-force-give = as engrenagens deixam um grau de liberdade: um torque não determina as duas componentes da força; dê a força e escolha o torque como incógnita
the-other-rod-moves-the-common-pin-in-the-same-way = a outra biela move o pino comum da mesma forma
the-same-two-equations-solved-for-the-force-along-y = As mesmas duas equações, resolvidas para a força ao longo de y
torque-on-the-first-crank = Torque na primeira manivela
torque-on-the-first-crank-t-2-2-f-u-p-0 = Torque na primeira manivela: T_2 δθ_2 + F · u_P = 0
torque-on-the-first-crank-the-second-fixed-t-2-2-f-u-p2-0 = Torque na primeira manivela, com a segunda fixa: T_2 δθ_2 + F · u_P2 = 0
torque-on-the-second-crank = Torque na segunda manivela
torque-on-the-second-crank-the-first-fixed-t-5-5-f-u-p5-0 = Torque na segunda manivela, com a primeira fixa: T_5 δθ_5 + F · u_P5 = 0
torques-over-one-revolution-of-the-first-crank = Torques ao longo de uma volta da primeira manivela
virtual-rotation-of-the-second-crank-for-2-1-by-the-gears = Rotação virtual da segunda manivela para δθ_2 = 1, pelas engrenagens

# epicyclic-train
a-ring-of-ring-teeth-leaves-no-room-for-the-planets-around-a-sun-of-sun-teeth-give-the-ring-more = uma coroa de { $ring } dentes não deixa espaço para os satélites em torno de um solar de { $sun } dentes: dê mais dentes à coroa
both-suns-have-the-same-speed-relative-to-the-arm-so-the-arm-cannot-move-while-one-is-fixed-change-a = os dois solares têm a mesma velocidade em relação ao braço, e o braço não se move com um deles fixo: mude um número de dentes
driving-member = Membro motor
epicyclic-gear-train = Trem epicicloidal
fixed-member = Membro fixo
it-meshes-with-external-teeth-of-the-driving-member-and-turns-about-a-fixed-axis = Engrena com dentes externos do membro motor e gira em torno de um eixo fixo.
known-torque = Torque conhecido
load-on-the-driven-member = Carga no membro movido
no-member-is-left-to-be-driven = não resta membro a ser movido
external-teeth-of-the-driving-member = Dentes externos do membro motor
pinion-that-drives-the-driving-member = Pinhão que aciona o membro motor
power-of-the-driving-shaft = Potência do eixo motor
ratio-of-the-speeds-from-the-meshes-of-the-gears = razão das velocidades pelos engrenamentos
ratio-with-the-arm-fixed-ring-or-second-sun-over-sun-each-external-mesh-reverses-the-sense = Razão com o braço fixo: coroa (ou segundo solar) sobre solar; cada engrenamento externo inverte o sentido
ring-or-second-sun = Coroa, ou segundo solar
speed-of-the-driven-member = Velocidade do membro movido
speed-of-the-driven-member-over-that-of-the-driving-shaft = Velocidade do membro movido sobre a do eixo motor
speed-of-the-driven-member-over-that-of-the-pinion = Velocidade do membro movido sobre a do pinhão
speed-of-the-driving-shaft = Rotação do eixo motor
speed-of-the-planet-relative-to-the-arm = Velocidade do satélite em relação ao braço
speed-of-the-planet-relative-to-the-arm-it-meshes-with-the-sun = Velocidade do satélite em relação ao braço: engrena com o solar
speed-of-the-planet-relative-to-the-arm-it-rolls-on-the-fixed-sun = Velocidade do satélite em relação ao braço: rola sobre o solar fixo
speeds-of-all-members-of-an-epicyclic-train-by-willis-s-formula-and-driving-load-and-holding-torques = Velocidades de todos os membros de um trem epicicloidal pela fórmula de Willis, e torques motor, de carga e de retenção por potência virtual.
ring-and-sun-differ-by-an-odd-number-planets-of-planet-teeth-cannot-be-cut-compound-planets-or = coroa e solar diferem de um número ímpar: satélites de { $planet } dentes não podem ser cortados; são necessários satélites compostos ou perfis deslocados
sun = Solar
sun-compound-planets-ring-with-internal-teeth = Solar, satélites compostos, coroa de dentes internos
sun-planets-ring-with-internal-teeth = Solar, satélites, coroa de dentes internos
teeth-as-given-or-as-required-by-the-centre-distance = Dentes, como dados ou como exigidos pela distância entre eixos
teeth-of-the-first-sun = Dentes do primeiro solar
teeth-of-the-pinion = Dentes do pinhão
teeth-of-the-planet-on-the-first-sun = Dentes do satélite no primeiro solar
teeth-of-the-planet-on-the-ring = Dentes do satélite na coroa
teeth-of-the-planet-on-the-second-sun = Dentes do satélite no segundo solar
teeth-of-the-planet-on-the-sun = Dentes do satélite no solar
teeth-of-the-ring = Dentes da coroa
teeth-of-the-second-sun = Dentes do segundo solar
teeth-of-the-sun = Dentes do solar
speed-of-the-pinion-if-present = Velocidade do pinhão, se houver.
the-epicyclic-train = O trem epicicloidal
the-fixed-member-cannot-drive-choose-two-different-members-of-sun-ring-and-arm = o membro fixo não pode ser motor: escolha dois membros diferentes entre solar, coroa e braço
the-load-from-the-newton-euler-equations-of-every-gear = a carga pelas equações de Newton–Euler de cada engrenagem
the-pinion-turns-the-driving-member-in-the-opposite-sense = O pinhão gira o membro motor no sentido oposto
the-second-sun-with-external-teeth-takes-the-place-of-the-ring = O segundo solar, de dentes externos, ocupa o lugar da coroa.
equilibrium-of-the-three-torques-on-sun-ring-and-arm-holding-torque-of-the-fixed-member = Equilíbrio dos três torques em solar, coroa e braço: torque de retenção do membro fixo
torque-of-the-load-on-the-driven-member = Torque da carga no membro movido
torque-of-the-pinion-on-the-driving-member-the-same-virtual-power = Torque do pinhão no membro motor: a mesma potência virtual
torque-on-the-driving-member = Torque no membro motor
torque-on-the-driving-shaft = Torque no eixo motor
holding-torque-of-the-fixed-member = Torque de retenção do membro fixo
two-suns-compound-planets = Dois solares, satélites compostos
virtual-power-t-in-in-t-out-out-0-torque-of-the-load-on-the-driven-member = Potência virtual, T_in ω_in + T_out ω_out = 0: torque da carga no membro movido
virtual-power-t-in-in-t-out-out-0-torque-on-the-driving-shaft = Potência virtual, T_in ω_in + T_out ω_out = 0: torque no eixo motor
willis-r-a-e-s-a-with-the-arm-fixed-driven-over-driver = Willis, ω_R − ω_A = e (ω_S − ω_A), com o braço fixo: movido sobre motor
willis-r-a-e-s-a-with-the-ring-fixed-driven-over-driver = Willis, ω_R − ω_A = e (ω_S − ω_A), com a coroa fixa: movido sobre motor
willis-r-a-e-s-a-with-the-sun-fixed-driven-over-driver = Willis, ω_R − ω_A = e (ω_S − ω_A), com o solar fixo: movido sobre motor
# virtual-work/equilibrium
equilibrium-of-a-mechanism = Equilíbrio de um mecanismo
all-equilibrium-positions-of-an-arbitrary-plane-mechanism-from-its-potential-energy-with-their = Todas as posições de equilíbrio de um mecanismo plano qualquer, pela energia potencial, com a sua estabilidade.
coordinates = Coordenadas
one-for-each-degree-of-freedom-the-quantity-free-to-vary = Uma para cada grau de liberdade: a grandeza que pode variar.
search-region = Região de busca
between-two-angles-of-the-single-coordinate = Entre dois ângulos da única coordenada
between-two-lengths-of-the-single-coordinate = Entre dois comprimentos da única coordenada
near-the-given-values-of-the-coordinates = Perto dos valores dados das coordenadas
with-several-coordinates-a-range-cannot-be-searched-search-near-the-values-of-the-coordinates = com várias coordenadas não se percorre uma faixa: procure perto dos valores das coordenadas
the-range-does-not-match-the-coordinate-an-angle-requires-angles-a-length-or-a-distance-requires = a faixa não combina com a coordenada: um ângulo exige ângulos, uma posição ou distância exige comprimentos
the-mechanism-does-not-move-beyond-end-nothing-was-searched-beyond-it = o mecanismo não vai além de { $end }: dali em diante nada foi procurado
there-is-no-equilibrium-in-this-range-the-holding-effort-does-not-change-sign-search-a-wider-one = não há equilíbrio nesta faixa: o esforço de sustentação não troca de sinal; procure em uma faixa maior
value-of-name-where-the-virtual-work-of-all-loads-is-zero-w-dv-dq-q-0 = Valor de { $name } em que o trabalho virtual de todas as cargas é nulo, δW = −dV/dq δq = 0
coordinate-at-equilibrium = Coordenada no equilíbrio
second-derivative-of-the-potential-energy-with-respect-to-name-stability = Segunda derivada da energia potencial em relação a { $name }: { $stability }
second-derivative-of-the-potential-energy = Segunda derivada da energia potencial
lowest-eigenvalue-of-the-matrix-of-second-derivatives-scaled-to-a-diagonal-of-ones-positive-in-a = Menor autovalor da matriz das segundas derivadas, escalada para diagonal unitária: positivo em um equilíbrio estável
lowest-eigenvalue-of-the-second-derivatives = Menor autovalor das segundas derivadas
the-derivative-of-the-potential-energy-with-respect-to-name-is-zero = a derivada da energia potencial em relação a { $name } é nula
finite-differences-of-the-potential-energy-reproduce-the-second-derivative-with-respect-to-name = as diferenças finitas da energia potencial reproduzem a segunda derivada em relação a { $name }
stability = Estabilidade
positions-of-equilibrium = Posições de equilíbrio
equilibrant-force-or-torque-of-the-mechanism = Força ou torque equilibrante do mecanismo
neutral = indiferente

# oscillating-cylinder
acceleration-of-the-piston-in-the-cylinder = Aceleração do pistão no cilindro
angle-of-the-cylinder = Ângulo do cilindro
angular-acceleration-of-the-cylinder = Aceleração angular do cilindro
angular-acceleration-of-the-cylinder-minus-the-coriolis-term = Aceleração angular do cilindro, descontado o termo de Coriolis
angular-velocity-of-the-cylinder = Velocidade angular do cilindro
crank-and-cylinder-are-collinear-dead-centre-no-force-of-the-cylinder-can-balance-a-torque-rotate-the = manivela e cilindro estão alinhados (ponto morto): nenhuma força do cilindro equilibra um torque; gire um pouco a manivela
cylinder = Cilindro
distance-of-its-centre-of-mass-from-its-fixed-pin = Distância do seu centro de massa ao pino fixo
fixed-pin-of-the-cylinder = Pino fixo do cilindro
ratio-of-the-force-perpendicular-to-the-crank-at-its-pin-t-r-to-the-force-of-the-cylinder-neglecting = Razão entre a força perpendicular à manivela no seu pino, T/r, e a força do cilindro, sem massas
force-in-the-fixed-pin-of-the-cylinder = Força no pino fixo do cilindro
force-of-the-cylinder-pressure-times-area-of-the-bore = Força do cilindro: pressão vezes área do diâmetro interno
force-of-the-cylinder-from-the-principle-of-virtual-work-f-c-u-s-w-0 = Força do cilindro, pelo princípio dos trabalhos virtuais, F_c u_s + ΣδW = 0
from-the-fixed-pin-of-the-cylinder-to-the-crank-pin = Do pino fixo do cilindro ao pino da manivela
inverted-slider-crank = Biela-manivela invertido
length-of-the-cylinder-from-pin-to-pin = Comprimento do cilindro de pino a pino
piston-with-its-rod = Pistão com a sua haste
positive-when-it-pushes-the-crank-pin-away-from-the-fixed-pin-of-the-cylinder = Positiva quando afasta o pino da manivela do pino fixo do cilindro.
pressure-relative-to-the-other-side-of-the-piston = Pressão em relação ao outro lado do pistão
the-crank-pin-is-at-the-fixed-pin-of-the-cylinder-the-cylinder-has-no-direction-turn-the-crank-or = o pino da manivela está no pino fixo do cilindro: o cilindro não tem direção; gire a manivela ou mova o pino
the-inverted-slider-crank = O cursor-manivela invertido
torque-of-a-crank-or-lever-moved-by-an-oscillating-cylinder-or-the-force-of-the-cylinder-at-rest-or = Torque de uma manivela ou alavanca movida por um cilindro oscilante, ou a força do cilindro, em repouso ou em movimento com massas, por trabalho virtual; reações.
torque-on-the-crank-from-the-force-of-the-cylinder = Torque na manivela, pela força do cilindro
torque-on-the-crank-from-the-pressure-in-the-cylinder = Torque na manivela, pela pressão no cilindro
towards-the-crank-pin = Em direção ao pino da manivela.
towards-the-fixed-pin-of-the-cylinder = Em direção ao pino fixo do cilindro.
unit-vector-from-the-fixed-pin-to-the-crank-pin = Vetor unitário do pino fixo ao pino da manivela
velocity-of-the-piston-in-the-cylinder = Velocidade do pistão no cilindro
virtual-change-of-the-length-for-2-1-s-r-a = Variação virtual do comprimento para δθ_2 = 1: δs = ê · δr_A
virtual-rotation-of-the-cylinder-for-2-1 = Rotação virtual do cilindro para δθ_2 = 1
virtual-work-of-the-force-of-the-cylinder = Trabalho virtual da força do cilindro

# Topics
bars-and-levers = Barras e alavancas
presses-and-lifts = Prensas e elevadores
plane-linkages = Mecanismos planos de barras
any-mechanism = Mecanismos quaisquer
engines-gears-and-wheels = Motores, engrenagens e rodas

### Published cases

# a_frame.toml
step-ladder-held-at-its-feet = Escada dupla mantida pelos pés
two-uniform-ladders-of-200-n-at-30-from-the-vertical-on-a-smooth-floor-the-length-does-not-matter = Duas escadas uniformes de 200 N a 30° da vertical em piso liso; o comprimento não importa.
step-ladder-held-by-a-rope = Escada dupla mantida por uma corda
the-rope-is-tied-at-three-quarters-of-the-length-from-the-top-as-t-400-tan-30-3-shows = A corda está amarrada a três quartos do comprimento a partir do topo, como indica T = 400 tan 30°/3.
angle-that-a-rope-of-100-n-holds-under-a-load = Ângulo que uma corda de 100 N mantém sob uma carga
tan-2-s-t-w-q = tan θ = 2 s T/(W + Q)
friction-for-ladders-without-load-at-the-hinge = Atrito para escadas sem carga na articulação
tan = μ = ½ tan θ
ladders-without-weight = Escadas sem peso
no-load-no-force = Sem carga, não há força

# bar_and_cord.toml
bar-at-20-under-a-pulley = Barra a 20° sob uma polia
a-uniform-bar-of-10-kg-and-1-5-m-pinned-at-its-lower-end-the-pulley-is-1-2-m-above-the-pin = Uma barra uniforme de 10 kg e 1,5 m, articulada na extremidade inferior; a polia está 1,2 m acima da articulação.
all-equilibrium-positions-under-6-5334708-kg = Todas as posições de equilíbrio com 6,5334708 kg
r-c-hibbeler-a-gupta-engineering-mechanics-example-11-6-solved-in-reverse = R. C. Hibbeler, A. Gupta, Engineering Mechanics, exemplo 11.6, resolvido no sentido inverso
cos-0-is-an-equilibrium-too-the-bar-straight-up-or-down = cos θ = 0 também é equilíbrio: a barra na vertical, para cima ou para baixo.
cord-to-the-middle-of-the-bar = Cabo no meio da barra
m-m-s-2-b-for-b-l-2-and-h-the-moment-of-the-cord-p-b-h-cos-s-against-w-l-2-cos-gives-p-w-s-h = m = M s/(2 b) para b = L/2 e h: o momento do cabo, P b h cos θ/s, contra W (L/2) cos θ, dá P = W s/h
vertical-bar-mass-indeterminate = Barra vertical, massa indeterminada
at-90-neither-weight-does-virtual-work = Em θ = 90° nenhum dos pesos realiza trabalho virtual

# compound_lever.toml
bolt-cutter = Alicate corta-vergalhão
ratio-400-30-60-20-40-of-its-two-levers = Razão (400/30)·(60/20) = 40 das suas duas alavancas
one-half-the-handle-turns-about-the-common-pin-and-pushes-the-rear-arm-of-the-jaw = Uma metade: o cabo gira em torno do pino comum e empurra o braço traseiro da mandíbula.
two-levers-with-aiding-and-opposing-loads = Duas alavancas com cargas a favor e contra
beer-johnston-vector-mechanics-for-engineers-statics-9th-ed-problem-10-1 = Beer & Johnston, Vector Mechanics for Engineers: Statics, 9ª ed., problema 10.1
moving-a-by-y-moves-c-by-2-y-d-by-y-e-and-g-by-y-2-arms-that-give-these-ratios = Deslocar A de δy desloca C de 2 δy, D de δy, E e G de δy/2. Braços que dão estas razões.
the-two-levers-with-the-loads-of-the-later-edition = As duas alavancas com as cargas da edição posterior
beer-johnston-vector-mechanics-for-engineers-statics-10th-and-11th-ed-problem-10-1 = Beer & Johnston, Vector Mechanics for Engineers: Statics, 10ª e 11ª ed., problema 10.1
couple-on-one-lever-force-on-another-force-at-g = Binário em uma alavanca, força em outra: força em G
beer-johnston-vector-mechanics-for-engineers-statics-8th-ed-problem-10-1-of-two-levers-abc-and-defg = Beer & Johnston, Vector Mechanics for Engineers: Statics, 8ª ed., problema 10.1 com duas alavancas ABC e DEFG
abc-drives-defg-with-125-mm-on-375-mm-so-that-defg-rotates-one-third-as-much-g-is-100-2-mm-from-the = ABC aciona DEFG com 125 mm sobre 375 mm, de modo que DEFG gira um terço disso; G está a 100√2 mm do pivô, a 45° da linha da força vertical.
couple-on-one-lever-force-on-another-couple-on-defg = Binário em uma alavanca, força em outra: binário em DEFG
beer-johnston-vector-mechanics-for-engineers-statics-8th-ed-problem-10-3-of-two-levers-abc-and-defg = Beer & Johnston, Vector Mechanics for Engineers: Statics, 8ª ed., problema 10.3 com duas alavancas ABC e DEFG
single-lever = Uma só alavanca
load-on-a-lever-that-does-not-exist = Carga em uma alavanca que não existe
one-link-two-levers = Uma ligação, duas alavancas

# engine.toml
steam-engine-with-expansion = Máquina a vapor com expansão
the-book-works-with-two-terms-in-displacement-and-acceleration-the-pressures-are-gauge-pressures-with = O livro trabalha com dois termos, no deslocamento e na aceleração; as pressões são manométricas, com atmosfera de 1,03 bar.
mean-effective-pressure-of-the-same-engine = Pressão média efetiva da mesma máquina
closed-form-of-hyperbolic-expansion-p-m-p-a-c-1-ln-1-c-p-b = forma fechada da expansão hiperbólica: p_m = p_a c (1 + ln 1/c) − p_b
with-the-exact-motion-whose-work-is-that-of-the-pressures-903-kpa-1-ln-3-3-28-kpa-on-both-sides-of = Com o movimento exato, cujo trabalho é o das pressões: 903 kPa × (1 + ln 3)/3 − 28 kPa dos dois lados do pistão.
inertia-torque-of-a-high-speed-engine-over-a-turn = Torque de inércia de um motor de alta rotação ao longo de uma volta
kinetic-energy-of-piston-and-rod-the-torque-is-de-d-and-has-no-mean = energia cinética do pistão e da biela: o torque é −dE/dθ e não tem média
crank-40-mm-rod-140-mm-3000-rpm-the-extremes-are-symmetrical-about-the-dead-centre = Manivela de 40 mm, biela de 140 mm, 3000 rpm. Os extremos são simétricos em relação ao ponto morto.
engine-held-by-a-couple-crank-at-30 = Motor mantido por um binário, manivela a 30°
beer-johnston-vector-mechanics-for-engineers-statics-12th-ed-prob-10-21 = Beer & Johnston, Vector Mechanics for Engineers: Statics, 12ª ed., probl. 10.21
crank-50-mm-rod-200-mm-4-kn-on-the-piston-the-couple-on-the-crank-balances-the-turning-moment = Manivela de 50 mm, biela de 200 mm, 4 kN no pistão; o binário na manivela equilibra o torque.
engine-held-by-a-couple-crank-at-150 = Motor mantido por um binário, manivela a 150°
force-on-the-piston-for-a-couple-on-the-crank-at-60 = Força no pistão para um binário na manivela, a 60°
beer-johnston-vector-mechanics-for-engineers-statics-7th-ed-prob-10-20 = Beer & Johnston, Vector Mechanics for Engineers: Statics, 7ª ed., probl. 10.20
force-on-the-piston-for-a-couple-on-the-crank-at-120 = Força no pistão para um binário na manivela, a 120°
couple-for-a-thousand-pounds-on-the-piston-crank-at-30 = Binário para mil libras no pistão, manivela a 30°
after-beer-johnston-vector-mechanics-for-engineers-statics-7th-ed-prob-10-19-m-p-r-sin-cos = baseado em Beer & Johnston, Vector Mechanics for Engineers: Statics, 7ª ed., probl. 10.19; M = P r sen(θ + φ)/cos φ
couple-for-a-thousand-pounds-on-the-piston-crank-at-150 = Binário para mil libras no pistão, manivela a 150°
force-on-the-slider-for-a-load-at-the-crank-pin = Força no cursor para uma carga no pino da manivela
the-200-n-at-the-pin-between-crank-and-rod-exert-a-moment-of-200-n-0-6-m-cos-45-on-the-crank-the = Os 200 N no pino entre manivela e biela exercem na manivela o momento 200 N × 0,6 m × cos 45°; a força no cursor deve produzir esse torque.
velocity-and-acceleration-of-a-piston = Velocidade e aceleração de um pistão
the-same-piston-in-another-book = O mesmo pistão em outro livro
r-sin-sin-2-2n-5-6549-0-64279-0-98481-10-4-192-m-s-as-khurmi-gupta-print-for-the-same-data-4-4-m-s = r ω (sen θ + sen 2θ/(2n)) = 5,6549 × (0,64279 + 0,98481/10) = 4,192 m/s, como Khurmi & Gupta imprimem para os mesmos dados; 4,4 m/s vem de um parêntese fora do lugar.
r-cos-cos-2-n-106-59-0-76604-0-17365-5-85-36-m-s-83-5-m-s-results-from-2n-instead-of-n-in-the = r ω² (cos θ + cos 2θ/n) = 106,59 × (0,76604 + 0,17365/5) = 85,36 m/s²; 83,5 m/s² vem de 2n em lugar de n no termo secundário.
motion-of-a-connecting-rod = Movimento de uma biela
the-book-gives-the-magnitude-of-the-angular-acceleration-at-60-the-obliquity-increases-at-a = O livro dá o módulo da aceleração angular; a 60° a obliquidade cresce a uma taxa decrescente.
the-same-rod-with-the-exact-motion = A mesma biela com o movimento exato
loop-closure-of-the-slider-crank-r-cos-n-sin = fechamento da cadeia do cursor-manivela: ω_r = ω cos θ/√(n² − sen²θ)
inertia-force-of-reciprocating-parts = Força de inércia das peças alternativas
by-graphical-construction-the-book-also-finds-18-78-kn = Por construção gráfica o livro também obtém 18,78 kN.
printed-with-52-4-rad-s-for-500-rpm-calculated-18-506-kn = impresso com 52,4 rad/s para 500 rpm; calculado: 18,506 kN
vertical-steam-engine-piston-moving-down = Máquina a vapor vertical, pistão descendo
petrol-engine-and-the-speed-at-which-the-gudgeon-pin-is-unloaded = Motor a gasolina e a rotação em que o pino do pistão fica sem carga
printed-with-the-cosine-of-a-rounded-angle-calculated-1865-39-n = impresso com o cosseno de um ângulo arredondado; calculado: 1865,39 N
steam-engine-with-the-acceleration-of-its-piston-given = Máquina a vapor com a aceleração do pistão dada
n-28-263-kn-tan-6-379-3-16-kn-the-printed-listing-takes-the-tangent-of-6-379-as-if-it-were-radians = 28,263 kN × tan 6,379° = 3,16 kN. A listagem impressa toma a tangente de 6,379 como se fossem radianos, e arredonda 2,7 kN para cima.
vertical-petrol-engine-at-2000-rpm = Motor a gasolina vertical a 2000 rpm
printed-with-rounded-numbers-calculated-2255-8-n = impresso com números arredondados; calculado: 2255,8 N
printed-with-a-rounded-angle-calculated-2263-5-n = impresso com um ângulo arredondado; calculado: 2263,5 N
printed-with-a-rounded-angle-calculated-185-8-n = impresso com um ângulo arredondado; calculado: 185,8 N
printed-with-rounded-numbers-calculated-2602-7-rpm = impresso com números arredondados; calculado: 2602,7 rpm
vertical-petrol-engine-at-1800-rpm = Motor a gasolina vertical a 1800 rpm
printed-with-a-rounded-obliquity-calculated-2652-99-n = impresso com uma obliquidade arredondada; calculado: 2652,99 N
printed-with-rounded-numbers-calculated-2528-2-rpm = impresso com números arredondados; calculado: 2528,2 rpm
steam-engine-with-a-piston-rod-and-its-flywheel = Máquina a vapor com haste de pistão, e o seu volante
printed-with-a-rounded-obliquity-calculated-4234-85-n-m = impresso com uma obliquidade arredondada; calculado: 4234,85 N·m
printed-with-a-rounded-obliquity-calculated-16322-7-n = impresso com uma obliquidade arredondada; calculado: 16322,7 N
from-the-printed-torque-calculated-122-29-rad-s = do torque impresso; calculado: 122,29 rad/s²
vertical-steam-engine-at-360-rpm = Máquina a vapor vertical a 360 rpm
gas-and-inertia-nearly-cancel-the-two-term-formula-is-1-9-above-the-exact-motion-which-gives-2321-7-n = Gás e inércia quase se cancelam: a fórmula de dois termos fica 1,9 % acima do movimento exato, que dá 2321,7 N·m.
printed-with-rounded-numbers-calculated-2365-97-n-m = impresso com números arredondados; calculado: 2365,97 N·m
steam-engine-at-200-rpm = Máquina a vapor a 200 rpm
printed-with-rounded-numbers-calculated-60457-5-n = impresso com números arredondados; calculado: 60457,5 N
from-the-printed-effort-calculated-12607-0-n-m = do esforço impresso; calculado: 12607,0 N·m
inertia-force-of-a-heavy-connecting-rod = Força de inércia de uma biela pesada
the-moment-of-inertia-is-not-given-and-not-needed = O momento de inércia não é dado nem necessário.
by-klein-s-construction-drawn-to-scale-calculated-350-96-m-s = pela construção de Klein, desenhada em escala; calculado: 350,96 m/s²
by-klein-s-construction-drawn-to-scale-calculated-23-94-kn = pela construção de Klein, desenhada em escala; calculado: 23,94 kN
torque-against-inertia-and-weight-of-a-horizontal-engine = Torque contra a inércia e o peso de um motor horizontal
the-book-gives-the-torque-that-must-be-supplied-the-turning-moment-of-the-engine-is-its-opposite-the = O livro dá o torque que é preciso fornecer; o torque do motor é o oposto. A correção da biela tem o mesmo sinal dos demais termos; subtraí-la daria 3719,7 N·m.
printed-to-the-nearest-ten-calculated-3840-5-n-m = impresso com arredondamento à dezena; calculado: −3840,5 N·m
force-on-the-crank-pin-of-a-vertical-engine = Força no pino da manivela de um motor vertical
the-book-solves-graphically-its-components-are-read-off-the-drawing = O livro resolve graficamente; as suas componentes são lidas no desenho.
read-off-a-drawing-calculated-7-825-kn = lido em um desenho; calculado: 7,825 kN
n-7-55-kn-is-only-the-component-f-p-cos-of-the-piston-effort-the-lateral-force-reduces-it-by-1-24-kn = 7,55 kN é só a componente F_P cos θ do esforço no pistão. A força lateral a reduz em 1,24 kN, e a força centrífuga da massa equivalente da biela no pino da manivela, em 3,51 kN: restam 2,81 kN, como também dão as equações de Newton e Euler do pistão e da biela.
moments-of-the-rod-about-the-crank-pin-f-p-tan-2-16-kn-less-0-23-kn-for-the-correction-couple = Momentos da biela em relação ao pino da manivela: F_P tan φ = 2,16 kN, menos 0,23 kN do binário de correção.
even-the-printed-components-8-03-and-7-55-kn-have-a-resultant-of-11-0-kn-those-from-the-equations-of = Mesmo as componentes impressas, 8,03 e 7,55 kN, têm uma resultante de 11,0 kN; as das equações do movimento, 7,82 e 2,81 kN, dão 8,32 kN.
inertia-torque-of-an-engine-in-pounds-and-feet = Torque de inércia de um motor em libras e pés
printed-with-g-32-2-ft-s-and-the-approximate-arm-r-sin-sin-2-2n-calculated-2153-5-lbf-ft = impresso com g = 32,2 ft/s² e o braço aproximado r (sen θ + sen 2θ/(2n)); calculado: −2153,5 lbf·ft
the-two-masses-have-500-lb-41-19-25-in-of-excess-inertia-with-sin-40-5-and-cos-40-25-sin-40-the = As duas massas têm 500 lb × (41 × 19 − 25²) in² de inércia a mais; com φ̈ = −ω² sen 40°/5 e φ′ = cos 40°/√(25 − sen² 40°) o momento é −52 lbf·ft. −1,3 resulta de converter 40° em radianos duas vezes.
n-500-lbf-41-60-1-ft-cos-40-261-7-lbf-ft-341-6-is-that-product-without-the-cosine-the-cosine-was = 500 lbf × 41/60 × 1 ft × cos 40° = 261,7 lbf·ft. 341,6 é esse produto sem o cosseno: o cosseno foi tomado de 40° convertidos duas vezes em radianos.
the-sum-includes-the-two-moments-above-2153-52-262-2467-lbf-ft = A soma inclui os dois momentos acima: −2153 − 52 − 262 = −2467 lbf·ft.
engine-at-314-rad-s-with-a-heavy-rod = Motor a 314 rad/s com biela pesada
course-notes-on-dynamics-of-machinery-in-turkish-example-9-as-quoted-in-a-public-collection-of-tests = Notas de aula de dinâmica das máquinas (em turco), exemplo 9, citadas em uma coleção pública de testes
from-a-velocity-polygon-calculated-41-05-rad-s = de um polígono de velocidades; calculado: 41,05 rad/s
printed-with-rounded-intermediate-numbers-calculated-196-64-n-m = impresso com números intermediários arredondados; calculado: 196,64 N·m
the-course-s-slider-crank-with-a-motion-that-closes-its-loop = O cursor-manivela da disciplina com um movimento que fecha a malha
riul-unit-ii-example-1-with-r-150-mm-and-l-200-mm-newton-euler-equations-of-another-program = Riul, Unidade II, exemplo 1, com r = 150 mm e l = 200 mm; equações de Newton–Euler de outro programa
n-5000-n-pull-the-slider-away-from-the-crank-so-that-the-engine-has-to-be-driven = 5000 N puxam o cursor para longe da manivela, de modo que o motor tem de ser acionado.
four-stroke-engine-with-an-indicator-diagram = Motor de quatro tempos com diagrama indicador
an-indicator-diagram-of-a-small-petrol-engine-newton-euler-equations-as-a-second-method = um diagrama indicador de um pequeno motor a gasolina; equações de Newton–Euler como segundo método
an-inclined-engine-with-offset-and-a-diagram-over-the-stroke = Motor inclinado com excentricidade e diagrama sobre o curso
an-indicator-diagram-that-is-a-rectangle-the-mean-effective-pressure-is-its-height = um diagrama indicador retangular: a pressão média efetiva é a sua altura
n-6-bar-on-the-outward-stroke-and-1-bar-on-the-return-with-a-stroke-of-l-r-e-l-r-e = 6 bar na ida e 1 bar na volta, com um curso de √((l + r)² − e²) − √((l − r)² − e²).
sixteen-orders-of-the-motion = Dezesseis ordens do movimento
fourier-series-of-the-exact-motion-the-remainder-beyond-the-sixteenth-order-is-below-one-millionth = série de Fourier do movimento exato: o resto além da décima sexta ordem é menor que um milionésimo
r-0-15-m-n-4-450-rpm-and-60-as-above-with-the-exact-motion = r = 0,15 m, n = 4, 450 rpm e 60°, como acima com o movimento exato.
crank-with-angular-acceleration = Manivela com aceleração angular
newton-euler-equations-as-a-second-method = equações de Newton–Euler como segundo método
gas-force-from-the-turning-moment-of-this-engine = Força do gás a partir do torque deste motor
the-engine-above-from-its-turning-moment-back-to-the-900-n = o motor acima, do seu torque de volta aos 900 N
polytropic-expansion-with-clearance = Expansão politrópica com folga
closed-form-p-m-p-a-k-1-1-1-p-b = forma fechada: p_m = p_a [ε + (ε + κ)/(k − 1) (1 − ((ε + κ)/(1 + κ))ᵏ⁻¹)] − p_b
a-dead-centre = Ponto morto
no-force-on-the-piston-has-a-moment-arm-about-the-crankshaft = nenhuma força no pistão tem braço de alavanca em relação ao eixo da manivela
a-crank-of-100-mm-and-a-rod-of-100-mm = uma manivela de 100 mm e uma biela de 100 mm
a-given-acceleration-and-a-rod-with-mass = Aceleração dada e biela com massa
the-motion-of-the-rod-is-not-known = o movimento da biela não é conhecido

# epicyclic_train.toml
ring-with-external-teeth-driven-by-a-pinion = Coroa com dentes externos movida por um pinhão
sun-of-31-teeth-fixed-ring-of-83-internal-and-90-external-teeth-driven-by-a-pinion-of-25-the-arm-is = Solar de 31 dentes, fixo; coroa de 83 dentes internos e 90 externos, movida por um pinhão de 25; o braço é movido. 10 lbf·ft no pinhão; a carga atua no braço no mesmo sentido em que gira o pinhão, pois braço e coroa giram no sentido contrário.
the-same-train-to-more-digits = O mesmo trem com mais algarismos
n-10-90-25-83-31-83 = 10·(90/25)·(83 + 31)/83
fixed-ring-driving-sun = Coroa fixa, solar motor
a-s-z-s-z-s-z-r-1-4-with-24-and-72-teeth-t-a-4-t-s-t-r-3-t-s = ω_A/ω_S = z_S/(z_S + z_R) = 1/4 com 24 e 72 dentes; T_A = −4 T_S, T_R = 3 T_S
high-reduction-with-two-suns = Alta redução com dois solares
e-101-99-100-100-0-9999-with-the-first-sun-fixed-the-second-turns-by-1-e-1-10000-of-the-arm = e = (101·99)/(100·100) = 0,9999: com o primeiro solar fixo, o segundo gira 1 − e = 1/10000 do braço
star-gear-the-arm-is-fixed = Trem estrela: o braço é fixo
r-s-z-s-z-2-z-1-z-r-20-30-40-90 = ω_R/ω_S = −z_S z_2/(z_1 z_R) = −20·30/(40·90)
a-fixed-member-cannot-drive = Um membro fixo não pode ser motor
two-different-members-are-needed = são necessários dois membros diferentes
suns-that-lock-each-other = Solares que se travam
e-1-both-suns-have-the-same-speed = e = 1: os dois solares têm a mesma velocidade
fixed-sun-driving-arm = Solar fixo, braço motor
r-a-1-z-s-z-r-1-40-80-t-r-t-a-1-5-the-sun-is-held-by-the-rest = ω_R/ω_A = 1 + z_S/z_R = 1 + 40/80; T_R = −T_A/1,5, e o solar é retido pelo restante

# equilibrium.toml
bar-with-a-cord-over-a-pulley = Barra com um cabo sobre uma polia
a-uniform-bar-of-10-kg-and-1-5-m-on-a-pin-a-cord-from-its-tip-over-a-small-pulley-1-2-m-above-the-pin = Uma barra uniforme de 10 kg e 1,5 m em uma articulação; um cabo da sua ponta, passando por uma pequena polia 1,2 m acima da articulação, sustenta o bloco de 6,53 kg que o livro encontra para 20°. A massa é dada com mais algarismos, para que o ângulo resulte exato a menos do arredondamento.
the-book-rounds-the-mass-of-the-block-before-it-goes-on = o livro arredonda a massa do bloco antes de prosseguir
weight-on-a-disc-with-a-spring = Peso em um disco com mola
f-p-beer-e-r-johnston-vector-mechanics-for-engineers-statics-sample-problem-10-4 = F. P. Beer, E. R. Johnston, Vector Mechanics for Engineers: Statics, problema resolvido 10.4
n-10-kg-on-an-arm-of-300-mm-a-spring-of-4-kn-m-on-a-cord-wrapped-at-80-mm-unstretched-with-the-weight = 10 kg em um braço de 300 mm, uma mola de 4 kN/m em um cabo enrolado a 80 mm, sem deformação com o peso na vertical acima do pivô; a mola é dada como a mola de torção equivalente k a² = 25,6 N·m/rad. Os dois equilíbrios do livro.
three-bars-hung-in-a-chain = Três barras suspensas em cadeia
three-equal-bars-of-60-lb-90-lb-pulling-sideways-at-the-free-end-tan-90-150-90-90-90-30-from-the = Três barras iguais de 60 lb, 90 lb puxando de lado na extremidade livre: tan θ = 90/150, 90/90, 90/30 a partir da vertical; aqui a partir da horizontal, portanto 90° menos.
two-bar-linkage-pushed-at-its-sliding-end = Duas barras articuladas empurradas na extremidade deslizante
two-uniform-bars-of-10-kg-and-1-m-one-on-a-pin-the-other-with-a-sliding-end-that-25-n-push-towards = Duas barras uniformes de 10 kg e 1 m, uma articulada, a outra com uma extremidade deslizante que 25 N empurram em direção à articulação.
the-book-rounds-to-a-tenth-of-a-degree = o livro arredonda a um décimo de grau
inverted-bar-between-two-springs-just-stiff-enough = Barra invertida entre duas molas de rigidez apenas suficiente
k-p-l-2-a = k = P l/(2 a²)
a-weight-of-200-n-at-900-mm-on-a-pin-springs-at-500-mm-on-both-sides-360-n-m-each-is-critical-with = Um peso de 200 N a 900 mm de uma articulação, molas a 500 mm dos dois lados: 360 N/m em cada uma é o valor crítico. Com 361 N/m a posição vertical (invertida) é estável e outras duas, onde cos φ = P l/(2 k a²), não são; V″ = 2 k a² − P l = 0,5 N·m/rad na primeira ordem das molas longas.
the-springs-are-long-but-not-infinite = as molas são longas, mas não infinitas
weight-without-an-equilibrium-position = Peso sem posição de equilíbrio
a-pendulum-away-from-its-two-equilibrium-positions = Um pêndulo longe das suas duas posições de equilíbrio

# equivalent_rod.toml
rod-with-its-centre-of-mass-near-the-gudgeon-pin = Biela com o centro de massa perto do pino do pistão
the-masses-are-printed-to-a-tenth-of-a-kilogram-the-correction-couple-is-that-of-masses-at-the-two = As massas estão impressas até o décimo de quilograma. O binário de correção é o de massas nos dois pinos; atua no sentido da aceleração angular, pois essas massas têm inércia a mais.
a-uniform-rod = Biela uniforme
k-l-12-and-a-l-2-in-the-formulas = k² = l²/12 e a = l/2 nas fórmulas
a-quarter-of-the-mass-at-the-end-three-quarters-at-l-6-beyond-the-middle-b-l-6-m-m-4-m-3m-4-masses-m = Um quarto da massa na extremidade, três quartos a l/6 além do meio: b′ = l/6, m₁ = m/4, m₂ = 3m/4; massas m/2 nos pinos têm m l²/4, m l²/6 a mais.
rod-oscillating-about-its-gudgeon-pin = Biela oscilando em torno do pino do pistão
the-first-rod-with-the-period-2-k-a-g-a-of-its-oscillation = a primeira biela, com o período 2π √((k² + a²)/(g a)) da sua oscilação
rod-oscillating-about-each-pin-in-turn = Biela oscilando em torno de cada pino
the-first-rod-with-the-periods-of-its-oscillations-about-either-pin = a primeira biela, com os períodos das suas oscilações em torno de cada pino
a-centre-of-mass-beyond-the-rod = Centro de massa além da biela
a-distance-above-the-length-of-the-rod = uma distância maior que o comprimento da biela

# five_bar.toml
two-cranks-balance-a-force-at-the-apex = Duas manivelas equilibram uma força no vértice
t-j-f-with-the-displacements-of-the-apex-by-each-crank-the-torques-of-the-assembled-mechanism-were = T = −Jᵀ F com os deslocamentos do vértice por cada manivela; os torques do mecanismo montado peça a peça foram os mesmos
links-50-120-120-and-50-mm-pivots-100-mm-apart-cranks-at-75-and-120-100-n-up-and-40-n-to-the-right = Barras de 50, 120, 120 e 50 mm, pivôs distantes 100 mm, manivelas a 75° e 120°; 100 N para cima e 40 N para a direita.
geared-cranks = Manivelas engrenadas
equal-gears-on-the-pivots-70-and-110-virtual-work-and-finite-differences-of-the-height-of-the-apex = Engrenagens iguais nos pivôs, 70° e 110°: trabalho virtual, e diferenças finitas da altura do vértice
n-100-n-up-at-the-apex-the-linkage-is-symmetric-so-the-apex-moves-vertically = 100 N para cima no vértice; o mecanismo é simétrico, e o vértice se move na vertical.
force-from-the-two-torques = Força a partir dos dois torques
the-torques-of-the-first-case-reproduce-its-force = os torques do primeiro caso reproduzem a sua força
rhombus-standing-on-its-pivots = Losango apoiado nos seus pivôs
cranks-vertical-rods-at-60-each-rod-carries-f-2-sin-60-with-the-lever-arm-a-cos-60-t-f-a-2-tan-60 = Manivelas na vertical, bielas a 60°: cada biela suporta F/(2 sen 60°) com o braço de alavanca a cos 60°: T = ∓F a/(2 tan 60°)
force-of-a-geared-linkage = Força de um mecanismo engrenado
one-equation-for-two-components = uma equação para duas componentes
rods-too-short = Bielas curtas demais
a-and-b-are-500-mm-apart = A e B distam 500 mm

# flywheel.toml
two-stroke-engine-with-a-second-harmonic = Motor de dois tempos com segundo harmônico
t-1000-300-sin-2-500-cos-2-the-fluctuation-of-energy-is-300-500-n-m-after-khurmi-gupta-theory-of = T = 1000 + 300 sen 2θ − 500 cos 2θ: a flutuação de energia é √(300² + 500²) N·m; segundo Khurmi & Gupta, Theory of Machines, cap. 16
areas-of-a-petrol-engine-s-diagram = Áreas do diagrama de um motor a gasolina
n-295-685-40-340-960-270-mm-after-khurmi-gupta-theory-of-machines-ch-16 = 295 − 685 + 40 − 340 + 960 − 270 mm², segundo Khurmi & Gupta, Theory of Machines, cap. 16
the-sums-run-from-295-to-690-mm-985-mm-5-n-m-mm-1-mm = As somas vão de 295 a −690 mm²; 985 mm² × 5 N·m/mm × 1°/mm.
speeds-of-a-heavy-flywheel = Rotações de um volante pesado
inertia-for-one-per-cent = Inércia para um por cento
t-20-000-9500-sin-2-5700-cos-2-n-m-e-9500-5700-n-m-i-c-s-after-khurmi-gupta-theory-of-machines-ch-16 = T = 20 000 + 9500 sen 2θ − 5700 cos 2θ N·m: ΔE = √(9500² + 5700²) N·m = I ω² C_s; segundo Khurmi & Gupta, Theory of Machines, cap. 16
triangular-moment-on-the-power-stroke-of-a-four-stroke-engine = Torque triangular no tempo motor de um motor de quatro tempos
a-triangle-of-800-n-m-over-180-of-720-t-m-100-n-m-above-the-mean-t-max-7-8-2-of-its-base = um triângulo de 800 N·m em 180° de 720°: T_m = 100 N·m; acima da média, T_max (7/8)²/2 da sua base
e-700-n-m-7-8 = ΔE = ½ × 700 N·m × (7/8) π.
turning-moment-that-is-not-periodic = Torque que não é periódico
an-order-of-0-3 = uma ordem de 0,3

# four_bar.toml
coupler-and-rocker-with-masses-at-95-rad-s = Acoplador e balancim com massas a 95 rad/s
dynamics-of-machines-turkish-lecture-notes-example-7-the-answers-are-known-from-a-program-that-quotes = Dinâmica das máquinas, notas de aula em turco, exemplo 7 (as respostas são conhecidas por um programa que as cita)
frame-100-mm-crank-50-mm-coupler-151-mm-rocker-111-mm-at-120-steady-95-rad-s-the-notes-print = Base de 100 mm, manivela de 50 mm, acoplador de 151 mm, balancim de 111 mm a 120°, 95 rad/s constantes. As notas de aula imprimem módulos e resolvem graficamente: velocidades e acelerações desviam de 1 a 3 %, o torque 0,5 %.
the-notes-read-the-velocities-off-a-drawing = as notas de aula leem as velocidades em um desenho
the-notes-read-the-accelerations-off-a-drawing = as notas de aula leem as acelerações em um desenho
the-notes-compute-with-accelerations-read-off-a-drawing = as notas de aula calculam com acelerações lidas em um desenho
the-same-linkage-to-more-digits = O mesmo mecanismo com mais algarismos
dynamics-of-machines-turkish-lecture-notes-example-7-virtual-power-and-the-equations-of-newton-and = Dinâmica das máquinas, notas de aula em turco, exemplo 7: potência virtual e as equações de Newton e Euler
mechanical-advantage-of-a-crank-rocker = Vantagem mecânica de uma manivela-balancim
t-4-t-2-2-4-with-the-ratio-of-the-speeds-from-instant-centre-24 = T_4 = T_2 ω_2/ω_4, com a razão das velocidades pelo centro instantâneo 24
n-10-n-m-on-the-crank-the-torque-on-the-rocker-that-balances-it-acts-in-the-opposite-sense = 10 N·m na manivela; o torque no balancim que o equilibra atua no sentido contrário.
velocity-of-the-coupler = Velocidade do acoplador
ab-300-mm-at-100-rpm-bc-cd-360-mm-ad-600-mm-angle-bad-60-the-book-measures-the-distance-to-the = AB = 300 mm a 100 rpm, BC = CD = 360 mm, AD = 600 mm, ângulo BAD = 60°. O livro mede em um desenho a distância ao centro instantâneo, 500 mm, e imprime o módulo.
the-book-takes-the-distance-to-the-instant-centre-from-a-drawing = o livro toma de um desenho a distância ao centro instantâneo
parallelogram-with-a-force-on-its-coupler = Paralelogramo com uma força no acoplador
a-c-b-d-the-coupler-keeps-its-angle-and-all-its-points-move-like-the-crank-pin-t-f-a-cos = a = c, b = d: o acoplador conserva o seu ângulo, e todos os seus pontos se movem como o pino da manivela; T = F a cos θ
crank-rocker-crossed-configuration = Manivela-balancim, configuração cruzada
t-4-t-2-h-4-with-h-4-a-sin-2-3-c-sin-4-3-on-the-crossed-branch = T_4 = T_2/h_4 com h_4 = a sen(θ_2 − θ_3)/(c sen(θ_4 − θ_3)) no ramo cruzado
double-rocker-at-its-limit-position = Duplo balancim na posição limite
cos-a-d-b-c-2-a-d-where-coupler-and-rocker-are-extended-and-collinear = cos θ = (a² + d² − (b + c)²)/(2 a d) onde acoplador e balancim estão estendidos e colineares
weights-of-uniform-bars = Pesos de barras uniformes
parallelogram-centres-of-crank-and-rocker-rise-by-a-2-cos-that-of-the-coupler-by-a-cos-t-2-2-3-2-2-g = Paralelogramo: os centros de manivela e balancim sobem (a/2) cos θ δθ, o do acoplador a cos θ δθ: T = (2/2 + 3 + 2/2) g a cos θ
links-too-short-to-assemble = Barras curtas demais para montar
the-distance-from-a-to-c-is-0-5-0-1-0-4-m-coupler-and-rocker-span-0-2-m = a distância de A a C é 0,5 − 0,1 = 0,4 m; acoplador e balancim alcançam 0,2 m
coupler-and-rocker-collinear = Acoplador e balancim alinhados
n-3-4-5-at-90-ac-is-500-mm-the-links-are-200-mm-and-300-mm = 3-4-5: em θ = 90° AC mede 500 mm, as barras têm 200 mm e 300 mm

# guided_bar.toml
bar-with-a-horizontal-spring = Barra com mola horizontal
r-c-hibbeler-engineering-mechanics-statics-14th-ed-problem-11-41 = R. C. Hibbeler, Engineering Mechanics: Statics, 14ª ed., problema 11-41
a-bar-of-100-kg-and-4-m-hangs-with-its-upper-end-in-a-horizontal-guide-the-spring-at-its-middle-500-n = Uma barra de 100 kg e 4 m pende com a extremidade superior em uma guia horizontal; a mola no seu meio, de 500 N/m, não está alongada a 60°: V = ½ k (2 sen 60° − 2 sen θ)² − m g 2 cos θ.
the-bar-with-the-spring-its-curvature = A barra com a mola, a sua curvatura
v-of-k-2-sin-60-2-sin-m-g-2-cos-at-its-root = V″ de ½ k (2 sen 60° − 2 sen θ)² − m g 2 cos θ na sua raiz
ladder-held-at-its-foot = Escada mantida pelo pé
f-w-tan-on-a-smooth-floor-and-wall = F = ½ W tan θ em piso e parede lisos
collars-pressed-by-a-vertical-force = Cursores pressionados por uma força vertical
p-l-sin-k-l-cos-cos-sin-p-k-l-cos-cos = P L sen θ = k L² (cos θ₀ − cos θ) sen θ: P = k L (cos θ₀ − cos θ)
the-spring-between-a-and-the-corner-is-unstretched-with-the-bar-vertical-and-compressed-as-a-moves = A mola entre A e o canto não está deformada com a barra na vertical, e é comprimida quando A desce.
upright-bar-on-a-spring = Barra na vertical sobre uma mola
v-0-at-0-for-f-0-the-vertical-bar-is-stable-for-k-l-m-g-l-2-with-the-horizontal-spring-at-b = V″ = 0 em θ = 0 para F = 0: a barra na vertical é estável para k L² > m g L/2 com a mola horizontal em B
bar-along-its-guide-force-at-a-indeterminate = Barra ao longo da sua guia, força em A indeterminada
at-0-the-point-a-has-no-virtual-displacement = Em θ = 0 o ponto A não tem deslocamento virtual

# hanging_chain.toml
chain-of-three-bars = Cadeia de três barras
three-equal-bars-of-60-lbf-each-pulled-with-90-lbf-at-the-free-end-the-weight-is-that-of-the-printed = Três barras iguais de 60 lbf cada, puxadas com 90 lbf na extremidade livre; o peso é o das razões impressas 90/150, 90/90 e 90/30.
force-that-holds-the-second-bar-at-45 = Força que mantém a segunda barra a 45°
f-w-2-w-tan = F = (W₂/2 + W₃) tan θ₂
weight-at-the-end-of-a-light-chain = Peso na ponta de uma cadeia leve
without-self-weight-all-bars-lie-along-the-resultant-of-q-and-f = Sem peso próprio, todas as barras ficam ao longo da resultante de Q e F
bar-without-a-force = Barra sem força
without-loads-every-angle-is-an-equilibrium = Sem cargas, todo ângulo é de equilíbrio

# lazy_tongs.toml
tongs-of-three-squares = Tesoura articulada de três quadrados
bars-at-45-1000-n-at-the-upper-hinges-of-the-first-and-the-second-square-x-b-p-q-cot-6-y-b-p-3-q-6 = Barras a 45°, 1000 N nas articulações superiores do primeiro e do segundo quadrado. X_B = (P + Q) cot θ/6, Y_B = (P + 3 Q)/6.
one-square-a-load-at-its-lower-hinge = Um quadrado, carga na articulação inferior
a-load-below-pulls-the-supports-together-x-b-p-cot-2 = Uma carga embaixo puxa os apoios um para o outro: X_B = −P cot θ/2
loads-above-and-below = Cargas em cima e embaixo
equal-loads-at-the-upper-and-lower-hinges-of-a-square-produce-no-force-along-the-line = Cargas iguais nas articulações superior e inferior de um quadrado não produzem força ao longo da linha
load-on-a-square-that-does-not-exist = Carga em um quadrado que não existe
three-squares = Três quadrados

# mechanism.toml
four-bar-linkage-with-massive-coupler-and-rocker = Mecanismo de quatro barras com acoplador e balancim com massa
lecture-notes-on-the-dynamics-of-machinery-turkish-example-7 = Notas de aula de dinâmica das máquinas (em turco), exemplo 7
the-reference-values-are-those-quoted-from-the-notes-which-print-the-magnitudes-the-drawn-senses = Os valores de referência são os citados das notas de aula; elas imprimem os módulos, e os sentidos desenhados resultam da malha.
the-source-draws-the-velocities-and-accelerations-to-scale = A fonte desenha em escala as velocidades e acelerações.
five-bar-linkage-with-two-drivers = Mecanismo de cinco barras com dois acionamentos
two-holding-torques-equal-to-j-f-with-the-jacobian-of-the-apex = Dois torques de sustentação iguais a −Jᵀ F, com o jacobiano do vértice
cranks-of-50-mm-on-pivots-100-mm-apart-at-75-and-120-rods-of-120-mm-40-n-to-the-right-and-100-n-up-at = Manivelas de 50 mm em pivôs distantes 100 mm, a 75° e 120°, bielas de 120 mm; 40 N para a direita e 100 N para cima no vértice.
geared-five-bar-linkage = Mecanismo de cinco barras engrenado
rise-of-the-apex-by-finite-differences-t-f-dy-d = Subida do vértice por diferenças finitas, T = −F dy/dθ
equal-gears-on-the-two-pivots-in-external-mesh-the-right-crank-rotates-opposite-to-the-left-one = Engrenagens iguais nos dois pivôs, em engrenamento externo: a manivela direita gira no sentido oposto ao da esquerda. Configuração inicial com as manivelas a 70° e 110°.
the-pans-remain-upright-so-only-their-rise-matters = Os pratos permanecem na vertical, e só a sua subida importa
beams-of-250-mm-arms-one-above-the-other-5-kg-lies-300-mm-outside-of-its-pan-s-joint-on-one-side-and = Barras com braços de 250 mm, uma acima da outra; 5 kg estão 300 mm para fora da junta do seu prato de um lado e 100 mm para dentro do outro. O mecanismo tem uma restrição redundante.
compound-epicyclic-gear = Trem epicicloidal composto
a-pinion-a-of-25-teeth-drives-the-external-teeth-90-of-a-gear-whose-internal-teeth-83-mesh-with = Um pinhão A de 25 dentes aciona os dentes externos (90) de uma engrenagem cujos dentes internos (83) engrenam com planetas em torno de uma solar fixa de 31; o braço F é a saída. Sem perdas. Os planetas têm (83 − 31)/2 = 26 dentes; os raios estão em mm, meio milímetro por dente.
disc-rolled-by-a-crank-against-spring-and-damper = Disco rolado por uma manivela contra mola e amortecedor
virtual-power-and-newton-euler-equations-of-another-program = Potência virtual e equações de Newton–Euler de outro programa
perpendicular-to-the-plane-the-block-is-supported-by-n-w-cos-cos-20-with-tan-0-25 = Transversalmente ao plano, o bloco é sustentado por N = W cos φ/cos(20° + φ), com tan φ = 0,25.
disc-of-4-kg-and-radius-150-mm-driven-at-its-centre-by-a-crank-of-60-mm-and-a-rod-of-200-mm-at-8-rad = Disco de 4 kg e 150 mm de raio, movido pelo centro por uma manivela de 60 mm e uma biela de 200 mm a 8 rad/s; mola de 800 N/m, com 100 mm de comprimento livre, e amortecedor de 25 N·s/m até uma parede 200 mm atrás do mancal da manivela. O atrito no piso é a componente em x da força de contato do rolamento.
block-pushed-up-a-rough-plane = Bloco empurrado para cima em um plano rugoso
p-w-tan-20-arctan-0-25 = P = W tan(20° + arctan 0,25)
bar-held-by-a-weight-over-a-pulley = Barra mantida por um peso sobre uma polia
a-uniform-bar-of-10-kg-and-1-5-m-pinned-at-its-lower-end-a-cord-from-its-tip-goes-over-a-small-pulley = Uma barra uniforme de 10 kg e 1,5 m, articulada na extremidade inferior; um cabo da sua ponta passa por uma pequena polia 1,2 m acima da articulação até um bloco suspenso. A massa de 6,53 kg que o livro encontra a equilibra a 20°, até os algarismos impressos: o cabo é modelado como uma haste de dois trechos, e o bloco desliza em uma linha vertical.
cam-with-a-harmonic-lift-of-ten-points = Came com levantamento harmônico de dez pontos
force-of-a-weight-on-a-cam-t-w-ds-d-of-the-spline-through-the-points = Força de um peso em uma came, T = W ds/dθ da spline pelos pontos
ten-points-of-s-20-mm-1-cos-2-at-90-the-slope-of-the-spline-is-10-mm-rad-to-within-its-own-accuracy = Dez pontos de s = 20 mm (1 − cos θ)/2; a 90° a spline tem a inclinação de 10 mm/rad dentro da sua própria precisão.
the-spline-through-ten-points-reproduces-the-slope-of-the-cosine-to-a-few-parts-in-a-thousand = a spline pelos dez pontos reproduz a inclinação do cosseno a menos de alguns milésimos
a-linkage-without-a-driver = Mecanismo sem acionamento
a-linkage-that-is-free-to-move = Um mecanismo livre para se mover
sides-of-50-20-and-20-on-a-base-of-100 = Lados de 50, 20 e 20 em uma base de 100
a-crank-driven-from-its-dead-centre = Manivela acionada a partir do ponto morto
crank-and-rod-in-line = Manivela e biela alinhadas

# motion.toml
andrews-squeezing-mechanism = Mecanismo espremedor de Andrews
e-hairer-g-wanner-solving-ordinary-differential-equations-ii-vii-7-with-the-reference-of-the-test-set = E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, §VII.7, com a referência do conjunto de testes para programas de problemas de valor inicial
seven-bodies-in-three-loops-at-rest-a-spring-and-a-motor-of-0-033-n-m-the-source-gives-the-angle-of = Sete corpos em três malhas, em repouso, uma mola e um motor de 0,033 N m. A fonte traz o ângulo da biela em relação à manivela: aqui estão as somas. Os seus multiplicadores pertencem à primeira junta; os seus sinais são os da força sobre o segundo ponto dela.
simple-pendulum-from-the-horizontal-ten-seconds = Pêndulo simples a partir da horizontal, dez segundos
problem-a01-of-the-iftomm-library-of-computational-benchmark-problems-exact-by-elliptic-functions = Problema A01 da biblioteca da IFToMM de problemas de referência computacionais; exato por funções elípticas
x-sin-y-cos-with-sin-2-k-sn-k-k-t-g-l-k-sin-45 = x = −sen α, y = −cos α com sen(α/2) = k sn(K(k) − t √(g/L)), k = sen 45°.
pendulum-released-from-the-horizontal-to-its-lowest-point = Pêndulo solto da horizontal, até o ponto mais baixo
quarter-period-of-a-pendulum-with-an-amplitude-of-90-and-its-fall = Um quarto do período de um pêndulo com amplitude de 90°, e a sua queda
t-4-k-sin-45-l-g-and-v-2-g-l-for-1-m-and-9-81-m-s = T/4 = K(sen 45°) √(L/g) e v = √(2 g L), para 1 m e 9,81 m/s².
disc-that-rolls-down-a-plane-of-30 = Disco que desce rolando um plano de 30°
a-2-3-g-sin-30-for-a-uniform-disc-that-rolls-without-slip = a = (2/3) g sen 30° para um disco uniforme que rola sem escorregar
from-rest-for-two-seconds-6-54-m-along-the-plane-the-disc-of-100-mm-turns-by-65-4-rad = A partir do repouso, durante dois segundos: 6,54 m ao longo do plano; o disco de 100 mm gira 65,4 rad.
bar-on-a-torsion-spring-started-at-its-equilibrium-position = Barra em mola de torção, a partir da posição de equilíbrio
sin-t-with-i = θ = (ω₀/ωₙ) sen ωₙ t com ωₙ² = κ/I
n-32-n-m-rad-and-i-0-23-3-0-3-0-5-kg-m-8-rad-s-4-rad-s-for-one-second = κ = 32 N m/rad e I = 0,23 + 3·0,3² = 0,5 kg m²: ωₙ = 8 rad/s, ω₀ = 4 rad/s, durante um segundo.
ansys-mechanical-apdl-verification-manual-vm73-after-f-s-tse-i-e-morse-r-t-hinkle-mechanical = Manual de verificação do ANSYS Mechanical APDL, VM73, conforme F. S. Tse, I. E. Morse, R. T. Hinkle, Mechanical Vibrations, p. 175
block-on-an-incline-below-the-angle-of-friction = Bloco em um plano inclinado abaixo do ângulo de atrito
at-rest-the-pin-carries-only-a-vertical-force-its-friction-is-part-of-the-equilibrium-that-determines = Em repouso o pino transmite apenas uma força vertical; o seu atrito faz parte do equilíbrio que a determina.
bar-released-on-a-rough-pin = Barra solta em um pino com atrito
i-g-m-l-m-g-l-r-n-with-n-m-g-l = (I_G + m L²) α = m g L − μ r N com N = m (g − α L)
block-projected-up-an-incline-until-it-returns = Bloco lançado plano inclinado acima, até voltar
half-a-period-of-a-mass-with-dry-friction-the-amplitude-decreases-by-2-m-g-k = Meio período de uma massa com atrito seco: a amplitude diminui 2 μ m g/k
it-remains-at-rest-as-long-as-tan-the-friction-is-m-g-sin = Permanece em repouso enquanto tan φ ≤ μ; o atrito é m g sen φ
it-rises-for-v-g-sin-cos-and-falls-with-g-sin-cos = Sobe durante v/(g (sen φ + μ cos φ)) e desce com g (sen φ − μ cos φ)
mass-of-10-lb-with-a-spring-and-dry-friction-pulled-by-an-inch = Massa de 10 lb com mola e atrito seco, puxada uma polegada
mass-released-on-a-spring-until-it-first-comes-to-rest = Massa solta em uma mola, até o primeiro repouso
spring-weaker-than-the-friction-until-the-block-first-comes-to-rest = Mola mais fraca que o atrito, até o bloco parar pela primeira vez
k-l-l-m-g-the-block-remains-where-it-is-placed = k (L₀ − L) < μ m g: o bloco permanece onde é colocado
k-l-l-4-07758-n-m-g-5-93117-n-a-block-that-never-moves-never-comes-to-rest = k (L₀ − L) = 4,07758 N, μ m g = 5,93117 N. Um bloco que nunca se move nunca para.
the-friction-of-1-875-lbf-is-0-1875-of-the-weight-the-motion-reverses-once-at-0-0923-s-before-the = O atrito de 1,875 lbf é 0,1875 do peso. O movimento se inverte uma vez, em 0,0923 s, antes do instante pedido, 0,183 s.
x-2-m-g-k-x-after-there-the-spring-force-is-less-than-the-friction-and-the-mass-remains-at-rest = x = 2 μ m g/k − X₀ após π/ωₙ; ali a força da mola é menor que o atrito, e a massa fica em repouso.
a-link-without-mass-falls = Uma peça sem massa cai
nothing-that-moves-with-the-link-has-inertia = Nada do que se move com o elo tem inércia

# oscillating_cylinder.toml
hydraulic-cylinder-that-holds-a-lever = Cilindro hidráulico que sustenta uma alavanca
moments-about-the-bearing-f-c-d-w-r-cos-with-the-distance-d-of-the-bearing-from-the-line-of-the = Momentos em relação ao mancal: F_c d = W r cos θ, com a distância d do mancal à linha do cilindro
lever-of-1-m-at-60-with-2-kn-at-its-end-cylinder-from-0-5-0-m-the-end-is-vertically-above-it-so-d-0-5 = Alavanca de 1 m a 60° com 2 kN na ponta; cilindro a partir de (0,5; 0) m: a ponta fica na vertical acima dele, logo d = 0,5 m e o cilindro suporta 2·cos 60°/0,5 = 2 kN.
swinging-cylinder-of-a-steam-engine = Cilindro oscilante de uma máquina a vapor
t-p-a-r-d-sin-s-sign-with-the-pin-at-d-0-s-r-d-2-r-d-cos-and-s-r-d-s-sin = T = −p A r d sen θ/s × sinal: com o pino em (−d, 0), s² = r² + d² + 2 r d cos θ e δs = −(r d/s) sen θ δθ
r-50-mm-d-200-mm-90-s-206-155-mm-u-s-48-507-mm-8-bar-on-60-mm-give-2261-95-n-under-pressure-the-crank = r = 50 mm, d = 200 mm, θ = 90°: s = 206,155 mm, u_s = −48,507 mm; 8 bar em 60 mm dão 2261,95 N. Sob pressão a manivela é retida por −T.
motion-of-the-swinging-cylinder = Movimento do cilindro oscilante
s-r-d-2-r-d-cos-s-s-r-d-sin-s-by-differentiation-once-more-crank-perpendicular-to-the-frame-90 = s² = r² + d² + 2 r d cos θ: s s' = −r d sen θ ω, s'' derivando mais uma vez; manivela perpendicular à base, θ = 90°
at-90-s-r-d-s-s-s-s-since-the-derivative-of-r-d-sin-is-zero-4-r-s = Em θ = 90°: s' = −r d ω/s, s'' = −s'²/s, pois a derivada de r d sen θ é nula; ω_4 = r² ω/s².
force-in-line-with-the-crank = Força alinhada com a manivela
crank-and-cylinder-collinear-s-0 = manivela e cilindro alinhados: δs = 0

# quick_return.toml
shaper-in-its-working-stroke = Plaina limadora no curso de trabalho
m-campbell-s-nestinger-whitworth-quick-return-mechanism-lengths-and-speed-force-and-masses-are-chosen = M. Campbell, S. Nestinger, Whitworth quick-return mechanism: comprimentos e velocidade; força e massas são escolhidas aqui
pivots-25-mm-apart-crank-10-mm-at-30-15-rad-s-lever-65-mm-and-0-2-kg-link-30-mm-line-of-the-slider-50 = Pivôs distantes 25 mm, manivela de 10 mm a −30°, −15 rad/s; alavanca de 65 mm e 0,2 kg, biela de 30 mm, linha do cursor 50 mm acima do pivô da alavanca; 0,5 kg no cursor, 100 N contra o seu movimento. A potência virtual e as equações de Newton e Euler deram o mesmo.
crank-and-slotted-lever-45-past-the-line-of-centres = Manivela e alavanca ranhurada, 45° além da linha dos centros
crank-of-150-mm-at-120-rpm-pivots-400-mm-apart-from-the-printed-intermediate-values-the-book-solves = Manivela de 150 mm a 120 rpm, pivôs distantes 400 mm (dos valores intermediários impressos). O livro resolve graficamente. Acrescenta-se aqui 1 kN perpendicular à alavanca na ponta, a 700 mm.
the-book-reads-the-velocities-off-a-drawing = o livro lê as velocidades em um desenho
the-book-reads-the-accelerations-off-a-drawing = o livro lê as acelerações em um desenho
the-same-lever-to-more-digits = A mesma alavanca com mais algarismos
r-s-khurmi-j-k-gupta-theory-of-machines-ex-8-13-t-2-f-l-4-and-the-derivatives-of-tan-4 = R. S. Khurmi, J. K. Gupta, Theory of Machines, ex. 8.13: T ω_2 = F L ω_4 e as derivadas de tan θ_4
crank-across-the-lever = Manivela transversal à alavanca
at-2-90-crank-and-lever-are-collinear-h-4-r-d-r-no-slip-t-f-l-r-d-r = Em θ_2 = 90° manivela e alavanca são colineares: h_4 = r/(d + r), sem deslizamento; T = F L r/(d + r)
whitworth-quick-return-lever-with-full-rotation = Retorno rápido de Whitworth, alavanca com rotação completa
at-2-90-h-4-r-d-r-time-ratio-2-arcsin-d-r-2-arcsin-d-r-2-for-d-r-2 = Em θ_2 = 90°, h_4 = r/(d + r); razão de tempos (π + 2 arcsen(d/r))/(π − 2 arcsen(d/r)) = 2 para d = r/2
force-at-the-end-of-the-lever-s-stroke = Força no fim de curso da alavanca
sin-2-r-d-the-lever-touches-the-circle-of-the-crank-pin = sen θ_2 = −r/d: a alavanca tangencia o círculo do pino da manivela
link-too-short-for-the-slider-s-line = Biela curta demais para a linha do cursor
the-end-of-the-lever-is-60-mm-below-the-line-the-link-is-50-mm-long = a ponta da alavanca está 60 mm abaixo da linha, a biela tem 50 mm

# rack_press.toml
arbor-press = Prensa manual de cremalheira
geared-press-with-losses = Prensa com engrenagens e perdas
f-q-r-r-i-with-r-m-z-2 = F = Q r/(R i η) com r = m z/2
pinion-with-half-a-tooth = Pinhão com meio dente
numbers-of-teeth-are-integers = Os números de dentes são inteiros

# rhombus.toml
load-on-a-rhombus-with-a-spring-between-the-sides = Carga em um losango com mola entre os lados
n-2-q-l-sin-4-w-l-sin-4-k-l-sin-sin-cos = 2 Q L sen θ + 4 W L sen θ = 4 k L² (sen θ₀ − sen θ) cos θ
the-same-load-and-its-equilibrium-position = A mesma carga, e a sua posição de equilíbrio
n-2-q-l-sin-4-k-l-sin-sin-cos = 2 Q L sen θ = 4 k L² (sen θ₀ − sen θ) cos θ
spring-along-the-height = Mola ao longo da altura
q-2-w-2-k-l-cos-cos-with-w-0-the-spring-carries-the-load-itself = Q + 2 W = 2 k L (cos θ − cos θ₀) com W = 0: a própria mola sustenta a carga
closed-rhombus-load-indeterminate = Losango fechado, carga indeterminada
at-0-the-lower-corner-has-no-virtual-displacement = Em θ = 0 o vértice inferior não tem deslocamento virtual

# roberval_balance.toml
equal-masses-at-unequal-offsets = Massas iguais com afastamentos desiguais
the-pans-only-translate-equal-masses-balance-wherever-they-are-placed = Os pratos só transladam: massas iguais se equilibram em qualquer posição
the-tilted-balance = A balança inclinada
the-pans-only-translate-equal-masses-balance-at-every-inclination = Os pratos só transladam: massas iguais se equilibram em toda inclinação
unequal-arms = Braços desiguais
a-heavier-right-pan = Prato direito mais pesado
t-m-l-m-l-g-cos = T = (m₂ l₂ − m₁ l₁) g cos φ
vertical-beams = Barras verticais
at-90-the-pans-move-only-sideways-and-no-weight-does-virtual-work = A 90° os pratos só se movem para o lado, e nenhum peso realiza trabalho virtual

# rolling_disc.toml
disc-against-spring-and-damper-at-8-rad-s = Disco contra mola e amortecedor a 8 rad/s
t-k-x-x-w-l-0-c-v-3-2-m-a-u-with-the-motion-of-a-slider-crank-virtual-power-and-the-newton-euler = T = −[−k (x − x_w − L_0) − c v − (3/2) m a] u com o movimento de um cursor-manivela; a potência virtual e as equações de Newton–Euler deram o mesmo
crank-60-mm-at-50-rod-200-mm-disc-of-4-kg-and-150-mm-spring-of-800-n-m-from-a-wall-at-200-mm-free = Manivela de 60 mm a 50°, biela de 200 mm; disco de 4 kg e 150 mm; mola de 800 N/m a partir de uma parede em −200 mm, comprimento livre de 100 mm; amortecedor de 25 N·s/m. O torque não depende da gravidade.
a-ring-accelerates-as-twice-its-mass = Um anel acelera como o dobro da sua massa
i-m-r-t-2-m-a-u-at-90-with-l-2-r-u-r-a-r-l-r-r = I = m R²: T = 2 m a u; em 90° com l = √2 r: u = −r, a = r² ω²/√(l² − r²) = r ω²
at-2-90-the-rod-has-tan-r-l-r-1-so-x-l-r-sin-r-cos-has-x-r-l-r-r = Em θ_2 = 90° a biela tem tan φ = r/√(l² − r²) = 1, portanto x = √(l² − r² sen² θ) + r cos θ tem x'' = r²/√(l² − r²) = r.
spring-in-static-equilibrium = Mola em equilíbrio estático
f-k-s-l-0-with-s-300-mm-200-mm-500-0-1-50-n-holds-the-disc-without-a-torque = F = k (s − L_0) com s = 300 mm + 200 mm: 500·0,1 = 50 N mantêm o disco sem torque
force-at-a-dead-centre = Força em um ponto morto
crank-and-rod-collinear-x-0 = manivela e biela alinhadas: δx = 0

# scissor_lift.toml
lift-table-with-a-crate-of-1000-kg = Plataforma pantográfica com um caixote de 1000 kg
beer-johnston-vector-mechanics-for-engineers-9th-and-10th-ed-sample-problem-10-3 = Beer & Johnston, Vector Mechanics for Engineers, 9ª e 10ª ed., problema resolvido 10.3
two-frames-each-with-a-cylinder-from-the-ground-at-3-2-m-from-the-fixed-foot-to-the-middle-of-a-bar = Duas armações, cada uma com um cilindro do solo, a 3,2 m do pé fixo, ao meio de uma barra de 1,4 m. F = ½ W √(a² + L² − 2 a L cos θ)/L · 2 cot θ/2. O livro arredonda para 5,15 kN; a sua transcrição publicada dá 5,16 kN.
the-lift-table-more-digits = A plataforma pantográfica, mais algarismos
beer-johnston-sample-problem-10-3-f-w-a-l-2-a-l-cos-cot-l-for-both-cylinders-together = Beer & Johnston, problema resolvido 10.3: F = W √(a² + L² − 2 a L cos θ) cot θ/L para os dois cilindros juntos
load-lifted-by-the-cylinders = Carga levantada pelos cilindros
the-same-closed-form-solved-in-reverse = A mesma forma fechada, resolvida no sentido inverso
three-stages-with-a-level-cylinder-between-the-feet = Três estágios com um cilindro horizontal entre os pés
f-n-w-n-g-cot-for-a-cylinder-along-the-ground-with-2-n-bars-of-weight-g-its-length-l-cos-the-height-n = F = −n (W + n G) cot θ para um cilindro ao longo do solo, com 2 n barras de peso G; seu comprimento L cos θ, a altura n L sen θ
vertical-cylinder-under-the-table = Cilindro na vertical sob a mesa
a-vertical-cylinder-from-ground-to-table-carries-the-whole-load-and-is-n-l-sin-long = Um cilindro vertical, do solo à mesa, sustenta toda a carga e tem comprimento n L sen θ
cylinder-of-stationary-length = Cilindro de comprimento estacionário
both-ends-on-one-bar = As duas extremidades em uma mesma barra

# scotch_yoke.toml
yoke-with-a-load-and-a-mass-at-30-rad-s = Garfo escocês com carga e massa a 30 rad/s
t-m-r-sin-cos-f-r-sin-the-load-f-opposing-x-the-largest-of-twelve-angles-0-1-rad-and-every-30-on-is = T = m r² ω² sen θ cos θ − F r sen θ, com a carga F oposta a x; o maior de doze ângulos, 0,1 rad e a cada 30° daí em diante, está em 0,1 rad + 240°
r-80-mm-300-n-against-x-4-kg-the-reference-found-no-difference-from-this-formula-at-the-twelve-angles = r = 80 mm, 300 N contra x, 4 kg. A referência não encontrou diferença em relação a esta fórmula nos doze ângulos.
the-same-yoke-at-30 = O mesmo garfo a 30°
t-300-0-08-sin-30-4-0-08-30-sin-30-cos-30 = T = −(300·0,08·sen 30° − 4·0,08²·30²·sen 30° cos 30°)
the-same-yoke-at-225 = O mesmo garfo a 225°
t-300-0-08-sin-225-4-0-08-30-sin-225-cos-225 = T = −(300·0,08·sen 225° − 4·0,08²·30²·sen 225° cos 225°)
force-from-a-torque = Força a partir de um torque
f-t-r-sin-12-0-08-sin-150 = F = T/(r sen θ) = 12/(0,08·sen 150°)
the-crank-lies-along-the-line-of-the-yoke-x-0 = a manivela está na linha do garfo: δx = 0

# screw_jack.toml
scissor-jack-of-four-crossed-links = Macaco de tesoura de quatro barras cruzadas
r-c-hibbeler-engineering-mechanics-statics-problem-11-3-t-2-p-cot = R. C. Hibbeler, Engineering Mechanics: Statics, problema 11-3: T = 2 P cot θ
four-links-pinned-at-their-centres-are-two-stages-the-book-gives-the-formula-its-value-for-10-kn-and = Quatro barras unidas por pinos nos centros são dois estágios. O livro dá a fórmula; o seu valor para 10 kN e 30° é 34,641 kN.
car-jack-with-a-rhombus-and-a-trapezoidal-screw = Macaco de automóvel com losango e parafuso trapezoidal
t-p-cot-m-t-d-2-tan-tan-cos = T = P cot θ, M = T (d/2) tan(α + φ), tan φ = μ/cos λ
plain-jack-with-a-collar = Macaco simples com colar
m-p-d-2-d-d-p-c-d-c-2-square-thread = M = P (d/2) (ℓ + π μ d)/(π d − μ ℓ) + P μ_c d_c/2, rosca quadrada
load-that-20-n-m-raises-on-two-threads = Carga que 20 N·m levantam com duas roscas
p-m-tan-d-tan-for-a-rhombus-with-a-right-hand-and-a-left-hand-thread = P = M tan θ/(d tan(α + φ)) para um losango com rosca direita e rosca esquerda
p-t-tan-the-height-2-l-sin = P = T tan θ; a altura 2 L sen θ
a-torque-without-a-screw = Torque sem parafuso
a-torque-requires-a-lead = O torque requer o avanço da rosca

# six_bar.toml
press-driven-by-a-crank-rocker-at-its-largest-torque = Prensa acionada por manivela-balancim, no seu maior torque
crank-rocker-60-140-110-150-mm-whose-rocker-end-drives-a-slider-on-the-line-of-the-frame-through-200 = Manivela-balancim 60/140/110/150 mm cuja ponta do balancim aciona um cursor na linha da base por uma biela de 200 mm; a potência virtual e as equações de Newton e Euler deram o mesmo em 24 posições, de 0,05 rad em passos de 15°
steel-links-as-uniform-bars-of-1-2-0-9-and-1-5-kg-slider-of-6-kg-2-kn-against-x-12-rad-s-with-5-rad-s = Elos de aço como barras uniformes de 1,2, 0,9 e 1,5 kg, cursor de 6 kg, 2 kN contra x, 12 rad/s com 5 rad/s². Ao longo das 24 posições o torque varia de −99,787728 a 151,8945 N·m, com média de 0,069 N·m.
the-same-press-at-its-least-torque = A mesma prensa no seu menor torque
crank-rocker-60-140-110-150-mm-with-a-slider-virtual-power-and-the-equations-of-newton-and-euler = Manivela-balancim 60/140/110/150 mm com um cursor: potência virtual e as equações de Newton e Euler
watt-chain-two-parallelograms-in-series = Watt: dois paralelogramos em série
crank-rocker-and-second-rocker-stay-parallel-t-2-t-6-all-have-the-same-rotation = Manivela, balancim e segundo balancim permanecem paralelos: T_2 = −T_6, todos têm a mesma rotação
stephenson-a-slider-crank-hung-on-a-parallelogram-s-crank-pin = Stephenson: um cursor-manivela ligado ao pino da manivela de um paralelogramo
d-a-t-f-r-sin-tan-cos-beer-johnston-12e-prob-10-21-a-with-additional-links = D = A: T = F r (sen θ + tan φ cos θ), Beer & Johnston, 12ª ed., probl. 10.21 (a), com elos adicionais
force-on-an-inclined-slider-from-the-torque = Força em um cursor inclinado a partir do torque
the-same-slider-crank-turned-by-20-crank-at-50-line-at-20 = O mesmo cursor-manivela girado de 20°: manivela a 50°, linha a 20°
a-force-on-a-rocker = Força em um balancim
a-rocker-takes-a-torque = um balancim recebe um torque
second-dyad-too-short-to-assemble = Segunda díade curta demais para montar
the-distance-from-d-to-e-is-more-than-the-links-can-span = a distância de D a E é maior do que os elos alcançam

# slider_crank.toml
slider-crank-of-the-course-with-a-motion-that-closes-its-loop = Cursor-manivela da disciplina com um movimento que fecha a malha
riul-unit-ii-example-1-its-layout-with-r-150-mm-l-200-mm-and-the-motion-that-follows = Riul, Unidade II, exemplo 1: sua configuração com r = 150 mm, l = 200 mm e o movimento que daí resulta
crank-at-30-steady-20-rad-s-rod-of-3-kg-with-its-centre-of-mass-in-the-middle-slider-of-2-kg-5-kn-on = Manivela a 30°, 20 rad/s constantes; biela de 3 kg com o centro de massa no meio, cursor de 2 kg, com 5 kN no sentido de afastá-lo do mancal. A potência virtual e as equações de Newton e Euler deram o mesmo.
horizontal-force-that-holds-a-loaded-linkage = Força horizontal que mantém um mecanismo carregado
weightless-bars-of-0-6-m-and-0-7-m-at-45-200-n-downwards-at-their-common-pin-the-force-is-drawn = Barras sem peso de 0,6 m e 0,7 m a 45°, 200 N para baixo no pino comum. A força é desenhada em direção ao pino fixo: aqui é negativa. Os 114 N impressos são calculados com comprimentos arredondados.
the-book-computes-with-lengths-of-three-digits = o livro calcula com comprimentos de três algarismos
couple-on-the-crank-of-an-engine-at-30 = Binário na manivela de um motor a 30°
f-p-beer-e-r-johnston-vector-mechanics-for-engineers-statics-12th-ed-prob-10-21-a = F. P. Beer, E. R. Johnston, Vector Mechanics for Engineers: Statics, 12ª ed., probl. 10.21 (a)
n-4-kn-on-the-piston-toward-the-bearing-the-equilibrant-couple-is-clockwise-negative-here = 4 kN no pistão em direção ao mancal. O binário equilibrante é horário: aqui é negativo.
couple-on-the-crank-of-an-engine-at-150 = Binário na manivela de um motor a 150°
f-p-beer-e-r-johnston-vector-mechanics-for-engineers-statics-12th-ed-prob-10-21-b = F. P. Beer, E. R. Johnston, Vector Mechanics for Engineers: Statics, 12ª ed., probl. 10.21 (b)
force-on-a-piston-from-the-couple-at-60 = Força em um pistão a partir do binário, a 60°
f-p-beer-e-r-johnston-vector-mechanics-for-engineers-statics-7th-ed-prob-10-20-a = F. P. Beer, E. R. Johnston, Vector Mechanics for Engineers: Statics, 7ª ed., probl. 10.20 (a)
force-on-a-piston-from-the-couple-at-120 = Força em um pistão a partir do binário, a 120°
f-p-beer-e-r-johnston-vector-mechanics-for-engineers-statics-7th-ed-prob-10-20-b = F. P. Beer, E. R. Johnston, Vector Mechanics for Engineers: Statics, 7ª ed., probl. 10.20 (b)
couple-for-1-kip-on-the-piston-at-30 = Binário para 1 kip no pistão, a 30°
f-p-beer-e-r-johnston-vector-mechanics-for-engineers-statics-7th-ed-prob-10-19-a-no-printed-answer = F. P. Beer, E. R. Johnston, Vector Mechanics for Engineers: Statics, 7ª ed., probl. 10.19 (a): sem resposta impressa disponível; T = F r (sen θ + tan φ cos θ)
couple-for-1-kip-on-the-piston-at-150 = Binário para 1 kip no pistão, a 150°
f-p-beer-e-r-johnston-vector-mechanics-for-engineers-statics-7th-ed-prob-10-19-b-no-printed-answer = F. P. Beer, E. R. Johnston, Vector Mechanics for Engineers: Statics, 7ª ed., probl. 10.19 (b): sem resposta impressa disponível; T = F r (sen θ + tan φ cos θ)
engine-with-a-massive-rod-at-314-rad-s = Motor com biela com massa a 314 rad/s
dynamics-of-machines-turkish-lecture-notes-example-9-the-answers-are-known-from-a-program-that-quotes = Dinâmica das máquinas, notas de aula em turco, exemplo 9 (as respostas são conhecidas por um programa que as cita)
lengths-51-mm-and-200-mm-at-60-rod-of-1-36-kg-with-its-centre-of-mass-51-mm-from-the-crank-pin-piston = Comprimentos de 51 mm e 200 mm a 60°; biela de 1,36 kg com o centro de massa a 51 mm do pino da manivela, pistão de 0,91 kg, com 6,3 kN em direção ao mancal. As notas de aula resolvem graficamente.
with-the-rod-along-the-line-the-transmission-angle-is-90-with-the-crank-on-the-opposite-side-the-rod = Com a biela na linha, o ângulo de transmissão é 90°; meia volta depois, a biela tem de cobrir 2 r, e cos μ_min = 2 r/l.
crank-perpendicular-to-the-line-of-an-offset-slider = Manivela perpendicular à linha de um cursor excêntrico
n-2-90-e-r-the-rod-lies-along-the-line-u-b-r-so-t-f-r-the-guide-carries-no-force = θ_2 = 90°, e = r: a biela fica ao longo da linha, u_B = −r, logo T = F r; a guia não suporta força
weights-alone = Só os pesos
two-uniform-bars-of-equal-length-a-both-centres-of-mass-rise-by-a-2-cos-so-t-m-2-m-3-g-a-2-cos = duas barras uniformes de igual comprimento a: os dois centros de massa sobem (a/2) cos θ δθ, logo T = (m_2 + m_3) g (a/2) cos θ
rod-too-short-for-the-offset = Biela curta demais para a excentricidade
a-rod-of-100-mm-cannot-span-130-mm = uma biela de 100 mm não alcança 130 mm
crank-and-rod-collinear-x-b-0 = manivela e biela alinhadas: δx_B = 0

# spring_lever.toml
beer-johnston-vector-mechanics-for-engineers-9th-ed-sample-problem-10-4 = Beer & Johnston, Vector Mechanics for Engineers, 9ª ed., problema resolvido 10.4
a-mass-on-an-arm-fixed-to-a-disc-vertical-upwards-when-the-spring-on-a-cord-around-the-disc-is = Uma massa em um braço fixo a um disco, na vertical, para cima, quando a mola, em um cabo ao redor do disco, está sem deformação. sen θ = k a²/(m g b) θ.
the-weight-on-the-disc-in-radians = O peso no disco, em radianos
lever-on-a-torsion-shaft = Alavanca em um eixo de torção
beer-johnston-vector-mechanics-for-engineers-statics-7th-ed-problems-10-39-and-10-73 = Beer & Johnston, Vector Mechanics for Engineers: Statics, 7ª ed., problemas 10.39 e 10.73
p-l-cos-k-with-k-150-lbf-ft-rad = P l cos θ = K θ, com K = 150 lbf·ft/rad.
weight-on-a-drum-with-a-spring = Peso em um tambor com mola
w-l-sin-k-r-that-is-sin-0-9 = W l sen θ = k r² θ, isto é, sen θ = 0,9 θ.
at-44-1-sin-0-6959-and-0-9-0-6927-no-equilibrium-the-root-of-sin-0-9-is-45-07-the-printed-value-is-an = A 44,1° sen θ = 0,6959 e 0,9 θ = 0,6927: não há equilíbrio. A raiz de sen θ = 0,9 θ é θ = 45,07°; o valor impresso é um erro da solução por tentativas.
weight-on-a-drum-with-a-spring-corrected = Peso sobre um tambor com mola, corrigido
e-w-nelson-c-l-best-w-g-mclean-schaum-s-outline-of-engineering-mechanics-problem-11-10-with-the-root = E. W. Nelson, C. L. Best, W. G. McLean, Schaum's Outline of Engineering Mechanics, problema 11.10, com a raiz de sen θ = 0,9 θ
inverted-bar-between-two-springs = Barra invertida entre duas molas
beer-johnston-vector-mechanics-for-engineers-statics-problems-on-stability-of-a-bar-with-springs-on = Beer & Johnston, Vector Mechanics for Engineers: Statics, problemas sobre a estabilidade de uma barra com molas dos dois lados; 2 k a² = P l
the-bar-on-springs-that-are-too-soft = A barra sobre molas macias demais
n-2-k-a-cos-p-l-has-no-root-other-than-0-when-2-k-a-p-l = 2 k a² cos θ = P l não tem raiz além de θ = 0 quando 2 k a² < P l
lever-with-a-spring-between-two-points = Alavanca com uma mola entre dois pontos
beer-johnston-vector-mechanics-for-engineers-statics-7th-ed-problem-10-35 = Beer & Johnston, Vector Mechanics for Engineers: Statics, 7ª ed., problema 10.35
lever-of-two-arms-l-spring-from-its-other-end-to-a-point-at-l-below-the-pivot-unstretched-with-the = Alavanca de dois braços l, mola da sua outra ponta a um ponto a l abaixo do pivô, sem alongamento com a alavanca na horizontal: P l cos θ = k l² (2 sen(45° + θ/2) − √2) cos(45° + θ/2). O valor final do livro não é conhecido.
stiffness-of-the-torsion-shaft-for-60 = Rigidez do eixo de torção para 60°
k-p-l-cos-400-10-cos-60-3-lbf-in-rad = K = P l cos θ/θ = 400·10·cos 60°/(π/3) lbf·in/rad
mass-on-the-disc-for-60 = Massa no disco para 60°
m-k-a-g-b-sin = m = k a² θ/(g b sen θ)
tilted-arm-held-by-hand = Braço inclinado segurado com a mão
t-k-a-m-g-b-sin = T = k a² (θ − θ₀) − m g b sen(θ + φ₀)
hanging-arm-under-a-couple = Braço pendente sob um binário
m-w-l-sin-k = M = W l sen θ + K θ
lamp-arm-with-zero-free-length-springs = Braço de luminária com molas de comprimento livre nulo
v-w-l-cos-k-b-d-2-b-d-cos-2-is-constant-for-k-b-d-w-l = V = W l cos θ + k (b² + d² − 2 b d cos θ)/2 é constante para k b d = W l
no-equilibrium-in-the-range = Nenhum equilíbrio no intervalo
sin-0-87-has-no-root-between-60-and-120 = sen θ = 0,87 θ não tem raiz entre 60° e 120°
vertical-arm-load-indeterminate = Braço vertical, carga indeterminada
at-0-the-weight-does-no-virtual-work = Em θ = 0 o peso não realiza trabalho virtual

# toggle_press.toml
symmetric-toggle-at-10 = Prensa de joelho simétrica a 10°
q-p-2-tan = Q = P/(2 tan α)
force-on-the-knee-for-a-thrust = Força no joelho para um empuxo
p-q-tan-tan-sin-l-sin-l-0-25 = P = Q (tan α + tan β), sen β = L₁ sen α/L₂ = 0,25
link-too-short-to-assemble = Barra curta demais para montar
l-sin-212-1-mm-is-more-than-l-200-mm = L₁ sen α = 212,1 mm é mais que L₂ = 200 mm

# two_bar_linkage.toml
two-bars-pulled-apart = Duas barras puxadas nas extremidades
two-uniform-bars-of-10-kg-and-1-m-sag-between-a-pin-and-a-roller-that-is-pulled-with-25-n-tan-w-2-f = Duas barras uniformes de 10 kg e 1 m pendem entre uma articulação e um rolete puxado com 25 N: tan θ = W/(2 F).
force-that-holds-the-two-bars-at-45 = Força que mantém as duas barras a 45°
f-w-2-tan = F = W/(2 tan θ)
bars-on-a-roller-and-a-spring = Barras sobre um rolete e uma mola
q-cos-4-k-l-cos-cos-sin = Q cos θ = 4 k L (cos θ − cos θ₀) sen θ
the-load-presses-the-joint-down-and-the-spring-between-the-feet-holds-them-together = A carga empurra a articulação para baixo, e a mola entre os pés os mantém juntos.
vertical-bars-load-indeterminate = Barras verticais, carga indeterminada
at-90-the-loads-on-b-do-no-virtual-work = Em θ = 90° as cargas em B não realizam trabalho virtual

# virtual_power.toml
slider-crank-with-given-vectors = Cursor-manivela com vetores dados
riul-unit-ii-example-1 = Riul, Unidade II, exemplo 1
link-2-is-the-crank-3-the-rod-4-the-slider-the-mass-of-the-slider-2-kg-is-that-of-the-printed = O elo 2 é a manivela, o 3 a biela, o 4 o cursor. A massa do cursor, 2 kg, é a dos produtos impressos. O torque impresso exige dois erros ao mesmo tempo: só a vírgula deslocada (−45 000 W para a força de inércia da biela) dá 82 750 N·m, só o sinal errado (+4 000 W para o seu binário de inércia) dá 102 600 N·m. Os vetores não pertencem a nenhum cursor-manivela; a soma das potências os usa como estão impressos.
the-inertia-couple-is-i-80-n-m-and-the-rod-turns-at-50-rad-s-their-product-is-4-000-w-the-notes-write = O binário de inércia é −I α = +80 N·m e a biela gira a −50 rad/s: o produto é −4 000 W. As notas de aula escrevem estes dois fatores e perdem o sinal do produto.
the-powers-are-2-500-000-6-000-900-000-450-000-4-000-2-060-000-w-so-20-t-2-060-000-w-and-t-103-000-n = As potências são −2 500 000 − 6 000 + 900 000 − 450 000 − 4 000 = −2 060 000 W, logo 20 T = 2 060 000 W e T = 103 000 N·m. O valor impresso exige dois erros juntos: −45 000 W em lugar dos −450 000 W da própria linha (1.f), e +4 000 W em lugar de −4 000 W. Só o primeiro erro dá 82 750, só o sinal 102 600.
slider-crank-with-a-motion-that-closes-its-loop = Cursor-manivela com um movimento que fecha a malha
riul-unit-ii-example-1-with-r-150-mm-l-200-mm-and-the-motion-that-follows-sum-of-powers-and-newton = Riul, Unidade II, exemplo 1, com r = 150 mm, l = 200 mm e o movimento que daí resulta; soma das potências e equações de Newton–Euler de outro programa
the-layout-of-example-1-at-30-and-a-constant-20-rad-s-centre-of-mass-at-the-middle-of-the-rod = A configuração do exemplo 1 a 30° e 20 rad/s constantes, centro de massa no meio da biela.
engine-at-3000-rpm-gas-force-and-inertia = Motor a 3000 rpm, força do gás e inércia
crank-51-mm-rod-200-mm-314-rad-s-6300-n-on-the-piston-towards-the-crank-at-60-the-magnitude-is = Manivela de 51 mm, biela de 200 mm, 314 rad/s; 6300 N no pistão, em direção à manivela, a 60°. Está impresso o módulo; o torque motor é negativo porque é o motor que aciona. O mecanismo está em um plano horizontal.
the-printed-velocities-and-accelerations-were-measured-on-a-drawing = as velocidades e acelerações impressas foram medidas em um desenho
engine-with-4-kn-on-the-piston-at-30 = Motor com 4 kN no pistão a 30°
beer-johnston-statics-12th-ed-problem-10-21 = Beer & Johnston, Statics, 12ª ed., problema 10.21
crank-50-mm-rod-200-mm-for-1-rad-s-the-piston-moves-at-r-sin-cos-tan-with-sin-1-8-the-book-prints-the = Manivela de 50 mm, biela de 200 mm: para 1 rad/s o pistão move-se a r (sen θ + cos θ tan φ) com sen φ = 1/8. O livro imprime o módulo; o binário se opõe à rotação causada pela força.
force-on-a-piston-that-holds-a-crank-at-60 = Força em um pistão que mantém a manivela a 60°
beer-johnston-statics-7th-ed-problem-10-20 = Beer & Johnston, Statics, 7ª ed., problema 10.20
crank-2-5-in-rod-10-in-couple-75-lb-ft-on-the-crank = Manivela de 2,5 in, biela de 10 in, binário de 75 lb·ft na manivela.
force-on-a-piston-that-holds-a-crank-at-120 = Força em um pistão que mantém a manivela a 120°
two-levers-joined-by-a-link = Duas alavancas unidas por uma ligação
beer-johnston-statics-9th-ed-problem-10-1 = Beer & Johnston, Statics, 9ª ed., problema 10.1
virtual-displacements-in-place-of-velocities-when-a-goes-down-by-1-c-goes-down-by-2-d-by-1-e-and-g-by = Deslocamentos virtuais em lugar de velocidades: quando A desce 1, C desce 2, D desce 1, E e G descem 1/2. A força em C equilibra as cargas.
two-levers-joined-by-a-link-other-loads = Duas alavancas unidas por uma ligação, outras cargas
beer-johnston-statics-10th-11th-ed-problem-10-1 = Beer & Johnston, Statics, 10ª/11ª ed., problema 10.1
the-same-levers-with-80-60-20-and-40-n = As mesmas alavancas com 80, 60, 20 e 40 N.
couple-and-force-on-coupled-links-force-at-g = Binário e força em alavancas acopladas, força em G
beer-johnston-statics-8th-ed-problem-10-1 = Beer & Johnston, Statics, 8ª ed., problema 10.1
link-abc-rotates-three-times-as-fast-as-defg-375-mm-125-mm-and-in-the-sense-opposite-to-its-couple-e = O elo ABC gira três vezes mais depressa que DEFG (375 mm : 125 mm) e no sentido contrário ao do seu binário. E está a 250 mm de D; G está a 100√2 mm de D, a 45°, e por isso se desloca 100 mm na vertical para um radiano.
couple-and-force-on-coupled-links-couple-on-defg = Binário e força em alavancas acopladas, binário em DEFG
beer-johnston-statics-8th-ed-problem-10-3 = Beer & Johnston, Statics, 8ª ed., problema 10.3
the-same-links-held-by-a-couple-on-defg = Os mesmos elos, mantidos por um binário em DEFG.
pinion-a-25-teeth-drives-the-wheel-b-90-whose-annulus-c-83-turns-planets-about-a-fixed-sun-e-31-the = O pinhão A (25 dentes) aciona a engrenagem B (90), cuja coroa interna C (83) gira planetas em torno de uma solar fixa E (31). O braço gira a −(25/90)·83/(83 + 31) da velocidade do pinhão.
angle-in-the-initial-configuration = Ângulo na configuração inicial
position-in-the-initial-configuration = Posição na configuração inicial
distance-in-the-initial-configuration = Distância na configuração inicial
the-drawn-position-fixes-how-gears-mesh-how-far-wheels-have-rolled-how-long-cords-are-and-on-which = A posição desenhada fixa o engrenamento, o rolamento das rodas, o comprimento dos cabos e o lado em que o mecanismo é montado; o mecanismo se move a partir dela. Se omitido, o mecanismo é desenhado com o ângulo acima.
the-drawn-position-fixes-the-gear-meshing-the-rolling-of-wheels-the-cord-lengths-and-the-side-on = A posição desenhada fixa o engrenamento, o rolamento das rodas, o comprimento dos cabos e o lado em que o mecanismo é montado; o mecanismo se move a partir dela. Se omitido, o mecanismo é desenhado com o ângulo acima.
the-mechanism-is-drawn-with-this-value-and-moves-from-there-if-omitted-it-is-drawn-with-the-position = O mecanismo é desenhado com este valor e se move a partir dele. Se omitido, é desenhado com a posição acima.
the-mechanism-is-drawn-with-this-value-and-moves-from-there-if-omitted-it-is-drawn-with-the-distance = O mecanismo é desenhado com este valor e se move a partir dele. Se omitido, é desenhado com a distância acima.
initial-guess-of-the-origin-of-its-axes = Estimativa inicial da origem dos seus eixos
required-where-joints-and-drivers-do-not-determine-it-as-for-a-weight-at-the-end-of-a-cord-and-to = Necessário quando juntas e acionamentos não a determinam, como um peso na ponta de um cabo, e para escolher o lado em que um cursor é montado.
joints-and-drivers-do-not-determine-the-position-give-the-position-of-names-an-arbitrary-one-is = as juntas e os acionamentos não determinam a posição: informe a posição de { $names }; foi adotada uma qualquer
joints-and-drivers-do-not-determine-the-position-of-names-give-it = as juntas e os acionamentos não determinam a posição de { $names }: informe-a
the-plots-end-at-end-why = os gráficos terminam em { $end }: { $why }
in-this-position-the-joints-allow-more-motions-than-there-are-drivers-although-the-numbers-match-a = nesta posição as juntas permitem mais movimentos do que há acionamentos, embora o número deles confira: é uma posição singular; desenhe o mecanismo em outra
linear-interpolation-between-the-rows = Interpolação linear entre as linhas.
periodic-cubic-spline-through-the-rows = Spline cúbica periódica pelas linhas da tabela.
the-remaining-stroke-of-the-ram-from-the-lengths-along-the-line-of-thrust = o curso restante do êmbolo pelos comprimentos ao longo da linha de empuxo
remaining-stroke-of-the-ram-until-the-links-are-collinear-l-1-cos-l-1-cos-with-1-cos-x-2-sin-x-2 = Curso restante do êmbolo até o alinhamento das barras, L₁ (1 − cos α) + L₂ (1 − cos β) com 1 − cos x = 2 sen²(x/2)
with-these-angles-it-can-also-be-assembled-on-another-side-give-the-position-of-names-or-check-in-the = com estes ângulos a montagem também é possível do outro lado: informe a posição de { $names }, ou verifique no desenho se este é o lado desejado
a-disc-accelerates-as-one-and-a-half-times-its-mass = Um disco acelera como uma vez e meia a sua massa
i-m-r-2-t-3-2-m-a-u-at-90-with-l-2-r-u-r-a-r-friction-m-a-2 = I = m R²/2: T = 3/2 m a u a 90° com l = √2 r, u = −r, a = r ω²; atrito −m a/2
two-geared-links-a-couple-on-the-second = Duas barras engrenadas, um binário na segunda
t-t-m-g-v-i-0 = T₁ ω₁ + T₂ ω₂ − m g v − I α ω₂ = 0
slider-behind-its-driving-pin = Cursor atrás do seu pino de acionamento
x-p-x-l-p-y-with-p-on-the-rocker-of-the-closed-loop-t-f-dx-d = x = P_x − √(l² − P_y²) com P no balancim da cadeia fechada; T = −F dx/dθ
pressure-over-the-crank-angle-against-a-torque = Pressão sobre o ângulo da manivela contra um torque
f-p-p-a-with-p-halfway-between-4-and-1-mpa-m-f-r-sin-cos-f-m-t-r-i-f = F = (p − p₀) A com p a meio caminho entre 4 e 1 MPa; M = F r sen(θ + φ)/cos φ; α_F = (M − T_R)/I_F
triangular-moment-of-a-two-stroke-engine-on-a-known-flywheel = Torque triangular de um motor de dois tempos com volante conhecido
the-mean-is-200-n-m-e-600-n-m-135-c-s-e-i = a média é 200 N·m; ΔE = ½ · 600 N·m · 135°; C_s = ΔE/(I ω²)
hanging-bar-spring-stiffness-unknown = Barra suspensa, rigidez da mola desconhecida
k-m-g-2-p-l-sin-c-sin-sin-cos-and-v-there = k = (m g/2 + P) L sen θ/(c² (sen θ₀ − sen θ) cos θ) e V″ ali
rods-with-the-apex-on-the-right = Bielas com o vértice à direita
the-loop-closed-by-two-circles-differentiated-t-f-dp-d = a cadeia fechada por dois círculos, derivada: T = −F·dP/dθ
cranks-in-external-mesh-ratio-1-2 = Manivelas em engrenamento externo, razão 1:2
the-loop-closed-by-two-circles-turning-by-of-t-f-dp-d = a cadeia fechada por dois círculos, θ₅ girando ∓½ de θ₂: T = −F·dP/dθ₂
cranks-in-internal-mesh-ratio-1-2 = Manivelas em engrenamento interno, razão 1:2
spring-between-two-points-unstretched-at-an-angle-stiffness-unknown = Mola entre dois pontos, sem deformação em um ângulo, rigidez desconhecida
s-b-d-2-b-d-cos-k-m-g-l-sin-s-s-s-and-v = s² = b² + d² − 2 b d cos(θ + γ − δ): k = m g l sen θ/((s − s₀) s′) e V″
spring-between-two-points-of-a-given-length = Mola entre dois pontos, de comprimento dado
s-b-d-2-b-d-cos-m-v-of-m-g-l-cos-k-s-s = s² = b² + d² − 2 b d cos(θ + γ − δ): M = V′ de m g l cos θ + ½ k (s − s₀)²
shaper-with-its-slider-ahead = Limadora com o corredor à frente
e-l-e-i-with-the-direction-of-i-d-r-e-i-x-e-x-l-h-e-y-t-f-dx-d = E = L e^(iβ) com β a direção de i d + r e^(iθ); x = E_x ± √(l² − (h − E_y)²), T = −F dx/dθ
shaper-with-its-slider-behind = Limadora com o corredor atrás
cart-with-a-welded-box-pushed-over-a-distance = Carrinho com uma caixa soldada, empurrado por uma distância
t-2-m-m-s-f-and-f-s-5-kg-30-n-1-2-m = t = √(2 (m₁ + m₂) s/F) e F s: 5 kg, 30 N, 1,2 m
piston-driven-by-expanding-gas = Pistão movido pela expansão de um gás
m-v-a-p-l-l-1-n-l-1-n-n-1-p-l-l = ½ m v² = A (p₁ L₁ⁿ (L₁^(1−n) − L₂^(1−n))/(n − 1) − p₀ (L₂ − L₁))
arm-raised-by-a-cylinder-beside-a-free-slider = Braço erguido por um cilindro ao lado de um cursor livre
slider-hung-from-a-spring = Cursor suspenso por uma mola
the-spring-is-unstretched-at-s-l-h-0-4-m-v-k-s-l = a mola está sem deformação em s = √(L₀² − h²) = 0,4 m, V″ = k s²/L₀²
stop-at-rest-for-a-body-in-translation = Parada no repouso para um corpo em translação
a-bar-on-two-equal-rods-keeps-its-direction-its-angular-velocity-is-zero-at-every-instant = uma barra em duas hastes iguais mantém a sua direção: a sua velocidade angular é nula em todo instante
it-stops-rotating-for-a-body-that-only-translates-use-two-points = Ele deixa de girar; para um corpo que só translada, use dois pontos.
body-does-not-turn-so-this-end-condition-does-not-apply-to-it-use-two-points-that-come-to-relative = { $body } não gira, portanto esta condição de fim não se aplica a ele: use dois pontos que param um em relação ao outro
fossee-scilab-companion-to-s-s-bhavikatti-engineering-mechanics-example-8-15 = Complemento FOSSEE em Scilab a S. S. Bhavikatti, Engineering Mechanics, exemplo 8.15
fossee-companion-to-r-c-hibbeler-a-gupta-engineering-mechanics-example-11-6 = Complemento FOSSEE a R. C. Hibbeler, A. Gupta, Engineering Mechanics, exemplo 11.6
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-14 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.14
fossee-companion-to-hibbeler-gupta-engineering-mechanics-ex-11-3 = Complemento FOSSEE a Hibbeler & Gupta, Engineering Mechanics, ex. 11.3
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-4 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.4
fossee-companion-to-b-k-sarkar-theory-of-machines-tata-mcgraw-hill-ex-5-2 = Complemento FOSSEE a B. K. Sarkar, Theory of Machines, Tata McGraw-Hill, ex. 5.2
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-5 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.5
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-6 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.6
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-8 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.8
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-9 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.9
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-10 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.10
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-11 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.11
fossee-companion-to-b-k-sarkar-theory-of-machines-tata-mcgraw-hill-ex-5-4 = Complemento FOSSEE a B. K. Sarkar, Theory of Machines, Tata McGraw-Hill, ex. 5.4
fossee-companion-to-b-k-sarkar-theory-of-machines-tata-mcgraw-hill-ex-5-6 = Complemento FOSSEE a B. K. Sarkar, Theory of Machines, Tata McGraw-Hill, ex. 5.6
fossee-companion-to-b-k-sarkar-theory-of-machines-tata-mcgraw-hill-ex-5-7 = Complemento FOSSEE a B. K. Sarkar, Theory of Machines, Tata McGraw-Hill, ex. 5.7
fossee-companion-to-b-k-sarkar-theory-of-machines-tata-mcgraw-hill-ex-5-3 = Complemento FOSSEE a B. K. Sarkar, Theory of Machines, Tata McGraw-Hill, ex. 5.3
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-19 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.19
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-20 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.20
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-22 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.22
fossee-companion-to-bevan-the-theory-of-machines-ch-12-ex-5 = Complemento FOSSEE a Bevan, The Theory of Machines, cap. 12, ex. 5
fossee-companion-to-t-bevan-the-theory-of-machines-ch-12-ex-2 = Complemento FOSSEE a T. Bevan, The Theory of Machines, cap. 12, ex. 2
fossee-companion-to-r-c-hibbeler-engineering-mechanics-statics-example-11-6 = Complemento FOSSEE a R. C. Hibbeler, Engineering Mechanics: Statics, exemplo 11.6
fossee-scilab-companion-to-w-g-mclean-e-w-nelson-engineering-mechanics-schaum-problem-11-5 = Complemento FOSSEE em Scilab a W. G. McLean, E. W. Nelson, Engineering Mechanics (Schaum), problema 11.5
fossee-companion-to-r-c-hibbeler-a-gupta-engineering-mechanics-example-11-1 = Complemento FOSSEE a R. C. Hibbeler, A. Gupta, Engineering Mechanics, exemplo 11.1
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-18 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.18
fossee-python-companion-to-r-s-khurmi-j-k-gupta-theory-of-machines-ex-6-1 = Complemento FOSSEE em Python a R. S. Khurmi, J. K. Gupta, Theory of Machines, ex. 6.1
fossee-companion-to-a-k-tayal-engineering-mechanics-example-13-7 = Complemento FOSSEE a A. K. Tayal, Engineering Mechanics, exemplo 13.7
fossee-companion-to-bevan-the-theory-of-machines-ch-12-example-2 = Complemento FOSSEE a Bevan, The Theory of Machines, cap. 12, exemplo 2
fossee-python-companion-to-r-s-khurmi-j-k-gupta-theory-of-machines-ex-8-13 = Complemento FOSSEE em Python a R. S. Khurmi, J. K. Gupta, Theory of Machines, ex. 8.13
fossee-companion-to-r-c-hibbeler-a-gupta-engineering-mechanics-statics-ex-11-3 = Complemento FOSSEE a R. C. Hibbeler, A. Gupta, Engineering Mechanics: Statics, ex. 11.3
fossee-scilab-companion-to-nelson-best-mclean-schaum-s-outline-of-engineering-mechanics-problem-11-5 = Complemento FOSSEE em Scilab a Nelson, Best & McLean, Schaum's Outline of Engineering Mechanics, problema 11.5
fossee-scilab-companion-to-nelson-best-mclean-schaum-s-outline-of-engineering-mechanics-problem-11-10 = Complemento FOSSEE em Scilab a Nelson, Best & McLean, Schaum's Outline of Engineering Mechanics, problema 11.10
bar-that-falls-and-pushes-a-slider-by-a-rod = Barra que cai e empurra um corredor por uma haste
i-m-c-m-x-m-g-c-sin-sin-with-x-b-cos-l-b-sin = ½ (I + m c² + M x′²) ω² = m g c (sen θ₀ − sen θ) com x = b cos θ + √(l² − b² sen² θ)
rocker-at-rest-at-its-dead-centre = Balancim em repouso no seu ponto morto
crank-and-rod-folded-and-collinear-cos-b-a-d-c-2-b-a-d-i-i-i = manivela e haste dobradas e colineares: cos(θ − π) = ((b − a)² + d² − c²)/(2 (b − a) d), ½ I₂ ω² = ½ (I₂ + I₄ ψ′²) ω₀²
angle-of-the-second-crank-rotated-by-the-gears-from-the-initial-configuration = Ângulo da segunda manivela, girada pelas engrenagens a partir da configuração inicial
with-gears-the-angle-of-the-second-crank-is-that-of-the-drawn-position-from-there-they-turn-it-as-the = Com engrenagens, o ângulo da segunda manivela é o da posição desenhada; a partir dela giram-na conforme a primeira manivela gira. Se omitido, o mecanismo é desenhado com o ângulo acima.
geared-cranks-rotated-from-the-drawn-position = Manivelas engrenadas, giradas a partir da posição desenhada
y-a-sin-b-d-2-a-cos-at-100-and-80-t-f-dy-d = y = a sen θ + √(b² − (d/2 − a cos θ)²) em 100° e 80°: T = −F dy/dθ

# second ways
t-v-w-at-the-end-equals-the-initial-kinetic-energy = T + V − W no fim é igual à energia cinética inicial
acceleration-of-the-piston-from-the-second-derivative-of-the-triangle-of-the-pins = aceleração do pistão pela segunda derivada do triângulo dos pinos
acceleration-of-name-from-the-adjacent-body-through-their-pin = aceleração de { $name } a partir do corpo vizinho, pelo pino comum
angular-velocity-of-the-cylinder-from-the-area-that-its-line-sweeps = velocidade angular do cilindro pela área que a sua linha varre
both-ends-of-link-n-have-the-same-velocity-along-it = as duas extremidades do elo { $n } têm a mesma velocidade ao longo dele
coupler-and-rocker-collinear-span-the-distance-from-the-crank-pin-at-its-maximum-angle = acoplador e balancim, colineares, cobrem a distância a partir do pino da manivela no seu ângulo máximo
crank-and-lever-are-at-right-angles-at-the-ends-of-the-forward-stroke = manivela e alavanca estão em ângulo reto nos extremos do curso de avanço
crank-pin-and-fixed-pin-are-at-the-same-distance-from-a-line-through-the-bearing-along-the-cylinder = pino da manivela e pino fixo estão à mesma distância de uma reta pelo mancal ao longo do cilindro
second-derivative-for-bar-bar-as-that-of-a-pendulum-its-length-times-the-pull-on-it = segunda derivada para a barra { $bar } como a de um pêndulo, o comprimento vezes a tração nela
displacement-as-the-integral-of-the-velocity = deslocamento como integral da velocidade
displacement-from-the-distances-of-the-gudgeon-pin-with-crank-and-rod-collinear-and-at-this-angle = deslocamento pelas distâncias do pino do pistão com manivela e biela alinhadas e neste ângulo
efficiency-as-the-work-done-on-the-load-per-revolution-over-that-of-the-torque = rendimento como o trabalho feito sobre a carga por volta sobre o do torque
fluctuation-of-energy-as-a-fraction-of-the-work-per-cycle = flutuação de energia como fração do trabalho por ciclo
force-across-the-line-of-the-joint-by-virtual-power-with-the-joint-released = força através da linha da junta pela potência virtual, com a junta liberada
force-at-the-crank-pin-from-the-newton-euler-equations = força no pino da manivela pelas equações de Newton–Euler
force-at-point-by-virtual-power-with-this-joint-released = força em { $point } pela potência virtual, com esta junta liberada
friction-at-the-minimum-coefficient-is-the-effort-that-keeps-the-disc-from-slipping = o atrito com o coeficiente mínimo é o esforço que impede o disco de escorregar
height-of-the-load-by-pythagoras-from-the-links-and-the-width-of-the-frame = altura da carga por Pitágoras, a partir das hastes e da largura da armação
height-of-the-table-by-pythagoras-from-the-bars-and-the-distance-between-the-feet = altura da mesa por Pitágoras, a partir das barras e da distância entre os pés
inertia-force-of-the-rod-as-the-force-exerted-by-its-pins-from-the-newton-euler-equations = força de inércia da biela como a força exercida pelos seus pinos, pelas equações de Newton–Euler
instant-centre-13-is-on-the-lines-of-crank-and-rocker = o centro instantâneo 13 está nas linhas da manivela e do balancim
minimum-transmission-angle-from-the-maximum-inclination-of-the-rod-with-the-crank-perpendicular-to = ângulo de transmissão mínimo pela inclinação máxima da biela, com a manivela perpendicular à linha do cursor
link-n-ends-where-the-slider-is-on-its-line = o elo { $n } termina onde o cursor está na sua linha
links-one-and-two-give-their-common-pin-the-same-acceleration = os elos { $one } e { $two } dão ao seu pino comum a mesma aceleração
links-one-and-two-give-their-common-pin-the-same-velocity = os elos { $one } e { $two } dão ao seu pino comum a mesma velocidade
lowest-eigenvalue-by-sylvester-s-law-of-inertia-where-the-matrix-of-second-derivatives-ceases-to-be = menor autovalor pela lei da inércia de Sylvester, onde a matriz das segundas derivadas deixa de ser positiva definida
mean-power-from-the-work-of-gas-and-friction-per-cycle-and-the-cycle-time = potência média pelo trabalho do gás e do atrito por ciclo e pela duração do ciclo
mechanical-advantage-as-the-sine-of-the-angle-between-crank-and-cylinder = vantagem mecânica como seno do ângulo entre manivela e cilindro
mechanical-advantage-by-instant-centre-24-the-crank-over-the-arm-that-the-line-of-the-rod-cuts-off-at = vantagem mecânica pelo centro instantâneo 24: a manivela sobre o braço que a linha da biela corta junto ao mancal
moments-of-the-weights-and-of-the-forces-on-the-whole-chain-about-its-pin = momentos dos pesos e das forças sobre a cadeia toda em torno do seu pino
no-torque-of-the-turn-is-larger = nenhum torque da volta é maior
period-of-the-rod-as-a-compound-pendulum-about-the-crank-pin = período da biela como pêndulo composto em torno do pino da manivela
period-of-the-rod-as-a-compound-pendulum-about-the-gudgeon-pin = período da biela como pêndulo composto em torno do pino do pistão
position-and-velocity-of-the-yoke-are-on-the-circle-of-the-harmonic-motion = posição e velocidade do garfo estão no círculo do movimento harmônico
position-of-name-from-the-adjacent-body-through-their-pin = posição de { $name } a partir do corpo vizinho, pelo pino comum
power-of-the-cylinders-and-of-what-they-lift = potência dos cilindros e do que eles levantam
power-of-the-driving-shaft-and-of-the-load-on-the-driven-member = potência do eixo motor e da carga no membro movido
root-mean-square-of-the-turning-moment-from-the-virtual-work-over-the-cycle = valor eficaz do torque pelos trabalhos virtuais ao longo do ciclo
sliding-velocity-against-name-from-the-motions-of-both-its-bodies = velocidade de deslizamento contra { $name } pelos movimentos dos seus dois corpos
speed-of-the-driving-member-from-the-meshes-with-that-of-the-driven-one = velocidade do membro motor pelos engrenamentos, com a do movido
speed-of-the-planet-from-the-meshes-with-that-of-the-driven-member = velocidade do satélite pelos engrenamentos, com a do membro movido
swing-of-the-lever-between-the-two-positions-in-which-it-is-tangent-to-the-crank-pin-circle = oscilação da alavanca entre as duas posições em que ela tangencia o círculo do pino da manivela
the-coefficient-of-friction-from-the-direction-of-the-force-on-a-foot-by-the-newton-euler-equations = o coeficiente de atrito pela direção da força num pé, pelas equações de Newton–Euler
the-crank-pin-is-level-with-the-pivot-of-the-lever-at-the-ends-of-the-forward-stroke = o pino da manivela está à altura do pivô da alavanca nos extremos do curso de avanço
the-second-derivative-of-the-potential-energy-as-the-rate-of-the-virtual-power-of-all-loads = a segunda derivada da energia potencial como taxa da potência virtual de todas as cargas
the-second-derivative-of-the-potential-energy-at-0-with-the-critical-load = a segunda derivada da energia potencial em θ = 0 com a carga crítica
the-force-of-the-guide-from-the-newton-euler-equations = a força da guia pelas equações de Newton–Euler
the-force-of-the-link-at-the-ram-on-the-knee-from-the-newton-euler-equations = a força da barra do êmbolo sobre o joelho pelas equações de Newton–Euler
the-kinetic-energies-of-the-flywheel-at-its-maximum-and-minimum-speed-differ-by-the-fluctuation = as energias cinéticas do volante na rotação máxima e na mínima diferem pela flutuação
the-last-part-of-the-motion-integrated-again-to-the-end-time = o último trecho do movimento, integrado de novo até o instante final
the-loop-closes-at-the-common-pin-of-links-one-and-two = a cadeia fecha no pino comum dos elos { $one } e { $two }
the-lowering-torque-from-t-d-2-d-d = o torque de descida por T d/2 (π μ′ d − ℓ)/(π d + μ′ ℓ)
the-mass-of-the-flywheel-at-its-radius-of-gyration-absorbs-the-fluctuation-of-energy = a massa do volante no seu raio de giração absorve a flutuação de energia
the-mechanical-advantage-from-the-newton-euler-equations = a vantagem mecânica pelas equações de Newton–Euler
the-mechanical-advantage-from-the-displacements-of-hand-and-ram-in-one-turn-and-the-losses = a vantagem mecânica pelos deslocamentos da mão e do êmbolo numa volta, e pelas perdas
the-moment-of-the-cord-about-the-pin-of-the-bar-is-that-of-its-weight = o momento da corda em torno do pino da barra é o do peso desta
the-points-that-each-pin-joins-coincide-with-the-angles-of-the-bodies = os pontos que cada pino une coincidem, com os ângulos dos corpos
the-points-that-each-pin-joins-have-the-same-acceleration-with-the-angular-accelerations-of-the = os pontos que cada pino une têm a mesma aceleração, com as acelerações angulares dos corpos
the-points-that-each-pin-joins-have-the-same-velocity-with-the-angular-velocities-of-the-bodies = os pontos que cada pino une têm a mesma velocidade, com as velocidades angulares dos corpos
the-pull-of-the-left-stem-from-the-newton-euler-equations = a tração da haste esquerda pelas equações de Newton–Euler
the-pull-of-the-right-stem-from-the-newton-euler-equations = a tração da haste direita pelas equações de Newton–Euler
the-reaction-of-a-upwards-from-the-newton-euler-equations-of-both-bars-that-end-there = a reação de A para cima pelas equações de Newton–Euler das duas barras que lá terminam
the-rod-at-the-transmission-angle-reaches-from-the-crank-pin-to-the-slider-s-line = a biela no ângulo de transmissão alcança do pino da manivela à linha do cursor
the-rod-spans-from-the-crank-pin-to-the-gudgeon-pin = a biela vai do pino da manivela ao pino do pistão
the-torque-on-the-pinion-from-the-newton-euler-equations-through-the-gears = o torque no pinhão pelas equações de Newton–Euler, através das engrenagens
the-turning-moment-has-zero-slope-at-its-maximum = o torque tem derivada nula no seu máximo
the-turning-moment-has-zero-slope-at-its-minimum = o torque tem derivada nula no seu mínimo
the-virtual-work-at-the-angle-of-the-maximum-torque = os trabalhos virtuais no ângulo do torque máximo
holding-torque-of-the-fixed-member-from-the-newton-euler-equations-of-every-gear = torque de retenção do membro fixo pelas equações de Newton–Euler de cada engrenagem
transmission-angle-by-the-law-of-cosines-from-the-diagonal-of-the-linkage = ângulo de transmissão pela lei dos cossenos, a partir da diagonal do quadrilátero
velocities-along-and-across-the-lever-make-up-that-of-the-crank-pin = as velocidades ao longo e através da alavanca compõem a do pino da manivela
velocity-of-the-piston-from-the-derivative-of-the-triangle-of-the-pins = velocidade do pistão pela derivada do triângulo dos pinos
velocity-of-name-from-the-adjacent-body-through-their-pin = velocidade de { $name } a partir do corpo vizinho, pelo pino comum
virtual-work-of-all-loads-of-the-resistance-and-of-the-inertia-of-the-flywheel = trabalhos virtuais de todas as cargas, da resistência e da inércia do volante
displacement-ratio-table-over-cylinder-as-the-force-of-the-cylinder-for-a-unit-load-without-weights = razão de deslocamentos, mesa sobre cilindro, como a força do cilindro para uma carga unitária, sem pesos das barras
work-of-a-cycle-from-its-mean-power-and-its-time = trabalho de um ciclo pela sua potência média e o seu tempo
work-of-the-gas-as-the-area-of-its-diagram-strip-by-strip = trabalho do gás como a área do seu diagrama, faixa por faixa
the-same-rod-by-two-terms-of-the-series = A mesma biela por dois termos da série
cos-a-b-s-2-a-b-with-s-s-v-t-differentiated-the-cylinder-s-work-is-i = cos θ = (a² + b² − s²)/(2 a b) com s = s₀ + v t, derivado; o trabalho do cilindro é ½I(ω₁² − ω₀²)
compression-from-0-1-n-mm-by-14-and-expansion-follow-p-v-1-35-oil-is-injected-at-constant-pressure = A compressão a partir de 0,1 N/mm² por 14 e a expansão seguem p v^1,35; o óleo é injetado a pressão constante durante um décimo do curso. O complemento não calcula a pressão a 45°, mas toma 2,2 N/mm².
compression-from-0-1-n-mm-by-14-and-expansion-follow-p-v-1-35-the-injection-ends-at-a-tenth-of-the = A compressão a partir de 0,1 N/mm² por 14 e a expansão seguem p v^1,35; a injeção termina em um décimo do curso.
crank-angle-of-the-maximum-piston-speed = Ângulo da manivela na velocidade máxima do pistão
engine-with-a-bore-of-half-a-metre-at-60 = Motor com diâmetro de meio metro a 60°
force-at-the-joint-against-a-spring-that-is-unstretched-with-the-bars-in-line = Força na articulação contra uma mola sem deformação com as barras alinhadas
force-of-the-frame-on-the-crank-horizontal = força da base sobre a manivela, horizontal
force-of-the-frame-on-the-crank-vertical = força da base sobre a manivela, vertical
fossee-companion-to-b-k-sarkar-theory-of-machines-tata-mcgraw-hill-ex-5-8 = Complemento FOSSEE a B. K. Sarkar, Theory of Machines, Tata McGraw-Hill, ex. 5.8
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-13 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.13
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-21 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.21
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-3 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.3
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-15-7 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 15.7
four-bar-linkage-with-a-force-on-its-coupler-and-a-load-torque = Quadrilátero articulado com uma força no acoplador e um torque de carga
inertia-torque-of-a-rod-swung-about-its-gudgeon-pin = Torque de inércia de uma biela oscilada em torno do pino do pistão
links-of-1-5-7-7-and-5-8-lb-of-whose-masses-g-386-in-s-is-a-definition-their-weights-are-neglected-80 = Elos de 1,5, 7,7 e 5,8 lb; g = 386 in/s², que dá as suas massas, é uma definição; os pesos são desprezados. 80 lbf a 330° atuam a 3 in e 100° do centro de massa do acoplador, que está a 9 in e 45° do pino da manivela.
n-21-oscillations-about-the-gudgeon-pin-in-20-s-give-the-radius-of-gyration-by-the-compound-pendulum = 21 oscilações em torno do pino do pistão em 20 s dão o raio de giração pelo pêndulo composto. O livro imprime o módulo do torque, que se opõe à rotação.
p-4-k-l-tan-1-cos-j-l-meriam-and-l-g-kraige-engineering-mechanics-statics-problem-7-10 = P = 4 k l tan θ (1 − cos θ); J. L. Meriam e L. G. Kraige, Engineering Mechanics: Statics, problema 7/10
printed-with-rounded-numbers-calculated-107-46-lbf = impresso com números arredondados; calculado: −107,46 lbf
printed-with-rounded-numbers-calculated-117-56-lbf = impresso com números arredondados; calculado: −117,56 lbf
printed-with-rounded-numbers-calculated-8850-8-n-m = impresso com números arredondados; calculado: 8850,8 N·m
r-l-norton-design-of-machinery-ex-11-3 = R. L. Norton, Design of Machinery, ex. 11-3
r-p-b-r-j-l-meriam-and-l-g-kraige-engineering-mechanics-statics-problem-7-2 = R = P b/r; J. L. Meriam e L. G. Kraige, Engineering Mechanics: Statics, problema 7/2
radius-of-gyration-of-the-rod = raio de giração da biela
ram-force-of-a-press-with-a-lever-of-half-a-metre = Força do êmbolo de uma prensa com alavanca de meio metro
the-book-gives-the-formula-the-numbers-were-chosen-here = O livro dá a fórmula; os números foram escolhidos aqui.
the-book-gives-the-formula-the-slider-moves-upright-there-and-the-force-is-horizontal-the-numbers = O livro dá a fórmula; lá o cursor se move na vertical e a força é horizontal; os números foram escolhidos aqui.
the-crank-angle-is-unknown-and-the-velocity-is-to-be-a-maximum-the-book-works-with-two-terms-the = O ângulo da manivela é a incógnita e a velocidade deve ser máxima. O livro usa dois termos; o máximo exato é 6,562 m/s a 74,5°.
the-engine-is-horizontal-the-book-neglects-the-weight-of-the-reciprocating-parts-which-the-guide = O motor é horizontal; o livro despreza o peso das partes alternativas, que a guia suporta.
the-lever-arms-of-the-forces-are-measured-in-a-drawing-calculated-12-43-n-m = os braços de alavanca das forças são medidos em um desenho; calculado: −12,43 N·m
the-pressure-is-rounded-to-2-2-n-mm-calculated-109-341-kn = a pressão é arredondada para 2,2 N/mm²; calculado: 109,341 kN
the-pressure-is-rounded-to-2-2-n-mm-calculated-27-335-kn-m = a pressão é arredondada para 2,2 N/mm²; calculado: 27,335 kN·m
the-pressure-is-rounded-to-2-2-n-mm-calculated-79-323-kn = a pressão é arredondada para 2,2 N/mm²; calculado: 79,323 kN
vertical-diesel-engine-during-its-expansion-at-45 = Motor Diesel vertical na expansão a 45°
vertical-diesel-engine-during-its-expansion-at-60 = Motor Diesel vertical na expansão a 60°
ab-for-two-pins-ab-bc-and-ca-for-three-without-them-the-distances-are-those-of-the-given-positions = AB para dois pinos; AB, BC e CA para três. Sem elas, valem as distâncias das posições dadas.
coordinate-at-rest-on-the-stop = Coordenada em repouso no batente
distances-of-the-pins = Distâncias dos pinos
force-of-the-stop = Força do batente
force-or-couple-of-name-by-virtual-work-q-c-v-q-dv-dm-dc-dm = Força ou binário de { $name }, pelo trabalho virtual: Q δc = δV, Q = (dV/dm)/(dc/dm)
pins = Pinos
points-through-which-the-body-goes-at-each-it-is-pinned-to-the-ground-or-to-the-other-bodies-that = Pontos por onde passa o corpo: em cada um ele é articulado ao solo ou aos outros corpos que têm o ponto entre seus pinos. A origem de seus eixos é o primeiro pino, e x aponta para o segundo.
selects-the-side-on-which-a-linkage-is-assembled-the-joints-correct-the-value-the-positions-of-two = Escolhe o lado em que o mecanismo é montado; as juntas corrigem o valor. As posições de dois pinos o substituem.
in-the-axes-of-what-carries-it-that-of-a-pin-between-bodies-is-a-sketch-in-the-axes-of-the-ground-it = Nos eixos de quem o leva. A de um pino entre corpos é um esboço, nos eixos do solo: escolhe o lado em que o mecanismo é montado e os comprimentos dos corpos cujas distâncias não são dadas.
the-bodies-that-have-it-among-their-pins = Os corpos que o têm entre seus pinos.
pin-between-bodies = Pino entre corpos
value-of-coordinate-where-name-is-reached-and-the-loads-press-the-mechanism-against-it = Valor de { $coordinate } em que { $name } é alcançado e as cargas pressionam o mecanismo contra ele
carried-by = Levado por
without-one-a-body-is-called-by-its-pins-as-in-a-b = Sem nome, um corpo é chamado por seus pinos, como A–B.
without-one-a-driver-is-called-by-its-body-or-its-points = Sem nome, um acionamento é chamado por seu corpo ou seus pontos.
without-one-a-joint-is-called-by-its-points = Sem nome, uma junta é chamada por seus pontos.
without-one-a-load-is-called-by-its-point-its-body-or-its-points = Sem nome, uma carga é chamada por seu ponto, seu corpo ou seus pontos.
a-geneva-wheel-has-at-least-three-slots = uma roda de Genebra tem ao menos três ranhuras
force-of-name-from-finite-differences-of-the-potential-energy-and-of-what-it-limits = força de { $name } por diferenças finitas da energia potencial e do que ele limita
held-by-name = apoiado em { $name }
stops-are-found-over-a-range-of-a-single-coordinate-search-between-two-values-of-it = os batentes são procurados em um intervalo de uma única coordenada: procure entre dois valores dela
the-contour-of-the-cam-name-is-hollow-a-flat-face-does-not-touch-it-everywhere-use-a-roller = o contorno do came { $name } é côncavo: uma face plana não o toca em toda parte; use um rolete
the-contour-of-the-cam-name-needs-at-least-three-points-with-increasing-angles-within-one-revolution = o contorno do came { $name } precisa de ao menos três pontos com ângulos crescentes dentro de uma volta
the-distances-between-the-pins-of-name-are-missing-give-them-or-the-positions-of-all-its-pins = faltam as distâncias entre os pinos de { $name }: dê-as, ou as posições de todos os seus pinos
the-first-two-pins-of-name-are-in-one-place-give-their-distance = os dois primeiros pinos de { $name } estão no mesmo lugar: dê a distância entre eles
the-number-of-distances-of-name-does-not-fit-its-pins-one-for-two-pins-three-for-three-pins-none-to = o número de distâncias de { $name } não condiz com seus pinos: uma para dois pinos, três para três pinos, nenhuma para tomá-las das posições
the-point-name-is-carried-by-nothing-put-it-on-the-ground-or-on-a-body-or-list-it-among-the-pins-of-a = nada leva o ponto { $name }: ponha-o no solo ou em um corpo, ou entre os pinos de um corpo
the-roller-of-name-does-not-fit-into-the-hollow-of-the-contour-reduce-its-radius = o rolete de { $name } não cabe na concavidade do contorno: reduza seu raio
the-three-sides-of-name-close-no-triangle-the-longest-exceeds-the-sum-of-the-two-others = os três lados de { $name } não fecham um triângulo: o maior excede a soma dos outros dois
name-lists-a-pin-twice-each-of-its-pins-is-another-point = { $name } tem um pino repetido: cada um de seus pinos é outro ponto
angle-in-the-axes-of-the-cam = Ângulo nos eixos do came
angle-of-the-pin-in-the-axes-of-the-driver = Ângulo do pino, nos eixos da motora
body-that-carries-both = Corpo que leva as duas
body-that-carries-the-pin = Corpo que leva o pino
buffer-smallest-distance-between-two-points = Amortecedor de batente: menor distância entre dois pontos
cam-of-a-given-contour-with-a-roller-or-a-flat-face-on-it = Came de contorno dado, com um rolete ou uma face plana sobre ele
centre-of-the-cam-on-the-body-of-the-cam = Centro do came, no corpo do came
centre-of-the-roller = Centro do rolete
contact-of-a-point-with-a-straight-edge-to-the-left-of-it = Contato de um ponto com uma borda reta, à esquerda dela
contour-radius-against-the-angle-in-the-axes-of-the-cam-over-one-revolution = Contorno: raio em função do ângulo nos eixos do came, em uma volta
cord-or-strap-largest-distance-between-two-points = Corda ou correia: maior distância entre dois pontos
cords-buffers-and-contacts-that-limit-the-motion-found-over-a-range-of-a-single-coordinate = Cordas, batentes e contatos que limitam o movimento; procurados em um intervalo de uma única coordenada.
couple-of-the-stop-m-w-l-2-cos = Binário do batente M = W (L/2) cos θ
crank-of-15-mm-about-o-fixed-pivot-b-bars-j-k-c-f-and-the-triangles-bce-and-dfg-of-the-walking = Manivela de 15 mm em torno de O, pivô fixo B; barras j, k, c, f e os triângulos BCE e DFG do mecanismo andante, com os comprimentos que T. Jansen publicou. As posições de A a G são um esboço. No pé G atuam 20 N para cima e 3 N contra o movimento.
direction-from-the-centre-of-the-driver-to-that-of-the-wheel-in-the-axes-of-the-carrier = Direção do centro da motora ao da roda, nos eixos de quem as leva
direction-of-the-edge-in-the-axes-of-its-body = Direção da borda, nos eixos de seu corpo
direction-of-the-normal-of-the-face-away-from-the-cam-in-the-axes-of-the-follower = Direção da normal da face, para longe do came, nos eixos do seguidor
disc-of-30-mm-radius-eccentric-by-12-mm-as-a-contour-in-polar-coordinates-about-its-shaft-every-5 = Disco de 30 mm de raio, excêntrico de 12 mm, como contorno em coordenadas polares em torno de seu eixo a cada 5°; rolete de 10 mm em um seguidor guiado em linha com o eixo, apertado por 100 N.
each-engagement-turns-the-wheel-by-2-n-it-lasts-2-n-of-the-driver-s-revolution = Cada engrenamento gira a roda de 2π/n; dura π − 2π/n da volta da motora
eccentric-disc-cam-with-a-flat-faced-follower = Came de disco excêntrico com seguidor de face plana
eccentric-disc-cam-with-a-roller-follower = Came de disco excêntrico com seguidor de rolete
equilateral-triangle-of-hinge-tip-and-foot-of-the-buffer-f-l-cos-30-w-l-2-cos-30 = Triângulo equilátero da articulação, da ponta e do pé do batente: F L cos 30° = W (L/2) cos 30°
flat-face = Face plana
folding-stool-held-by-a-strap = Banco dobrável preso por uma correia
follower = Seguidor
geneva-drive-with-four-slots-engaged = Mecanismo de Genebra com quatro ranhuras, engrenado
geneva-drive-with-six-slots-in-its-dwell-after-two-engagements = Mecanismo de Genebra com seis ranhuras, em repouso após dois engrenamentos
geneva-drive-an-indexed-wheel-with-dwell = Mecanismo de Genebra: roda indexada com repouso
geneva-wheel = Roda de Genebra
hinged-bar-on-an-angle-stop = Barra articulada em um batente angular
hinged-bar-that-rests-on-a-buffer = Barra articulada que repousa em um batente
hinged-bar-that-rests-on-an-edge = Barra articulada que repousa em uma borda
kind-of-stop = Tipo de batente
largest-angle-of-a-body = Maior ângulo de um corpo
moments-about-the-hinge-n-l-cos-w-l-2-cos = Momentos em torno da articulação: N L cos θ = W (L/2) cos θ
number-of-slots = Número de ranhuras
point-of-the-edge = Ponto da borda
point-of-the-face = Ponto da face
position-of-the-foot-by-intersections-of-circles-velocity-by-finite-differences-torque-by-virtual = Posição do pé por interseções de círculos, velocidade por diferenças finitas, torque pelo trabalho virtual
roller = Rolete
smallest-angle-of-a-body = Menor ângulo de um corpo
stops = Batentes
strap-between-the-feet-of-crossed-legs-s-w-cot-with-the-legs-at = Correia entre os pés de pernas cruzadas: S = W cot φ com as pernas a φ
the-driver-has-turned-by-500-from-the-middle-of-an-engagement-that-one-ended-at-60-the-next-took = A motora girou 500° desde o meio de um engrenamento: este terminou em 60°, o seguinte foi de 300° a 420°. A roda girou meio passo e um passo inteiro, 90°, e repousa; ela suporta sua carga sem a motora.
the-pin-is-10-past-the-line-of-centres-the-drawn-position-is-the-middle-of-the-engagement-the-wheel = O pino está 10° além da linha dos centros; a posição desenhada é o meio do engrenamento. A roda leva 1 N·m.
the-radius-of-the-pin-s-circle-is-the-distance-of-the-centres-times-sin-n = O raio do círculo do pino é a distância dos centros vezes sen(π/n).
the-same-disc-under-a-flat-face-at-right-angles-to-its-guide-the-contact-moves-along-the-face-so-that = O mesmo disco sob uma face plana perpendicular à sua guia; o contato se move ao longo da face, de modo que o torque é F e cos θ.
theo-jansen-s-leg = Perna de Theo Jansen
two-legs-of-0-8-m-pinned-at-their-middles-one-foot-on-a-pin-and-one-on-a-smooth-floor-400-n-at-each = Duas pernas de 0,8 m articuladas em seus meios, um pé em um pino e outro em um piso liso; 400 N em cada extremidade superior. A correia de 480 mm fica esticada com as pernas a 53,13°; o batente contra o fechamento não é alcançado.
uniform-bar-of-10-kg-and-1-m-on-a-pin-0-5-m-above-a-floor-its-tip-touches-at-30-below-the-horizontal = Barra uniforme de 10 kg e 1 m em um pino 0,5 m acima de um piso: sua ponta o toca a 30° abaixo da horizontal.
uniform-bar-of-10-kg-and-1-m-that-a-stop-in-its-hinge-holds-at-20-below-the-horizontal = Barra uniforme de 10 kg e 1 m que um batente na articulação segura a 20° abaixo da horizontal.
uniform-bar-of-10-kg-and-1-m-the-buffer-stands-1-m-below-the-hinge-and-is-1-m-long-when-it-is-solid = Barra uniforme de 10 kg e 1 m; o batente está 1 m abaixo da articulação e tem 1 m de comprimento quando fechado.
tan-sin-1-cos-with-sin-n-and-its-derivatives = tan β = λ sen α/(1 − λ cos α) com λ = sen(π/n), e suas derivadas
y-a-e-sin-simple-harmonic-motion = y = a + e sen θ: movimento harmônico simples
y-e-sin-a-r-e-cos-a-slider-crank-of-crank-e-and-rod-a-r-contact-force-f-cos-with-sin-e-cos-a-r = y = e sen θ + √((a + r)² − e² cos² θ), um biela-manivela de manivela e e biela a + r; força de contato F/cos µ com sen µ = e cos θ/(a + r)
a-rod-that-swings-too-fast = Uma biela que oscila rápido demais
a-triangle-of-900-n-m-against-200-n-m-that-rise-to-300-n-m-once-in-two-turns-both-have-the-mean-of = Um triângulo de 900 N·m contra 200 N·m que sobem a 300 N·m uma vez em duas voltas: ambos têm a média de 225 N·m.
absolute-pressure-after-the-combustion = Pressão absoluta após a combustão
absolute-pressure-after-the-compression = Pressão absoluta após a compressão
absolute-pressure-at-the-end-of-the-compression = Pressão absoluta no fim da compressão
areas-and-a-fluctuation-of-energy-are-those-between-the-turning-moment-and-its-load-already-choose-a = áreas e uma flutuação de energia já são as entre o torque e a sua carga: escolha uma carga constante
areas-and-a-load-that-varies = Áreas e uma carga variável
areas-lie-between-the-turning-moment-and-its-load = as áreas ficam entre o torque e a sua carga
at-constant-pressure-diesel = A pressão constante (Diesel)
at-constant-volume-otto = A volume constante (Otto)
bore-80-mm-crank-45-mm-rod-150-mm-at-30-the-piston-has-gone-0-0867-of-its-stroke = Diâmetro de 80 mm, manivela de 45 mm, biela de 150 mm; a 30° o pistão percorreu 0,0867 do curso.
clearance-volume-over-the-swept-volume-from-the-compression-ratio = Volume morto sobre a cilindrada, pela taxa de compressão
combustion = Combustão
combustion-at-constant-pressure-before-the-cut-off = Combustão a pressão constante, antes do corte
combustion-at-constant-volume-and-at-constant-pressure = Combustão a volume constante e a pressão constante
compression-from-the-end-of-the-stroke-p-v-constant = Compressão a partir do fim do curso, p vᵏ constante
compression-ratio = Taxa de compressão
compression-with-p-v-constant-by-15-6-5-mpa-held-for-0-08-of-the-stroke-at-30-the-gas-expands-already = Compressão de 15 com p v constante, 6,5 MPa mantidos em 0,08 do curso; a 30° o gás já se expande.
crank-angle-at-the-maximum-acceleration = Ângulo da manivela na aceleração máxima
crank-angle-at-the-minimum-acceleration = Ângulo da manivela na aceleração mínima
crank-angle-there = Ângulo da manivela nesse ponto
crank-angles-at-which-the-turning-moment-equals-the-load = Ângulos da manivela em que o torque é igual à carga
crank-pin-big-end = Pino da manivela, cabeça da biela
crossings = cruzamentos
cut-off-ratio = Razão de corte
cut-off-ratio-above-the-compression-ratio = Razão de corte acima da taxa de compressão
energy-fluctuation-of-a-turning-moment-against-a-constant-or-varying-load-and-flywheel-inertia-for-a = Flutuação de energia de um torque contra uma carga constante ou variável, e inércia do volante para uma flutuação de velocidade, ou a flutuação de velocidade para uma inércia.
engine-with-a-second-harmonic-that-drives-a-machine-with-a-first-one = Motor com segundo harmônico que aciona uma máquina com primeiro
expansion-from-the-cut-off-p-v-constant = Expansão a partir do corte, p vᵏ constante
expansion-from-the-dead-centre-p-v-constant = Expansão a partir do ponto morto, p vᵏ constante
exponent-of-the-compression = Expoente da compressão
exponent-of-the-expansion = Expoente da expansão
first-at-constant-volume-then-at-constant-pressure = Primeiro a volume constante, depois a pressão constante
for-each-of-three-cranks-at-120-the-moment-rises-to-90-n-m-in-60-and-falls-to-nothing-in-the-next-120 = Para cada uma de três manivelas a 120° o torque sobe a 90 N·m em 60° e cai a nada nos 120° seguintes; a soma varia entre 45 e 90 N·m. Volante de 12 kg a 80 mm.
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-16-12 = Companheiro Python FOSSEE de Khurmi & Gupta, Theory of Machines, ex. 16.12
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-16-8 = Companheiro Python FOSSEE de Khurmi & Gupta, Theory of Machines, ex. 16.8
fraction-of-the-stroke-at-the-cut-off = Fração do curso no corte
fraction-of-the-stroke-at-the-cut-off-from-the-cut-off-ratio = Fração do curso no corte, pela razão de corte
gudgeon-pin-small-end = Pino do pistão, pé da biela
harmonics-about-the-mean = Harmônicos em torno da média
ideal-cycle-otto-diesel = Ciclo ideal: Otto, Diesel
load-by-a-table-over-two-turns-of-an-engine-with-one = Carga por tabela, em duas voltas de um motor com uma
load-torque = Torque de carga
m-c-g-4-c-and-a-search-for-the-maximum-of-the-exact-velocity-independently-of-the-program = m c (g τ²/4π² − c), e uma busca do máximo da velocidade exata, independentemente do programa
maximum-absolute-pressure = Pressão absoluta máxima
maximum-angular-acceleration-of-the-flywheel = Aceleração angular máxima do volante
maximum-of-turning-moment-less-load = Máximo do torque menos a carga
maximum-pressure = Pressão máxima
maximum-pressure-back-from-the-end-of-the-expansion = pressão máxima, de volta a partir do fim da expansão
maximum-pressure-below-that-of-the-compression = Pressão máxima abaixo da de compressão
maximum-velocity-as-the-slope-of-the-displacement-at-that-crank-angle = velocidade máxima como derivada do deslocamento nesse ângulo da manivela
maximum-velocity-of-the-piston = Velocidade máxima do pistão
maximum-velocity-of-the-piston-at-that-crank-angle = Velocidade máxima do pistão, nesse ângulo da manivela
maximum-work-above-the-load-from-the-start-of-the-cycle-to-a-crossing-the-speed-is-maximum-there = Trabalho máximo acima da carga, do início do ciclo até um cruzamento: ali a rotação é máxima
mean-effective-pressure-as-the-area-of-the-diagram-strip-by-strip = pressão média efetiva como a área do diagrama, faixa a faixa
mean-effective-pressure-work-of-a-cycle-over-the-swept-volume = Pressão média efetiva: trabalho de um ciclo sobre a cilindrada
minimum-angular-acceleration-of-the-flywheel = Aceleração angular mínima do volante
minimum-of-turning-moment-less-load = Mínimo do torque menos a carga
moment-of-inertia-of-the-rod-about-g = Momento de inércia da biela em relação a G
moment-of-inertia-of-the-rod-of-which-l-is-the-length-of-the-equivalent-pendulum = Momento de inércia da biela, da qual L é o comprimento do pêndulo equivalente
n-1-2-kg-c-60-mm-0-95-s-0-072-0-224262-0-06-kg-m-crank-300-mm-rod-1-m-200-rpm = 1,2 kg, c = 60 mm, 0,95 s: 0,072 (0,224262 − 0,06) kg·m². Manivela de 300 mm, biela de 1 m, 200 rpm.
n-21-oscillations-in-20-s-the-book-prints-the-size-of-the-torque-which-resists-the-rotation = 21 oscilações em 20 s. O livro imprime o módulo do torque, que se opõe à rotação.
n-5000-600-sin-2-n-m-against-5000-500-sin-n-m-500-kg-at-0-4-m-the-book-prints-the-size-of-the = 5000 + 600 sen 2θ N·m contra 5000 + 500 sen θ N·m, 500 kg a 0,4 m. O livro imprime o módulo do retardamento; a maior aceleração tem o mesmo módulo, a 232,4°, e não os 3,46 rad/s² a 35° do livro, que são um pico menor.
n-680-of-720-with-the-same-inlet-as-a-gauge-pressure = 680° de 720°, com a mesma admissão como pressão manométrica.
n-95-kpa-8-1-32-1478-kpa = 95 kPa · 8^1,32 = 1478 kPa
no-compound-pendulum-is-faster-than-a-simple-one-of-the-length-to-its-centre-of-mass = nenhum pêndulo composto é mais rápido que um simples do comprimento até o seu centro de massa
no-crank-angle-has-a-more-extreme-moment = nenhum ângulo da manivela tem um torque mais extremo
numerical-integration-of-the-difference-of-the-two-independently-of-the-program = integração numérica da diferença dos dois, independentemente do programa
obliquity-of-the-rod-there = Obliquidade da biela nesse ponto
of-an-internal-combustion-engine-the-crank-angle-counts-from-the-dead-centre-of-the-combustion = De um motor de combustão interna. O ângulo da manivela conta a partir do ponto morto da combustão; admissão e escape ficam à pressão de admissão.
of-the-rod-alone-hung-on-that-pin = Da biela sozinha, pendurada nesse pino.
oscillation-about-a-pin = Oscilação em torno de um pino
otto-cycle-by-its-pressure-ratio = Ciclo Otto pela razão de pressões
p-p-r-v-1-32-p-3-6-p-and-the-area-of-the-diagram-by-quadrature-independently-of-the-program = p₂ = p₁ r_v^1,32, p₃ = 3,6 p₂, e a área do diagrama por quadratura, independentemente do programa
p-v-v-1-32-at-40-before-the-dead-centre-the-area-of-the-diagram-by-quadrature-independently-of-the = p₁ (v₁/v)^1,32 a 40° antes do ponto morto; a área do diagrama por quadratura, independentemente do programa
period-of-the-rod-as-a-compound-pendulum = período da biela como pêndulo composto
pressure-after-the-combustion-over-that-before-it = Pressão depois da combustão sobre a de antes
pressure-at-the-end-of-the-compression-from-the-volumes = pressão no fim da compressão, pelos volumes
pressure-of-the-inlet = Pressão de admissão
r-v-16-2-2-the-cut-off-lies-at-1-2-15-of-the-stroke-300-is-in-the-compression = r_v = 16, ρ = 2,2: o corte fica em 1,2/15 do curso. 300° está na compressão.
ratio-of-the-pressures = Razão de pressões
rise-of-the-pressure = Aumento da pressão
rod-hung-at-its-centre-of-mass = Biela pendurada no seu centro de massa
rod-swung-about-its-crank-pin-and-the-maximum-velocity-of-the-piston = Biela oscilada em torno do pino da manivela, e a velocidade máxima do pistão
rod-swung-about-its-gudgeon-pin = Biela oscilada em torno do pino do pistão
suction-and-exhaust-the-pressure-of-the-inlet = Admissão e escape: a pressão de admissão
the-absolute-pressure-of-the-inlet-must-be-above-zero-write-a-gauge-pressure-above-minus-the = a pressão absoluta de admissão deve ser maior que zero: escreva uma pressão manométrica acima de menos a pressão atmosférica, ou escolha pressões absolutas
the-angular-acceleration-from-turning-moment-and-load-at-that-crank-angle = a aceleração angular pelo torque e pela carga nesse ângulo da manivela
the-area-of-the-diagram-by-quadrature-independently-of-the-program = a área do diagrama por quadratura, independentemente do programa
the-companion-cuts-292-97-off = o companheiro trunca 292,97
the-cut-off-lies-beyond-the-end-of-the-stroke-the-cut-off-ratio-must-not-be-above-the-compression = o corte fica além do fim do curso: a razão de corte não deve ser maior que a taxa de compressão
the-maximum-pressure-lies-below-that-of-the-compression-write-a-larger-maximum-pressure-or-a-smaller = a pressão máxima é menor que a da compressão: escreva uma pressão máxima maior, ou uma taxa de compressão menor
the-mean-of-the-load-torque-load-is-not-that-of-the-turning-moment-mean-no-speed-is-steady-and-the = a média do torque de carga, { $load }, não é a do torque, { $mean }: nenhuma rotação é permanente, e a flutuação é a das variações apenas
the-rod-does-not-swing-about-a-pin-at-its-centre-of-mass-choose-the-other-pin = a biela não oscila em torno de um pino no seu centro de massa: escolha o outro pino
the-same-engine-in-its-compression-with-a-maximum-pressure = O mesmo motor na compressão, com uma pressão máxima
the-stroke-ends-at-the-compression-ratio = o curso termina na taxa de compressão
there-is-no-restoring-moment = não há momento restaurador
three-cranks-with-triangular-moments = Três manivelas com torques triangulares
two-stroke-diesel-engine-by-its-cut-off-ratio = Motor Diesel de dois tempos pela razão de corte
vertical-diesel-engine-by-its-compression-ratio = Motor Diesel vertical pela taxa de compressão
volume-at-the-cut-off-over-the-clearance-volume = Volume no corte sobre o volume morto.
without-gravity-no-rod-swings-write-the-acceleration-of-gravity-at-which-the-period-was-measured = sem gravidade nenhuma biela oscila: escreva a aceleração da gravidade em que o período foi medido
work-of-the-compression-over-the-swept-volume = Trabalho da compressão sobre a cilindrada
work-of-the-expansion-over-the-swept-volume = Trabalho da expansão sobre a cilindrada
work-of-the-gas-in-a-cycle = Trabalho do gás num ciclo
work-of-the-gas-per-cycle = Trabalho do gás por ciclo
four-strokes-complete-the-data-compression-from-0-1-n-mm-by-14-and-expansion-follow-p-v-1-35-the = Quatro tempos completam os dados: compressão de 0,1 N/mm² por 14 e expansão seguem p v^1,35; a injeção termina a um décimo do curso.
with-that-value-the-closed-mechanism-lies-at-the-limit-of-name = com esse valor, o mecanismo fechado está no limite de { $name }

# Kinematics of linkages
ab-40-mm-at-120-rpm-clockwise-bc-ad-150-mm-cd-80-mm-angle-bad-60-the-angular-velocity-is-printed-as-a = AB = 40 mm a 120 rpm no sentido horário, BC = AD = 150 mm, CD = 80 mm, ângulo BAD = 60°. A velocidade angular é impressa em módulo, no sentido horário. B e C do livro são A e B aqui.
acceleration-of-a = Aceleração de A
acceleration-of-a-on-link-4 = Aceleração de A no elo 4
acceleration-of-b = Aceleração de B
acceleration-of-b-relative-to-a = Aceleração de B em relação a A
acceleration-of-b-with-an-accelerated-crank = Aceleração de B com manivela acelerada
acceleration-of-d = Aceleração de D
acceleration-of-p = Aceleração de P
acceleration-of-slip = Aceleração de deslizamento
acceleration-of-slip-along-name = Aceleração de deslizamento ao longo de { $name }
acceleration-of-the-crank-pin-along-the-lever = Aceleração do pino da manivela ao longo da alavanca
acceleration-of-the-crank-pin-along-the-slot = Aceleração do pino da manivela ao longo da ranhura
acceleration-of-the-crank-pin-in-the-slot = Aceleração do pino da manivela na ranhura
acceleration-of-the-crank-pin-in-the-slot-the-yoke-does-not-rotate-there-is-no-coriolis-acceleration = Aceleração do pino da manivela na ranhura; o garfo não gira: não há aceleração de Coriolis
acceleration-of-the-first-point-of-name = Aceleração do primeiro ponto de { $name }
acceleration-of-the-point-of-the-guide-of-name-that-is-under-it = Aceleração do ponto da guia de { $name } que está sob ele
acceleration-of-the-second-point-of-name = Aceleração do segundo ponto de { $name }
acceleration-of-what-slides-in-name = Aceleração do que desliza em { $name }
acceleration-of-name-a-f-a-q = Aceleração de { $name }: a_F − a_Q
acceleration-of-point-r-r = Aceleração de { $point }, α × r − ω² r
acceleration-of-point-that-of-the-pin-tangential-and-normal-parts-about-it = Aceleração de { $point }: a do pino, com as partes tangencial e normal em torno dele
accelerations-of-a-four-bar-chain = Acelerações de uma cadeia de quatro barras
angle-of-that-line-in-the-axes-of-name = Ângulo dessa reta nos eixos de { $name }
angle-of-name-that-of-its-driver = Ângulo de { $name }, o do seu acionamento
angle-of-name-that-of-its-guide = Ângulo de { $name }, o da sua guia
angle-of-name-its-end-is-on-the-line-of-the-slider = Ângulo de { $name }: a extremidade está na linha do cursor
angle-of-name-its-slot-goes-through-the-pin = Ângulo de { $name }: a ranhura passa pelo pino
angle-of-name-loop-of-pins-closed-by-the-triangle-of-its-lengths = Ângulo de { $name }: cadeia de pinos fechada pelo triângulo dos comprimentos
angular-acceleration-of-link-5 = Aceleração angular do elo 5
angular-acceleration-of-the-first-crank = Aceleração angular da primeira manivela
angular-acceleration-of-the-first-rod = Aceleração angular da primeira biela
angular-acceleration-of-the-second-crank = Aceleração angular da segunda manivela
angular-acceleration-of-the-second-crank-by-the-gears = Aceleração angular da segunda manivela, pelas engrenagens
angular-acceleration-of-the-second-rod = Aceleração angular da segunda biela
angular-velocity-of-link-5 = Velocidade angular do elo 5
angular-velocity-of-link-n-by-both-cranks = Velocidade angular do elo { $n }: pelas duas manivelas
angular-velocity-of-the-first-crank = Velocidade angular da primeira manivela
angular-velocity-of-the-first-rod = Velocidade angular da primeira biela
angular-velocity-of-the-guide-of-name = Velocidade angular da guia de { $name }
angular-velocity-of-the-second-crank = Velocidade angular da segunda manivela
angular-velocity-of-the-second-crank-by-the-gears = Velocidade angular da segunda manivela, pelas engrenagens
angular-velocity-of-the-second-rod = Velocidade angular da segunda biela
angular-velocity-of-name-that-of-its-driver = Velocidade angular de { $name }, a do seu acionamento
angular-velocity-of-name-both-bodies-give-their-pin-the-same-velocity = Velocidade angular de { $name }: os dois corpos dão ao seu pino a mesma velocidade
angular-velocity-of-name-it-translates-along-its-guide = Velocidade angular de { $name }: ele translada ao longo da guia
angular-velocity-of-name-its-end-has-no-velocity-across-the-line-of-the-slider = Velocidade angular de { $name }: a extremidade não tem velocidade transversal à linha do cursor
angular-velocity-of-name-velocity-of-the-pin-across-the-slot = Velocidade angular de { $name }: velocidade do pino transversal à ranhura
constraint-equations-at-the-position = Equações de restrição na posição
coriolis-acceleration = Aceleração de Coriolis
coriolis-acceleration-from-the-derivative-of-the-triangle-of-the-pivots = aceleração de Coriolis pela derivada do triângulo dos pivôs
coriolis-acceleration-in-a-swinging-cylinder = Aceleração de Coriolis em um cilindro oscilante
coriolis-acceleration-in-name-2-v-s-perpendicular-to-it = Aceleração de Coriolis em { $name }, 2 ω v_s, perpendicular a ele
coriolis-acceleration-of-a-crank-pin-in-its-slot = Aceleração de Coriolis de um pino de manivela na ranhura
coriolis-acceleration-of-the-crank-pin = Aceleração de Coriolis do pino da manivela
coriolis-acceleration-of-the-piston = Aceleração de Coriolis do pistão
coriolis-acceleration-2-v-s-perpendicular-to-the-line-of-sliding = Aceleração de Coriolis, 2 ω v_s, perpendicular à linha de deslizamento
crank-at-its-inner-dead-centre-in-motion = Manivela no ponto morto interno, em movimento
crank-in-line-with-its-cylinder = Manivela alinhada com o cilindro
direction-of-its-acceleration-from-x = Direção da aceleração, a partir de x
direction-of-its-velocity-from-x = Direção da velocidade, a partir de x
direction-of-relative-acceleration = Direção da aceleração relativa
direction-of-the-acceleration = Direção da aceleração
direction-of-the-acceleration-of-a = Direção da aceleração de A
direction-of-the-acceleration-of-a-on-link-4 = Direção da aceleração de A no elo 4
direction-of-the-acceleration-of-b = Direção da aceleração de B
direction-of-the-acceleration-of-b-relative-to-a = Direção da aceleração de B em relação a A
direction-of-the-acceleration-of-d = Direção da aceleração de D
direction-of-the-acceleration-of-p = Direção da aceleração de P
direction-of-the-acceleration-of-name-from-x = Direção da aceleração de { $name }, a partir de x
direction-of-the-relative-acceleration-of-name-from-x = Direção da aceleração relativa de { $name }, a partir de x
direction-of-the-relative-velocity = Direção da velocidade relativa
direction-of-the-relative-velocity-of-name-from-x = Direção da velocidade relativa de { $name }, a partir de x
direction-of-the-velocity = Direção da velocidade
direction-of-the-velocity-of-a = Direção da velocidade de A
direction-of-the-velocity-of-a-on-link-4 = Direção da velocidade de A no elo 4
direction-of-the-velocity-of-b = Direção da velocidade de B
direction-of-the-velocity-of-b-relative-to-a = Direção da velocidade de B em relação a A
direction-of-the-velocity-of-d = Direção da velocidade de D
direction-of-the-velocity-of-p = Direção da velocidade de P
direction-of-the-velocity-of-name-from-x = Direção da velocidade de { $name }, a partir de x
distance-of-the-line-of-name-to-the-left-of-the-pin = Distância da linha de { $name } à esquerda do pino
fossee-scilab-companion-to-r-s-khurmi-j-k-gupta-theory-of-machines-ex-7-1 = companion Scilab da FOSSEE para R. S. Khurmi, J. K. Gupta, Theory of Machines, ex. 7.1
fossee-scilab-companion-to-r-s-khurmi-j-k-gupta-theory-of-machines-ex-8-1 = companion Scilab da FOSSEE para R. S. Khurmi, J. K. Gupta, Theory of Machines, ex. 8.1
fossee-scilab-companion-to-r-s-khurmi-j-k-gupta-theory-of-machines-ex-8-4 = companion Scilab da FOSSEE para R. S. Khurmi, J. K. Gupta, Theory of Machines, ex. 8.4
fossee-scilab-companion-to-r-s-khurmi-j-k-gupta-theory-of-machines-ex-8-5 = companion Scilab da FOSSEE para R. S. Khurmi, J. K. Gupta, Theory of Machines, ex. 8.5
from-the-pivot-to-the-pin-in-name = Do pivô ao pino em { $name }
law-of-cosines-angle-between-that-line-and-name = Lei dos cossenos: ângulo entre essa reta e { $name }
left-side = Lado esquerdo
length-of-name-between-its-pins = Comprimento de { $name } entre os pinos
magnitude-of-relative-acceleration = Módulo da aceleração relativa
magnitude-of-the-acceleration = Módulo da aceleração
magnitude-of-the-acceleration-of-a = Módulo da aceleração de A
magnitude-of-the-acceleration-of-a-on-link-4 = Módulo da aceleração de A no elo 4
magnitude-of-the-acceleration-of-b = Módulo da aceleração de B
magnitude-of-the-acceleration-of-b-relative-to-a = Módulo da aceleração de B em relação a A
magnitude-of-the-acceleration-of-d = Módulo da aceleração de D
magnitude-of-the-acceleration-of-p = Módulo da aceleração de P
magnitude-of-the-acceleration-of-name = Módulo da aceleração de { $name }
magnitude-of-the-acceleration-of-point = Módulo da aceleração de { $point }
magnitude-of-the-relative-acceleration-of-name = Módulo da aceleração relativa de { $name }
motion-of-the-apex-with-geared-cranks = Movimento do vértice com manivelas engrenadas
motion-of-the-connecting-rod-at-300-rpm = Movimento da biela a 300 rpm
motion-of-the-points-of-a-parallelogram = Movimento dos pontos de um paralelogramo
normal-acceleration-of-a = Aceleração normal de A
normal-acceleration-of-a-on-link-4 = Aceleração normal de A no elo 4
normal-acceleration-of-b = Aceleração normal de B
normal-acceleration-of-b-relative-to-a = Aceleração normal de B em relação a A
normal-acceleration-of-point-towards-the-centre-r = Aceleração normal de { $point }, para o centro: ω² r
pq-62-5-mm-at-10-rad-s-clockwise-qr-175-mm-rs-112-5-mm-ps-200-mm-angle-qps-60-q-and-r-of-the-book-are = PQ = 62,5 mm a 10 rad/s no sentido horário, QR = 175 mm, RS = 112,5 mm, PS = 200 mm, ângulo QPS = 60°. Q e R do livro são A e B aqui; os módulos têm os sinais dos sentidos impressos.
parallel-cranks-at-the-same-speed = Manivelas paralelas com a mesma velocidade
points-whose-relative-motion-is-computed = Pontos cujo movimento relativo é calculado
relative-acceleration-of-the-point = Aceleração relativa do ponto
relative-coordinate = Coordenada relativa
relative-speed-of-the-point = Velocidade escalar relativa do ponto
relative-speed-of-name = Velocidade escalar relativa de { $name }
relative-to = Em relação a
relative-velocity-of-the-point = Velocidade relativa do ponto
right-side = Lado direito
slip-of-the-crank-pin-in-the-yoke = Deslizamento do pino da manivela no garfo
slip-with-the-crank-along-the-line-of-the-yoke = Deslizamento com a manivela na linha do garfo
speed-of-a = Velocidade escalar de A
speed-of-a-on-link-4 = Velocidade escalar de A no elo 4
speed-of-b = Velocidade escalar de B
speed-of-b-relative-to-a = Velocidade escalar de B em relação a A
speed-of-d = Velocidade escalar de D
speed-of-p = Velocidade escalar de P
speed-of-the-point = Velocidade escalar do ponto
speed-of-point = Velocidade escalar de { $point }
stephenson-a-point-of-the-coupler-of-a-parallelogram = Stephenson: um ponto do acoplador de um paralelogramo
tangential-acceleration-of-a = Aceleração tangencial de A
tangential-acceleration-of-a-on-link-4 = Aceleração tangencial de A no elo 4
tangential-acceleration-of-b = Aceleração tangencial de B
tangential-acceleration-of-b-relative-to-a = Aceleração tangencial de B em relação a A
tangential-acceleration-of-point-positive-counter-clockwise-r = Aceleração tangencial de { $point }, positiva no sentido anti-horário: α r
the-coupler-keeps-its-angle-d-moves-like-the-crank-pin-v-a-link-5-and-the-slider-are-an-offset-slider = O acoplador mantém o ângulo: D se move como o pino da manivela, v = a ω; o elo 5 e o cursor são um cursor-manivela excêntrico com D como pino da manivela
the-coupler-keeps-its-angle-v-p-v-b-v-a-a-at-2-90-a-p-a-b-a-a-a-at-2-180 = O acoplador mantém o ângulo: v_P = v_B = v_A = a ω a θ_2 + 90°, a_P = a_B = a_A = a ω² a θ_2 + 180°
motion-of-the-points-of-an-accelerated-crank-rocker = Movimento dos pontos de uma manivela-balancim acelerada
closed-form-b-and-p-from-the-intersection-of-two-circles-differentiated-twice-with-2-65-12-t-25-t = forma fechada: B e P pela interseção de duas circunferências, derivados duas vezes com θ_2 = 65° + 12 t − 25 t²
uniform-bars-in-motion = Barras uniformes em movimento
closed-form-t-j-j-2-v-with-j-2-the-kinetic-energy-of-the-three-bars-and-v-their-potential-energy = forma fechada: T = J α + J′ ω²/2 + V′, com J ω²/2 a energia cinética das três barras e V a sua energia potencial
closed-form-t-j-j-2-v-f-x-with-j-2-the-kinetic-energy-of-bars-and-slider-v-their-potential-energy-and = forma fechada: T = J α + J′ ω²/2 + V′ − F x′, com J ω²/2 a energia cinética das barras e do cursor, V a sua energia potencial e x a posição do cursor
stephenson-an-accelerated-crank-rocker-and-a-slider-on-an-inclined-line = Stephenson: manivela-balancim acelerada e cursor em guia inclinada
closed-form-b-d-and-the-slider-from-intersections-of-circles-and-a-line-differentiated-twice-with-2 = forma fechada: B, D e o cursor por interseções de circunferências e uma reta, derivados duas vezes com θ_2 = 55° + 9 t + 15 t²; T = −F dx/dθ
the-rods-keep-their-angles-v-p-v-a-v-b-a-a-p-a-towards-the-pivots = As bielas mantêm os ângulos: v_P = v_A = v_B = a ω, a_P = a ω² para os pivôs
unit-vector-along-name = Vetor unitário ao longo de { $name }
vector-of-name-from-its-first-pin = Vetor de { $name } a partir do primeiro pino
vector-of-name-which-closes-the-loop = Vetor de { $name }, que fecha a cadeia
velocities-of-a-four-bar-chain-at-120-rpm = Velocidades de uma cadeia de quatro barras a 120 rpm
velocity-equations-coefficients-of-the-velocities-of-each-body = Equações de velocidade: coeficientes das velocidades de cada corpo
velocity-of-a = Velocidade de A
velocity-of-a-on-link-4 = Velocidade de A no elo 4
velocity-of-b = Velocidade de B
velocity-of-b-relative-to-a = Velocidade de B em relação a A
velocity-of-d = Velocidade de D
velocity-of-p = Velocidade de P
velocity-of-slip = Velocidade de deslizamento
velocity-of-slip-along-name = Velocidade de deslizamento ao longo de { $name }
velocity-of-the-crank-pin-in-the-slot = Velocidade do pino da manivela na ranhura
velocity-of-the-crank-pin-in-the-slot-the-part-of-its-velocity-along-y = Velocidade do pino da manivela na ranhura: a parte da sua velocidade ao longo de y
velocity-of-the-first-point-of-name = Velocidade do primeiro ponto de { $name }
velocity-of-the-point-of-the-guide-of-name-that-is-under-it = Velocidade do ponto da guia de { $name } que está sob ele
velocity-of-the-point-of-the-lever-that-is-under-the-crank-pin-across-it = Velocidade do ponto da alavanca sob o pino da manivela, transversal a ela
velocity-of-the-second-point-of-name = Velocidade do segundo ponto de { $name }
velocity-of-what-slides-in-name = Velocidade do que desliza em { $name }
velocity-of-name-v-f-v-q = Velocidade de { $name }: v_F − v_Q
velocity-of-name-r-along-its-body = Velocidade de { $name }: ω × r ao longo do corpo
velocity-of-point-r = Velocidade de { $point }, ω × r
velocity-of-point-that-of-the-pin-and-r-about-it = Velocidade de { $point }: a do pino e ω × r em torno dele
whole-turns-of-name-from-its-initial-angle = Voltas inteiras de { $name } a partir do ângulo inicial
a-point-a-from-a-relative-along-x = a_{ $point } = a_{ $from } + a_{ $relative }, ao longo de x
a-point-a-from-a-relative-along-y = a_{ $point } = a_{ $from } + a_{ $relative }, ao longo de y
acceleration-across-name-is-the-coriolis-acceleration = aceleração transversal a { $name } é a aceleração de Coriolis
acceleration-of-slip-and-coriolis-acceleration-make-up-the-relative-acceleration-in-name = aceleração de deslizamento e aceleração de Coriolis compõem a aceleração relativa em { $name }
acceleration-of-slip-from-the-second-derivative-of-the-triangle-of-the-pivots = aceleração de deslizamento pela segunda derivada do triângulo dos pivôs
acceleration-of-point-along-x-from-the-derivatives-of-the-constraint-equations = aceleração de { $point } ao longo de x pelas derivadas das equações de restrição
acceleration-of-point-along-y-from-the-derivatives-of-the-constraint-equations = aceleração de { $point } ao longo de y pelas derivadas das equações de restrição
angular-acceleration-of-link-n-from-the-derivatives-of-the-constraint-equations = aceleração angular do elo { $n } pelas derivadas das equações de restrição
angular-velocity-of-link-n-from-the-derivatives-of-the-constraint-equations = velocidade angular do elo { $n } pelas derivadas das equações de restrição
distance-along-x = distância ao longo de x
distance-along-y = distância ao longo de y
distance-from-the-line = distância à reta
distance-of-two-points = distância de dois pontos
normal-and-tangential-acceleration-of-point-make-up-its-acceleration = aceleração normal e tangencial de { $point } compõem a sua aceleração
polar-angle = ângulo polar
r-300-mm-across-the-frame-of-400-mm-s-500-mm-v-a-3-m-s-has-1-8-m-s-across-the-cylinder-and-2-4-m-s = r = 300 mm transversal à base de 400 mm, s = 500 mm: v_A = 3 m/s tem 1,8 m/s transversal ao cilindro e −2,4 m/s ao longo dele; ω_4 = 3,6 rad/s, a_c = 2·3,6·(−2,4), a_s = −0,6·30 + 0,5·3,6², α_4 = (−24 − a_c)/0,5
relative-acceleration-of-name-on-one-body-is-r-r-along-x = aceleração relativa de { $name } no mesmo corpo é α × r − ω² r, ao longo de x
relative-acceleration-of-name-on-one-body-is-r-r-along-y = aceleração relativa de { $name } no mesmo corpo é α × r − ω² r, ao longo de y
relative-angle = ângulo relativo
relative-velocity-of-name-as-the-rate-of-its-distance-along-x = velocidade relativa de { $name } como taxa da distância ao longo de x
relative-velocity-of-name-as-the-rate-of-its-distance-along-y = velocidade relativa de { $name } como taxa da distância ao longo de y
relative-velocity-of-name-on-one-body-is-r-along-x = velocidade relativa de { $name } no mesmo corpo é ω × r, ao longo de x
relative-velocity-of-name-on-one-body-is-r-along-y = velocidade relativa de { $name } no mesmo corpo é ω × r, ao longo de y
slip-from-the-derivative-of-the-triangle-of-the-pivots = deslizamento pela derivada do triângulo dos pivôs
sum-of-relative-coordinates = soma de coordenadas relativas
the-book-squares-a-rounded-velocity = o livro eleva ao quadrado uma velocidade arredondada
v-s-r-cos-a-s-r-cos-sin-with-the-motion-of-the-pin-r-across-the-crank = v_s = r ω cos θ, a_s = r (α cos θ − ω² sin θ), com o movimento do pino r ω transversal à manivela
v-point-v-from-v-relative-along-x = v_{ $point } = v_{ $from } + v_{ $relative }, ao longo de x
v-point-v-from-v-relative-along-y = v_{ $point } = v_{ $from } + v_{ $relative }, ao longo de y
velocity-of-slip-as-the-rate-of-the-distance-along-name = velocidade de deslizamento como taxa da distância ao longo de { $name }
velocity-of-point-along-x-from-the-derivatives-of-the-constraint-equations = velocidade de { $point } ao longo de x pelas derivadas das equações de restrição
velocity-of-point-along-y-from-the-derivatives-of-the-constraint-equations = velocidade de { $point } ao longo de y pelas derivadas das equações de restrição
y-a-sin-b-d-2-a-cos-at-70-differentiated-twice-with-10-rad-s-and-20-rad-s = y = a sen θ + √(b² − (d/2 − a cos θ)²) a 70°, derivada duas vezes com ω = 10 rad/s e α = 20 rad/s²
name-magnitude-and-direction-make-up-the-vector = { $name }: módulo e direção compõem o vetor
point-magnitude-and-direction-make-up-the-vector = { $point }: módulo e direção compõem o vetor
n-0-the-pin-moves-along-the-slot-only-v-s-r-a-s-0 = θ = 0: o pino se move apenas ao longo da ranhura, v_s = r ω, a_s = 0
crank-of-100-mm-at-90-and-10-rad-s-d-is-150-mm-along-the-coupler-link-5-of-250-mm-rises-by-150-mm = Manivela de 100 mm a 90° e 10 rad/s; D está a 150 mm ao longo do acoplador; o elo 5 de 250 mm sobe 150 mm em 200 mm: ω_5 = 0, v = −1 m/s para o cursor, α_5 = 10/0,2 rad/s², a = −0,15·50 m/s².
crank-pin-farthest-from-the-pin-of-the-cylinder-no-slip-no-coriolis-acceleration-4-r-d-r-a-s-r-d-r-4 = Pino da manivela o mais longe possível do pino do cilindro: sem deslizamento, sem aceleração de Coriolis, ω_4 = r ω/(d + r), a_s = −r ω² + (d + r) ω_4², α_4 = r α/(d + r)
normal-acceleration-of-d = Aceleração normal de D
normal-acceleration-of-p = Aceleração normal de P
ob-150-mm-at-300-rpm-ba-600-mm-the-angle-of-45-is-that-of-the-book-from-memory-the-crank-leaves-its = OB = 150 mm a 300 rpm, BA = 600 mm; o ângulo de 45° é o do livro, de memória. A manivela deixa o ponto morto interno; o livro a desenha no sentido horário, com o cursor à esquerda, de modo que os sentidos são os opostos. A e B do livro são B e A aqui.
p1a-300-mm-at-10-rad-s-and-30-rad-s-both-clockwise-ab-p2b-360-mm-the-frame-of-600-mm-and-the-angle-of = P1A = 300 mm a 10 rad/s e 30 rad/s², ambos no sentido horário, AB = P2B = 360 mm; a base de 600 mm e o ângulo de 60° são os do livro, de memória.
pq-62-5-mm-at-10-rad-s-clockwise-qr-175-mm-rs-112-5-mm-ps-200-mm-angle-qps-60 = PQ = 62,5 mm a 10 rad/s no sentido horário, QR = 175 mm, RS = 112,5 mm, PS = 200 mm, ângulo QPS = 60°.
pin-in-the-slot-of-a-lever-with-coriolis-acceleration = Pino na ranhura de uma alavanca, com aceleração de Coriolis
relative-velocity-of-the-pins-of-a-four-bar-chain = Velocidade relativa dos pinos de uma cadeia de quatro barras
slider-of-an-in-line-slider-crank-at-its-inner-dead-centre = Cursor de um cursor-manivela alinhado no ponto morto interno
tangential-acceleration-of-d = Aceleração tangencial de D
tangential-acceleration-of-p = Aceleração tangencial de P
the-guide-belongs-to-the-ground-there-is-no-coriolis-acceleration = A guia pertence à base: não há aceleração de Coriolis.
the-point-of-the-lever-under-the-pin-has-the-velocity-of-the-pin-less-the-slip-1-8-m-s = O ponto da alavanca sob o pino tem a velocidade do pino menos o deslizamento: 1,8 m/s.
r-300-mm-d-400-mm-crank-across-the-frame-500-mm-v-a-3-m-s-has-1-8-m-s-across-the-slot-and-2-4-m-s = r = 300 mm, d = 400 mm, manivela transversal à base, ρ = 500 mm: v_A = 3 m/s tem 1,8 m/s transversal à ranhura e 2,4 m/s ao longo dela; ω_4 = 3,6 rad/s, a_c = 2·3,6·2,4, a_s = −0,6·30 + 0,5·3,6²
triangle-of-300-400-and-500-mm-of-v-a-3-m-s-1-8-m-s-are-across-the-slot-and-2-4-m-s-along-it-1-8-0-5 = Triângulo de 300, 400 e 500 mm: de v_A = 3 m/s, 1,8 m/s são transversais à ranhura e 2,4 m/s ao longo dela; ω = 1,8/0,5, a_c = 2·3,6·2,4, a_s = −0,6·30 + 0,5·3,6²

# virtual-work/cam
n-2h-2-30-mm-10-rad-s-0-6-m-s-the-mean-of-a-velocity-that-rises-from-zero-to-its-maximum-and-falls = 2hω/β = 2 × 30 mm × 10π rad/s/π = 0,6 m/s: a média de uma velocidade que cresce de zero ao máximo e volta a zero é metade do máximo, 0,3 m/s em 0,1 s. As notas usam o dobro.
n-3-4-5-polynomial = Polinômio 3-4-5
n-3-4-5-polynomial-with-an-offset-roller = Polinômio 3-4-5 com rolete excêntrico
n-4-5-6-7-polynomial = Polinômio 4-5-6-7
n-4h-12-m-s-with-24-m-s-over-half-of-the-0-1-s-the-follower-would-rise-by-30-mm-in-the-first-half = 4hω²/β² = 12 m/s²: com 24 m/s² durante metade de 0,1 s, o seguidor subiria 30 mm só na primeira metade.
n-4h-4-0-008-m-40-rad-s-3-0-032-m-14-400-s-460-8-m-s-the-last-digit-is-lost-by-rounding-on-the-way = 4hω²/β² = 4 × 0,008 m × (40π rad/s)²/(π/3)² = 0,032 m × 14 400 s⁻² = 460,8 m/s²; o último algarismo se perde nos arredondamentos intermediários.
a-lift-of-10-mm-of-25-is-reached-where-cos-0-2-at-26-154-of-60 = A elevação de 10 mm de 25 é atingida onde cos(πθ/β) = 0,2, em 26,154° de 60°.
acceleration-of-the-follower = Aceleração do seguidor
acceleration-per-radian-of-the-cam-squared = Aceleração por radiano² do came
acceleration-per-radian-of-the-cam-squared-d-s-d = Aceleração por radiano ao quadrado do came, d²s/dθ²
all-that-moves-with-it-and-a-third-of-the-spring = Tudo o que se move com ele, e um terço da mola.
allowable-pressure-angle = Ângulo de pressão admissível
alone-between-two-dwells = Sozinha, entre dois repousos.
angle-of-the-arm-at-the-lowest-position = Ângulo do braço na posição mais baixa
angle-of-the-arm-to-the-line-of-centres = Ângulo do braço com a linha de centros
angle-of-the-arm-to-the-line-of-centres-at-the-lowest-position-by-the-cosine-rule = Ângulo do braço com a linha de centros na posição mais baixa, pela lei dos cossenos
any-base-circle-has-this-motion-30-mm-is-that-of-an-example-of-the-same-notes = Qualquer círculo de base tem este movimento; 30 mm é o de um exemplo das mesmas notas.
at-which-motion-contact-and-force-are-required = Em que se pedem movimento, contato e força.
away-from-the-pivot = Afastando-se da articulação
base-circle = Círculo de base
base-circle-radius = Raio do círculo de base
base-circle-radius-at-which-the-profile-has-a-cusp-it-must-be-larger = Raio do círculo de base com o qual o perfil tem um bico: deve ser maior
base-circle-radius-of-a-cusp = Raio de base que dá um bico no perfil
by-which-the-follower-comes-down = Quanto o seguidor desce.
cam-and-follower = Came e seguidor
cam-angle = Ângulo do came
cam-angle-at-which-contact-is-lost-first-as-the-speed-rises-by-search = Ângulo do came em que o contato se perde primeiro quando a rotação cresce, por busca
cam-angle-at-which-s-s-is-least-by-search = Ângulo do came em que s + s″ é mínimo, por busca
cam-angle-at-which-the-segment-begins = Ângulo do came em que o trecho começa
cam-angle-of-least-radius-of-curvature = Ângulo do came do menor raio de curvatura
cam-angle-of-the-maximum-pressure-angle-on-the-return = Ângulo do came do ângulo de pressão máximo no retorno
cam-angle-of-the-maximum-pressure-angle-on-the-rise = Ângulo do came do ângulo de pressão máximo na subida
cam-angle-of-the-largest-force = Ângulo do came da força máxima
cam-angle-of-the-largest-force-by-search = Ângulo do came da força máxima, por busca
cam-angle-of-the-largest-pressure-angle-on-a-return-by-search = Ângulo do came do maior ângulo de pressão em um retorno, por busca
cam-angle-of-the-largest-pressure-angle-on-a-rise-by-search = Ângulo do came do maior ângulo de pressão em uma subida, por busca
cam-angle-of-the-largest-torque-by-search = Ângulo do came do torque máximo, por busca
cam-angle-of-the-least-force = Ângulo do came da força mínima
cam-angle-of-the-least-force-by-search = Ângulo do came da força mínima, por busca
cam-angle-of-the-least-radius-of-curvature-of-the-convex-pitch-curve-by-search = Ângulo do came do menor raio de curvatura da curva primitiva convexa, por busca
cam-angle-of-the-least-torque-by-search = Ângulo do came do torque mínimo, por busca
cam-angle-of-the-segment = Ângulo do came no trecho
cam-angle-of-the-stroke = Ângulo do came no curso
cam-angle-that-needs-the-largest-cam = Ângulo do came que exige o maior came
cam-angle-that-needs-the-largest-cam-by-search-over-the-program = Ângulo do came que exige o maior came, por busca em todo o programa
cam-angle-within-the-revolution = Ângulo do came dentro da volta
cam-angles-of-acceleration-jumps = Ângulos do came com salto de aceleração
cam-angles-of-velocity-jumps = Ângulos do came com salto de velocidade
cam-speed-at-which-contact-is-lost = Rotação do came em que se perde o contato
constant-acceleration-over-half-a-revolution = Aceleração constante em meia volta
constant-acceleration-over-the-first-half-and-the-same-deceleration-over-the-second = Aceleração constante na primeira metade, e a mesma desaceleração na segunda.
constant-load = Carga constante
constant-of-the-acceleration-of-the-law-formula = Constante da aceleração da lei, { $formula }
constant-of-the-jerk-of-the-law-formula = Constante do jerk da lei, { $formula }
constant-of-the-velocity-of-the-law-formula = Constante da velocidade da lei, { $formula }
contact-from-the-axis-return = Contato a partir do eixo, retorno
contact-from-the-axis-rise = Contato a partir do eixo, subida
contact-from-the-cam-centre-across-the-line-of-the-follower-ds-d = Contato a partir do centro do came, perpendicular à linha do seguidor: ds/dθ
contact-from-the-cam-centre-in-the-axes-of-the-frame-trace-point-less-the-roller-along-the-normal = Contato a partir do centro do came, nos eixos da base: ponto de referência menos o rolete ao longo da normal
cycloidal = Cicloidal
cycloidal-rise-of-25-mm-in-90-at-30-rad-s = Subida cicloidal de 25 mm em 90° a 30 rad/s
derivative-of-the-tangent-by-across-the-motion-of-the-follower = Derivada da tangente em relação a θ, perpendicular ao movimento do seguidor
derivatives-of-the-pitch-curve-p-e-i-e-i-s-d-with-thirty-digits = Derivadas da curva primitiva P = e^(−iθ)(e + i(s + d)) com trinta algarismos
derivatives-of-the-pitch-curve-with-thirty-digits = Derivadas da curva primitiva com trinta algarismos
derivatives-of-the-pitch-curve-with-thirty-digits-extremes-over-two-million-points-of-each-segment = Derivadas da curva primitiva com trinta algarismos; extremos em dois milhões de pontos de cada trecho
derivatives-of-the-profile-with-thirty-digits = Derivadas do perfil com trinta algarismos
distance-of-its-line-from-the-centre-of-the-cam-positive-on-the-side-on-which-the-cam-moves-along = Distância da sua linha ao centro do came; positiva do lado em que o came se move no sentido da subida.
distance-of-the-centre-of-the-roller-or-of-the-knife-edge-at-the-lowest-position = Distância do centro do rolete, ou da faca, na posição mais baixa.
distance-of-the-contact-from-the-axis = Distância do contato ao eixo
distance-of-the-contact-from-the-line-of-the-follower-ds-d = Distância do contato à linha do seguidor: ds/dθ
distance-of-the-pivot-from-the-cam-centre = Distância da articulação ao centro do came
double-harmonic = Harmônica dupla
double-dwell-cam-with-spring-and-mass = Came de repouso duplo com mola e massa
dwell = Repouso
extremes-of-f-m-s-c-s-k-s-f-over-two-million-points-of-each-segment-data-of-a-design-problem-on-the = Extremos de F = m ω² s″ + c ω s′ + k s + F₀ em dois milhões de pontos de cada trecho; dados de um problema de projeto da web
flat-faced-follower = Seguidor de face plana
force-along-the-normal-without-friction-f-cos = Força ao longo da normal, sem atrito: F/cos φ
force-of-the-cam = Força do came
force-of-the-cam-along-the-motion = Força do came ao longo do movimento
force-of-the-cam-along-the-motion-of-the-follower-k-s-f-0-p-m-s-c-s = Força do came ao longo do movimento do seguidor: k s + F_0 + P + m ω² s″ + c ω s′
force-on-the-follower = Força no seguidor
force-there-by-the-same-formula = Força ali, pela mesma fórmula
from-a-dwell-up-to-a-velocity-of-twice-the-mean = De um repouso até uma velocidade igual ao dobro da média.
from-a-velocity-of-twice-the-mean-down-to-a-dwell = De uma velocidade igual ao dobro da média até um repouso.
from-the-pivot-to-the-centre-of-the-roller = Da articulação ao centro do rolete.
half-cycloidal-rise-and-half-harmonic-return = Subida semicicloidal e retorno semi-harmônico
half-cycloidal-accelerating = Semicicloidal, acelerando
half-cycloidal-decelerating = Semicicloidal, desacelerando
half-harmonic-accelerating = Semi-harmônica, acelerando
half-harmonic-decelerating = Semi-harmônica, desacelerando
height-of-the-trace-point-above-the-cam-centre-at-the-lowest-position = Altura do ponto de referência acima do centro do came na posição mais baixa
height-of-the-trace-point-at-the-lowest-position-from-tan-ds-d-e-s-d = Altura do ponto de referência na posição mais baixa, de tan φ = |ds/dθ − e|/(s + d)
in-order-their-cam-angles-make-up-360-and-the-returns-bring-the-follower-down-by-all-rises = Em ordem; os seus ângulos somam 360°, e os retornos baixam o seguidor de todas as subidas.
its-first-derivative-by-x = A sua primeira derivada em relação a x
its-force-at-the-lowest-position = A sua força na posição mais baixa.
its-second-derivative-by-x = A sua segunda derivada em relação a x
its-third-derivative-by-x = A sua terceira derivada em relação a x
jerk-of-the-follower = Jerk do seguidor
jerk-per-radian-of-the-cam-cubed = Jerk por radiano³ do came
jerk-per-radian-of-the-cam-cubed-d-s-d = Jerk por radiano ao cubo do came, d³s/dθ³
khurmi-gupta-theory-of-machines-ex-20-3 = Khurmi & Gupta, Theory of Machines, ex. 20.3
knife-edge-with-an-offset-to-the-wrong-side = Faca com excentricidade para o lado errado
knife-edge-follower-at-600-rpm-with-harmonic-strokes = Seguidor de faca a 600 rpm com cursos harmônicos
largest-ds-d-the-contact-moves-out-by-it-on-the-rise = Maior ds/dθ: o contato se afasta de tanto na subida
largest-force-of-the-cam = Força máxima do came
largest-torque-on-the-cam-shaft = Torque máximo no eixo do came
law-of-motion = Lei de movimento
least-ds-d-the-contact-moves-out-by-it-on-the-return = Menor ds/dθ: o contato se afasta de tanto no retorno
least-force-of-the-cam = Força mínima do came
least-preload-that-keeps-contact = Menor pré-carga que mantém o contato
least-radius-of-curvature-of-the-convex-profile = Menor raio de curvatura do perfil convexo
least-radius-of-curvature-of-the-pitch-curve-by-the-same-formula = Menor raio de curvatura da curva primitiva, pela mesma fórmula
least-radius-of-curvature-of-the-profile = Menor raio de curvatura do perfil
least-radius-of-curvature-of-the-profile-r-b-s-s = Menor raio de curvatura do perfil: ρ = R_b + s + s″
least-radius-of-curvature-pitch-curve = Menor raio de curvatura, curva primitiva
least-radius-of-curvature-profile = Menor raio de curvatura, perfil
least-radius-of-the-profile = Menor raio do perfil.
least-torque-on-the-cam-shaft = Torque mínimo no eixo do came
least-width-of-the-face = Menor largura da face
least-width-of-the-face-from-the-one-to-the-other = Menor largura da face, de um ao outro
lecture-notes-on-cam-profiles-mechanics-of-machinery-module-3-question-1-github = Notas de aula sobre perfis de cames, Mechanics of Machinery, módulo 3, questão 1 (GitHub)
lecture-notes-on-cam-profiles-mechanics-of-machinery-module-3-question-2-github = Notas de aula sobre perfis de cames, Mechanics of Machinery, módulo 3, questão 2 (GitHub)
lecture-notes-on-camshafts-for-the-ktu-university-exam-of-december-2023-github = Notas de aula sobre eixos de cames para o exame da universidade KTU de dezembro de 2023 (GitHub)
lecture-notes-on-camshafts-for-the-ktu-university-exam-of-july-2024-github = Notas de aula sobre eixos de cames para o exame da universidade KTU de julho de 2024 (GitHub)
left-out-the-motion-is-answered-per-radian-of-the-cam = Se omitida, o movimento é dado por radiano do came.
length-of-the-arm = Comprimento do braço
lift-against-cam-angle = Elevação em função do ângulo do came
lift-as-a-fraction-of-the-stroke-3-4-5-polynomial-y-10x-15x-6x = Elevação como fração do curso, polinômio 3-4-5: y = 10x³ − 15x⁴ + 6x⁵
lift-as-a-fraction-of-the-stroke-4-5-6-7-polynomial-y-35x-84x-70x-20x = Elevação como fração do curso, polinômio 4-5-6-7: y = 35x⁴ − 84x⁵ + 70x⁶ − 20x⁷
lift-as-a-fraction-of-the-stroke-constant-acceleration-over-the-first-half-y-2x = Elevação como fração do curso, aceleração constante na primeira metade: y = 2x²
lift-as-a-fraction-of-the-stroke-constant-deceleration-over-the-second-half-y-1-2-1-x = Elevação como fração do curso, desaceleração constante na segunda metade: y = 1 − 2(1 − x)²
lift-as-a-fraction-of-the-stroke-cycloidal-y-x-sin-2-x-2 = Elevação como fração do curso, cicloidal: y = x − sin(2πx)/(2π)
lift-as-a-fraction-of-the-stroke-double-harmonic-y-1-cos-x-2-1-cos-2-x-8 = Elevação como fração do curso, harmônica dupla: y = (1 − cos πx)/2 − (1 − cos 2πx)/8
lift-as-a-fraction-of-the-stroke-half-cycloidal-to-a-dwell-y-x-sin-x = Elevação como fração do curso, semicicloidal até um repouso: y = x + sin(πx)/π
lift-as-a-fraction-of-the-stroke-half-cycloidal-from-a-dwell-y-x-sin-x = Elevação como fração do curso, semicicloidal a partir de um repouso: y = x − sin(πx)/π
lift-as-a-fraction-of-the-stroke-half-harmonic-from-a-dwell-y-1-cos-x-2 = Elevação como fração do curso, semi-harmônica a partir de um repouso: y = 1 − cos(πx/2)
lift-as-a-fraction-of-the-stroke-half-harmonic-to-a-dwell-y-sin-x-2 = Elevação como fração do curso, semi-harmônica até um repouso: y = sin(πx/2)
lift-as-a-fraction-of-the-stroke-modified-sine-y-is-c-sin-4-x-on-x-1-8-c-cos-4-3-x-1-8-to-7-8-and-a = Elevação como fração do curso, senoidal modificada: y″ é C sen 4πx em x < 1/8, C cos(4π/3 (x − 1/8)) até 7/8, e de novo um seno
lift-as-a-fraction-of-the-stroke-modified-trapezoid-y-is-a-sine-on-x-1-8-constant-to-3-8-a-sine-to-5 = Elevação como fração do curso, trapezoidal modificada: y″ é um seno em x < 1/8, constante até 3/8, um seno até 5/8, constante até 7/8 e de novo um seno
lift-as-a-fraction-of-the-stroke-simple-harmonic-y-1-cos-x-2 = Elevação como fração do curso, harmônica simples: y = (1 − cos πx)/2
lift-as-a-fraction-of-the-stroke-uniform-velocity-y-x = Elevação como fração do curso, velocidade uniforme: y = x
lift-at-the-cam-angle-at-which-s-d-s-d-is-least-by-search-over-the-program = Elevação no ângulo do came em que s + d²s/dθ² é mínimo, por busca em todo o programa
lift-at-the-end = Elevação no fim
lift-at-the-start = Elevação no início
lift-at-which-the-segment-begins = Elevação em que o trecho começa
lift-there = Elevação ali
lift-velocity-acceleration-and-jerk-of-a-motion-program-pressure-angle-radius-of-curvature-and = Elevação, velocidade, aceleração e jerk de um programa de movimento, ângulo de pressão, raio de curvatura e perfil de um came de disco com seguidor de faca, de rolete, de face plana ou oscilante, e a força e o torque.
mass-of-the-follower = Massa do seguidor
maximum-acceleration-in-segment-n = Aceleração máxima no trecho { $n }
maximum-acceleration-on-the-return = Aceleração máxima no retorno
maximum-acceleration-on-the-rise = Aceleração máxima na subida
maximum-velocity-per-radian-rise = Velocidade máxima por radiano, subida
maximum-velocity-per-radian-return = Velocidade máxima por radiano, retorno
maximum-acceleration-per-radian-rise = Aceleração máxima por radiano², subida
maximum-acceleration-per-radian-return = Aceleração máxima por radiano², retorno
maximum-jerk-per-radian-rise = Jerk máximo por radiano³, subida
maximum-jerk-per-radian-return = Jerk máximo por radiano³, retorno
maximum-jerk = Jerk máximo
maximum-jerk-in-segment-n = Jerk máximo no trecho { $n }
maximum-jerk-on-the-return = Jerk máximo no retorno
maximum-jerk-on-the-rise = Jerk máximo na subida
maximum-pressure-angle-on-the-return = Ângulo de pressão máximo no retorno
maximum-pressure-angle-on-the-rise = Ângulo de pressão máximo na subida
maximum-velocity-in-segment-n = Velocidade máxima no trecho { $n }
maximum-velocity-on-the-return = Velocidade máxima no retorno
maximum-velocity-on-the-rise = Velocidade máxima na subida
modified-sine = Senoidal modificada
modified-sinusoidal-acceleration = Aceleração senoidal modificada
modified-trapezoid-on-a-return = Trapezoidal modificada em um retorno
modified-trapezoidal-acceleration = Aceleração trapezoidal modificada
motion-alone = Só o movimento
motion-of-the-cam-at-the-roller = Movimento do came no rolete
motion-of-the-follower = Movimento do seguidor
no-contact-and-no-profile = Sem contato e sem perfil.
normal-force-at-the-contact = Força normal no contato
offset-of-the-follower = Excentricidade do seguidor
on-rises-and-returns = Em subidas e retornos.
one-rise-or-return = Uma subida ou um retorno
oscillating-roller-cam-turning-away-from-the-pivot = Rolete oscilante, came girando para longe da articulação
oscillating-roller-cam-turning-towards-the-pivot = Rolete oscilante, came girando para a articulação
oscillating-roller-on-an-arm = Oscilante, rolete em um braço
parabolic-constant-acceleration = Parabólica: aceleração constante
part-of-the-cam-angle-of-the-segment = Fração do ângulo do came no trecho
perpendicular-to-its-motion = Perpendicular ao seu movimento.
point-of-the-profile-in-the-axes-of-the-cam-which-lie-along-those-of-the-frame-at-0 = Ponto do perfil nos eixos do came, que coincidem com os da base em θ = 0
point-of-the-profile-x = Ponto do perfil, x
point-of-the-profile-y = Ponto do perfil, y
preload-of-the-spring = Pré-carga da mola
preload-with-which-the-least-force-is-zero = Pré-carga com a qual a força mínima é nula
pressure-angle = Ângulo de pressão
pressure-angle-against-cam-angle = Ângulo de pressão em função do ângulo do came
pressure-angle-of-a-roller-follower-at-a-lift-of-10-mm = Ângulo de pressão de um seguidor de rolete com elevação de 10 mm
pressure-angle-there-from-the-same-two-legs = Ângulo de pressão ali, pelos mesmos dois catetos
pressure-angle-between-the-normal-of-the-pitch-curve-and-the-motion-of-the-follower-tan-b-a = Ângulo de pressão: entre a normal da curva primitiva e o movimento do seguidor, tan φ = b/a
prime-circle = Círculo primário
prime-circle-radius = Raio do círculo primário
r-b-least-of-s-s-over-two-million-points-of-each-segment = R_b = ρ − mínimo de (s + s″) em dois milhões de pontos de cada trecho
radius-of-curvature-of-the-pitch-curve = Raio de curvatura da curva primitiva
radius-of-curvature-of-the-pitch-curve-a-b-3-2-b-a-a-b = Raio de curvatura da curva primitiva, (a² + b²)^(3/2)/(b a′ − a b′)
radius-of-curvature-of-the-pitch-curve-a-b-3-2-b-a-a-b-without-offset-r-p-s-s-3-2-r-p-s-2s-r-p-s-s = Raio de curvatura da curva primitiva, (a² + b²)^(3/2)/(b a′ − a b′): sem excentricidade ((R_p + s)² + s′²)^(3/2)/((R_p + s)² + 2s′² − (R_p + s) s″)
radius-of-curvature-of-the-profile = Raio de curvatura do perfil
radius-of-curvature-of-the-profile-under-a-flat-face-r-b-s-s = Raio de curvatura do perfil sob uma face plana: ρ = R_b + s + s″
radius-of-curvature-of-the-profile-within-that-of-the-pitch-curve-by-the-roller = Raio de curvatura do perfil, menor que o da curva primitiva pelo raio do rolete
return = Retorno
rise = Subida
segments = Trechos
segments-joined-at-equal-velocities-2h-h-2-h-2-h-and-h = Trechos unidos com velocidades iguais: 2h/β, πh/(2β), πh/β², (π/2)² h/β² e π² h/β³
segments-of-a-full-revolution = Trechos de uma volta completa
segments-of-the-motion-program = Trechos do programa de movimento
side-thrust-on-the-guide = Força lateral na guia
side-thrust-on-the-guide-f-tan = Força lateral na guia: F tan φ
simple-harmonic = Harmônica simples
simple-harmonic-lift-of-a-valve-in-60 = Elevação harmônica simples de uma válvula em 60°
sines-and-constants-of-the-acceleration-integrated-twice-with-thirty-digits = Senos e constantes da aceleração, integrados duas vezes com trinta algarismos
sines-of-the-acceleration-integrated-twice-with-thirty-digits = Senos da aceleração, integrados duas vezes com trinta algarismos
size-of-the-cam = Tamanho do came
smallest-base-circle-radius-from-r-b-s-d-s-d = Menor raio do círculo de base, de ρ = R_b + s + d²s/dθ²
smallest-cam-for-a-flat-face = Menor came para uma face plana
smallest-cam-for-a-pressure-angle-of-30 = Menor came para um ângulo de pressão de 30°
smallest-for-a-pressure-angle = O menor para um ângulo de pressão
smallest-for-a-radius-of-curvature = O menor para um raio de curvatura
smallest-prime-circle-radius = Menor raio do círculo primário
speed-at-which-a-follower-jumps = Rotação em que um seguidor salta
speed-at-which-the-force-there-is-zero-m-s-k-s-f-0-p = Rotação em que a força ali é nula: m ω² |s″| = k s + F_0 + P
speed-of-the-cam = Rotação do came
tangent-of-the-pitch-curve-per-radian-of-the-cam-across-the-motion-of-the-follower-s-d = Tangente da curva primitiva por radiano do came, perpendicular ao movimento do seguidor: s + d
tangent-of-the-pitch-curve-per-radian-of-the-cam-across-the-motion-of-the-roller-c-sin = Tangente da curva primitiva por radiano do came, perpendicular ao movimento do rolete: c sen ψ
the-follower-dwells-at-this-lift = O seguidor repousa nesta elevação
the-half-harmonic-segments-begin-and-end-with-an-acceleration-it-jumps-there = Os trechos semi-harmônicos começam e terminam com uma aceleração: ela salta ali.
the-preload-of-10-n-is-not-enough-contact-is-lost = A pré-carga de 10 N não basta: o contato se perde.
the-same-along-its-second-axis = O mesmo ao longo do seu segundo eixo
the-same-along-the-motion = O mesmo ao longo do movimento
the-same-along-the-motion-of-the-follower-s-e = O mesmo ao longo do movimento do seguidor: s′ − e
the-same-along-the-motion-of-the-roller-l-1-c-cos = O mesmo ao longo do movimento do rolete: l (1 ± ψ′) − c cos ψ
the-same-along-the-second-axis = O mesmo ao longo do segundo eixo
the-same-lift-with-constant-acceleration = A mesma elevação com aceleração constante
torque-on-the-cam-shaft = Torque no eixo do came
torque-on-the-cam-shaft-by-virtual-work-t-f-s = Torque no eixo do came, pelo trabalho virtual: T δθ = F δs
torque-there-t-f-s = Torque ali, T = F s′
towards-the-pivot = Aproximando-se da articulação
translating-flat-face = De translação, face plana
translating-knife-edge = De translação, faca
translating-roller = De translação, rolete
uniform-velocity = Velocidade uniforme
valve-with-harmonic-motion-at-100-rpm = Válvula com movimento harmônico a 100 rpm
velocity-of-the-follower = Velocidade do seguidor
velocity-per-radian-of-the-cam = Velocidade por radiano do came
velocity-per-radian-of-the-cam-ds-d = Velocidade por radiano do came, ds/dθ
velocity-there-per-radian-of-the-cam-ds-d = Velocidade ali por radiano do came, ds/dθ
weight-and-working-load-positive-towards-the-cam = Peso e carga de trabalho, positivos para o came.
a-force-is-that-of-a-translating-follower-whose-lift-is-a-length-write-the-lift-in-mm-or-leave-the = uma força é a de um seguidor de translação, cuja elevação é um comprimento: escreva a elevação em mm, ou omita a força
a-prime-circle-of-prime-leaves-no-cam-within-a-roller-of-roller-write-a-larger-prime-circle-or-a = um círculo primário de { $prime } não deixa came dentro de um rolete de { $roller }: escreva um círculo primário maior ou um rolete menor
acceleration-by-differences-of-the-velocity-over-time = aceleração por diferenças da velocidade no tempo
acceleration-per-radian-squared-by-differences-of-the-velocity = aceleração por radiano ao quadrado por diferenças da velocidade
all-segments-are-dwells-write-a-rise-and-a-return = todos os trechos são repousos: escreva uma subida e um retorno
at-this-cam-angle = neste ângulo do came
base-circle-radius-and-radius-of-the-roller = raio do círculo de base e raio do rolete
base-circle-radius-by-a-fine-search-over-the-program = raio do círculo de base por uma busca fina em todo o programa
base-circle-radius-of-a-cusp-by-a-fine-search = raio de base que dá um bico, por uma busca fina
cam-angle-of-that-pressure-angle = ângulo do came desse ângulo de pressão
components-of-the-normal-force-along-and-across-the-motion = componentes da força normal: ao longo do movimento e perpendicular a ele
contact-is-lost-at-the-cam-angle-angle-to-follow-the-program-the-cam-would-have-to-pull-with-up-to = o contato se perde no ângulo do came { $angle }: para seguir o programa o came teria de puxar, com até { $force }; use uma pré-carga maior ou uma mola mais rígida
d-largest-of-s-e-tan-30-s-over-two-million-points-of-each-segment = d = máximo de |s′ − e|/tan 30° − s em dois milhões de pontos de cada trecho
distance-of-the-pivot-arm-and-prime-circle-radius-of-prime-make-no-triangle-mend-one-of-them = a distância da articulação, o braço e o raio do círculo primário de { $prime } não formam um triângulo: corrija um deles
distance-of-the-roller-from-the-cam-centre-at-that-angle-the-prime-circle-radius = distância do rolete ao centro do came nesse ângulo: o raio do círculo primário
ds-d-there = ds/dθ ali
d-s-d-there = d²s/dθ² ali
envelope-of-the-roller-by-differences-of-the-pitch-curve-first-axis = envoltória do rolete por diferenças da curva primitiva: primeiro eixo
envelope-of-the-roller-by-differences-of-the-pitch-curve-second-axis = envoltória do rolete por diferenças da curva primitiva: segundo eixo
envelope-the-point-does-not-leave-the-face-as-the-cam-turns = envoltória: o ponto não deixa a face quando o came gira
every-cam-has-this-radius-of-curvature-write-the-radius-of-the-base-circle = todo came tem este raio de curvatura: escreva o raio do círculo de base
every-cam-keeps-this-pressure-angle-write-the-radius-of-the-base-circle = todo came respeita este ângulo de pressão: escreva o raio do círculo de base
force-at-that-place-by-a-fine-search = força nesse lugar por uma busca fina
force-with-the-acceleration-by-differences-of-the-velocity = força com a aceleração por diferenças da velocidade
its-cam-angle-by-that-search = o seu ângulo do came por essa busca
jerk = jerk
jerk-by-differences-of-the-acceleration-over-time = jerk por diferenças da aceleração no tempo
jerk-per-radian-cubed-by-differences-of-the-acceleration = jerk por radiano ao cubo por diferenças da aceleração
largest-curvature-of-a-fine-search-its-inverse = maior curvatura de uma busca fina: o seu inverso
largest-pressure-angle-of-a-fine-search = maior ângulo de pressão de uma busca fina
largest-pressure-angle-of-a-fine-search-with-that-cam-the-allowable-one = maior ângulo de pressão de uma busca fina com esse came: o admissível
least-radius-of-curvature-of-a-fine-search = menor raio de curvatura de uma busca fina
lift-as-the-integral-of-the-velocity = elevação como integral da velocidade
lift-from-all-strokes-before = elevação por todos os cursos anteriores
mass-and-damping-of-the-follower-act-by-the-speed-of-the-cam-write-that-speed = massa e amortecimento do seguidor atuam pela rotação do came: escreva essa rotação
maximum-acceleration-of-a-search-over-the-stroke = aceleração máxima de uma busca ao longo do curso
maximum-jerk-of-a-search-over-the-stroke = jerk máximo de uma busca ao longo do curso
maximum-velocity-of-a-search-over-the-stroke = velocidade máxima de uma busca ao longo do curso
moment-of-the-normal-force-about-the-cam-centre-the-torque = momento da força normal em relação ao centro do came: o torque
no-force-acts-on-the-follower-write-a-mass-a-spring-a-preload-or-a-load = nenhuma força atua no seguidor: escreva uma massa, uma mola, uma pré-carga ou uma carga
preload-with-which-a-fine-search-finds-no-force-left = pré-carga com a qual uma busca fina não encontra força
pressure-angle-by-differences-of-the-pitch-curve = ângulo de pressão por diferenças da curva primitiva
radius-of-curvature-by-differences-of-the-tangent-of-the-pitch-curve = raio de curvatura por diferenças da tangente da curva primitiva
radius-of-curvature-speed-of-the-contact-along-the-face-by-differences = raio de curvatura: velocidade do contato ao longo da face, por diferenças
radius-of-the-profile-and-of-the-roller-that-of-the-pitch-curve = raio do perfil e do rolete: o da curva primitiva
segment-n-brings-the-follower-below-its-lowest-position-begin-with-the-rises-or-write-a-smaller-lift = o trecho { $n } leva o seguidor abaixo da sua posição mais baixa: comece pelas subidas, ou escreva uma elevação menor
speed-at-which-the-least-force-of-a-fine-search-is-zero = rotação em que a força mínima de uma busca fina é nula
that-distance-from-the-constants-of-the-laws-return = essa distância pelas constantes das leis, retorno
that-distance-from-the-constants-of-the-laws-rise = essa distância pelas constantes das leis, subida
that-of-the-profile-and-the-radius-of-the-roller = o do perfil e o raio do rolete
the-acceleration-jumps-first-at-the-cam-angle-angle-the-jerk-is-infinite-there = a aceleração salta, primeiro no ângulo do came { $angle }: o jerk é infinito ali
the-arm-would-swing-up-to-angle-and-pass-the-line-of-centres-write-a-smaller-lift-or-prime-circle = o braço oscilaria até { $angle } e passaria da linha de centros: escreva uma elevação ou um círculo primário menor
the-cam-angle-is-not-within-the-stroke-write-one-from-0-to-turn = o ângulo do came não está dentro do curso: escreva um de 0 a { $turn }
the-cam-angles-of-the-segments-make-up-sum-and-must-make-up-360-mend-an-angle-or-add-a-dwell = os ângulos dos trechos somam { $sum }, e devem somar 360°: corrija um ângulo ou acrescente um repouso
the-contact-lies-where-the-face-turns-about-it-by-differences-of-the-lift = o contato está onde a face gira em torno dele: por diferenças da elevação
the-follower-ends-rest-above-its-beginning-the-returns-must-bring-it-down-by-all-rises = o seguidor termina { $rest } acima do começo: os retornos devem baixá-lo de todas as subidas
the-lift-of-a-translating-follower-is-a-length-write-it-in-mm-or-choose-an-oscillating-follower = a elevação de um seguidor de translação é um comprimento: escreva-a em mm, ou escolha um seguidor oscilante
the-lift-of-an-oscillating-follower-is-the-angle-of-its-arm-write-it-in-degrees = a elevação de um seguidor oscilante é o ângulo do braço: escreva-a em graus
the-line-of-the-follower-passes-outside-of-the-prime-circle-of-prime-write-an-offset-below-it = a linha do seguidor passa fora do círculo primário de { $prime }: escreva uma excentricidade menor que ele
the-point-lies-on-the-face = o ponto está na face
the-profile-is-undercut-at-the-cam-angle-angle-where-r-b-s-s-is-radius-a-flat-face-needs-a-base = o perfil tem adelgaçamento (undercutting) no ângulo do came { $angle }, onde R_b + s + s″ é { $radius }: uma face plana exige um raio do círculo de base acima de { $least }
the-profile-is-undercut-at-the-cam-angle-angle-the-radius-of-curvature-of-the-pitch-curve-there = o perfil tem adelgaçamento (undercutting) no ângulo do came { $angle }: o raio de curvatura da curva primitiva ali, { $radius }, não é maior que o do rolete; use um círculo de base maior ou um rolete menor
the-velocity-jumps-first-at-the-cam-angle-angle-the-acceleration-is-infinite-there = a velocidade salta, primeiro no ângulo do came { $angle }: a aceleração é infinita ali
torque-at-that-place-by-a-fine-search = torque nesse lugar por uma busca fina
torque-from-the-energy-of-mass-spring-and-load-over-the-cam-angle-and-the-damping = torque pela energia de massa, mola e carga ao longo do ângulo do came, e pelo amortecimento
v-h-with-jumps-at-both-ends = v = hω/β, com saltos nos dois extremos
velocity-by-differences-of-the-lift-over-time = velocidade por diferenças da elevação no tempo
velocity-per-radian-by-differences-of-the-lift = velocidade por radiano por diferenças da elevação
width-from-the-constants-of-the-laws = largura pelas constantes das leis
h-2-9-8696-0-008-m-15791-4-s-2-1-09662-568-49-m-s-the-last-digit-is-lost-by-rounding-on-the-way = π² h ω²/(2β²) = 9,8696 × 0,008 m × 15791,4 s⁻²/(2 × 1,09662) = 568,49 m/s²; o último algarismo se perde nos arredondamentos intermediários.
r-b-s-s-width-from-the-largest-ds-d-2h-of-the-cycloid-and-h-2-of-the-harmonic = ρ = R_b + s + s″; largura pelo maior ds/dθ, 2h/β da cicloide e πh/(2β) da harmônica
least-of-k-s-f-m-s-over-two-million-points-of-each-segment = ω² = mínimo de (k s + F₀)/(m |s″|) em dois milhões de pontos de cada trecho
cam-angles-that-do-not-make-up-a-revolution = Ângulos do came que não completam uma volta
follower-that-does-not-come-back = Seguidor que não volta
n-20-mm-up-and-15-mm-down = 20 mm para cima e 15 mm para baixo
roller-as-large-as-the-prime-circle = Rolete tão grande quanto o círculo primário
r-b-r-p-r-r-is-not-positive = R_b = R_p − R_r não é positivo
n-90-90-100-60-340 = 90° + 90° + 100° + 60° = 340°
the-follower-is-at-rest-in-a-dwell = O seguidor está parado em um repouso

# virtual-work/geared-drive
geared-drive = Acionamento com engrenagens
acceleration-of-a-shaft-hoist-or-vehicle-that-a-motor-drives-through-gears-or-the-motor-torque-for-it = Aceleração de um eixo, guincho ou veículo que um motor aciona por engrenagens, ou o torque do motor para ela, com o rendimento das engrenagens conforme o sentido da potência; relação de transmissão da aceleração máxima.
inertia-on-the-motor-shaft = Inércia no eixo do motor
of-all-that-turns-with-the-motor = De tudo o que gira com o motor.
gear-ratio = Relação de transmissão
speed-of-the-motor-over-that-of-the-driven-shaft = Rotação do motor dividida pela do eixo movido.
efficiency-of-the-gears = Rendimento das engrenagens
power-that-leaves-them-over-the-power-that-enters-from-the-motor-to-the-load-or-from-the-load-to-the = Potência que sai delas dividida pela que entra, do motor para a carga ou da carga para o motor.
speed-of-the-driven-shaft = Rotação do eixo movido
at-which-the-power-is-required-and-up-to-which-the-time-from-rest = Em que se pede a potência, e até a qual se pede o tempo a partir do repouso.
shaft-with-a-torque = Eixo com um torque
inertia-on-the-driven-shaft = Inércia no eixo movido
torque-of-the-load = Torque da carga
on-the-driven-shaft-positive-against-forward-motion = No eixo movido, positivo contra o movimento para a frente.
hoist-a-mass-on-a-drum = Guincho: uma massa em um tambor
inertia-on-the-shaft-of-the-drum = Inércia no eixo do tambor
vehicle = Veículo
mass-of-the-vehicle = Massa do veículo
radius-of-the-wheels = Raio das rodas
inertia-of-the-wheels = Inércia das rodas
of-all-wheels-with-their-axles = De todas as rodas com os seus eixos.
resistance = Resistência
against-the-motion-rolling-and-air = Contra o movimento: rolamento e ar.
slope-of-the-road = Inclinação da estrada
positive-where-forward-is-uphill = Positiva onde se avança subindo.
from-rest = A partir do repouso
forward = Para a frente
backward = Para trás
acceleration-under-a-motor-torque = Aceleração sob um torque do motor
torque-of-the-motor = Torque do motor
motor-torque-for-an-acceleration = Torque do motor para uma aceleração
angular-acceleration-of-the-driven-shaft = Aceleração angular do eixo movido
nothing-has-inertia-write-that-of-the-motor-shaft-or-of-the-load = nada tem inércia: escreva a do eixo do motor ou a da carga
inertia-referred-to-the-driven-shaft-the-motor-drives-the-load-and-the-gears-pass-on-the-part = Inércia referida ao eixo movido: o motor aciona a carga, e as engrenagens passam adiante a parte η
inertia-referred-to-the-driven-shaft-the-load-drives-the-motor-and-the-gears-take-1 = Inércia referida ao eixo movido: a carga aciona o motor, e as engrenagens exigem 1/η
acceleration-of-the-driven-shaft = Aceleração do eixo movido
motor-torque-for-that-acceleration = Torque do motor para essa aceleração
motor-torque = Torque do motor
angular-acceleration-of-the-motor = Aceleração angular do motor
acceleration-of-the-motor = Aceleração do motor
acceleration-of-the-mass = Aceleração da massa
accelerations-of-the-mass-and-of-the-motor-by-the-radius-and-the-ratio = acelerações da massa e do motor pelo raio e pela relação
torque-of-the-gears-on-the-driven-shaft = Torque das engrenagens no eixo movido
torque-of-the-gears-driven-shaft = Torque das engrenagens, eixo movido
power-that-leaves-the-gears-of-what-the-motor-gives-beyond-its-own-inertia = potência que sai das engrenagens: η do que o motor dá além da sua própria inércia
power-that-reaches-the-motor-and-its-inertia-of-what-the-load-gives-to-the-gears = potência que chega ao motor e à sua inércia: η do que a carga dá às engrenagens
acceleration-of-the-motor-from-its-own-shaft = aceleração do motor pelo seu próprio eixo
power-of-the-motor-at-that-speed = Potência do motor nessa rotação
power-of-the-gears-and-of-the-inertia-of-the-motor-shaft = potência das engrenagens e da inércia do eixo do motor
time-from-rest-up-to-that-speed = Tempo do repouso até essa rotação
angle-turned-meanwhile-from-the-mean-speed = ângulo girado nesse tempo, pela rotação média
gear-ratio-of-the-maximum-acceleration-of-the-driven-shaft-from-d-dg-0 = Relação de transmissão da aceleração máxima do eixo movido, de dα₂/dG = 0
gear-ratio-of-maximum-acceleration = Relação da aceleração máxima
the-acceleration-does-not-change-with-the-ratio-there = a aceleração não muda com a relação ali
torque-of-the-load-in-this-direction-of-motion = Torque da carga neste sentido de movimento
inertia-at-the-driven-shaft-with-that-of-the-mass = Inércia no eixo movido, com a da massa
torque-of-the-weight = Torque do peso
torque-of-the-weight-on-the-slope = Torque do peso na rampa
torque-of-the-resistance-to-motion = Torque da resistência ao movimento
the-drive-stays-at-rest-under-this-torque-write-another-torque-or-choose-the-direction-in-which-it = o acionamento fica em repouso sob este torque: escreva outro torque, ou escolha o sentido em que se move
without-acceleration-nothing-leaves-its-rest-choose-the-direction-of-the-motion = sem aceleração nada sai do repouso: escolha o sentido do movimento
acceleration-of-the-driven-shaft-against-the-gear-ratio = Aceleração do eixo movido em função da relação de transmissão
at-this-ratio = nesta relação
the-motor-the-gears-and-the-load = O motor, as engrenagens e a carga
mass-that-falls-freely-and-turns-geared-shafts = Massa que cai livremente e gira eixos engrenados
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-3-13 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 3.13
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-3-14 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 3.14
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-3-15 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 3.15
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-3-17 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 3.17
up-is-positive-here-the-companion-prints-the-magnitude = Para cima é positivo aqui; a fonte imprime o módulo.
the-same-with-an-efficiency-of-90 = O mesmo com rendimento de 90 %
the-load-drives-the-motor-the-inertia-of-the-motor-counts-by-1 = A carga aciona o motor: a inércia do motor conta por 1/η.
ratio-of-the-maximum-acceleration = Relação da máxima aceleração
vehicle-that-climbs = Veículo em subida
the-slope-has-a-sine-of-0-25-6-67-m-s-on-wheels-of-0-3-m-are-22-233-rad-s = A rampa tem seno de 0,25; 6,67 m/s em rodas de 0,3 m são 22,233 rad/s.
power-of-a-motor-at-a-steady-speed = Potência de um motor em rotação constante
time-to-start-a-loaded-machine = Tempo de partida de uma máquina carregada
t-t-m-100-28-5-3-50877-so-the-sum-of-the-roots-is-7-01754-and-not-7-27-g-3-50877-3-50877-45-0-57-13 = T₂/(η T_m) = 100/28,5 = 3,50877, de modo que a soma das raízes é 7,01754 e não 7,27: G = 3,50877 + √(3,50877² + 45/0,57) = 13,062.
steady-lowering-against-a-braking-motor = Descida constante contra um motor que freia
t-m-g-r-g-with-the-load-driving = T = m g r η/G, com a carga acionando
hoist-held-by-the-losses-of-its-gears = Guincho sustentado pelas perdas das engrenagens
m-g-r-g-15-7-n-m-18-n-m-m-g-r-g-24-5-n-m-neither-up-nor-down = η m g r/G = 15,7 N·m < 18 N·m < m g r/(η G) = 24,5 N·m: nem sobe nem desce
cam-not-to-scale-and-lift-of-the-follower-over-its-angle = Came (fora de escala) e elevação do seguidor sobre o ângulo dele
the-flywheel-and-its-shaft = O volante e o seu eixo

# Statements of exercises.
the-motion-of-a-slider-crank-mechanism-is-given-by-vectors-x-y-to-be-taken-as-they-are-the-crank-2-is = O movimento de um mecanismo biela-manivela é dado por vetores (x; y), que devem ser tomados como estão. A manivela 2 está a 30° e gira a 20 rad/s; a biela 3 está a −22°. A biela tem 3 kg e 0,1 kg·m² em relação ao seu centro de massa, velocidade angular de −50 rad/s, aceleração angular de −800 rad/s², e seu centro de massa tem velocidade de (300; 200) m/s e aceleração de (900; −600) m/s². O cursor 4 tem 2 kg, velocidade de (−500; 0) m/s e aceleração de (900; 0) m/s². Uma força de (5000; 0) N atua no cursor; a gravidade é (0; −10) m/s². Pela potência virtual com as cargas de inércia de d'Alembert, determine as potências da força no cursor, da força de inércia da biela e do seu binário de inércia, e o torque motor na manivela.
two-levers-are-joined-by-a-link-when-the-lever-is-turned-so-that-its-point-c-goes-down-at-2-m-s-point = Duas alavancas são unidas por uma barra. Quando se giram as alavancas de modo que o ponto C desça a 2 m/s, o ponto A desce a 1 m/s, D a 1 m/s, E e G a 0,5 m/s. As cargas são 100 N para baixo em A, 60 N para baixo em D, 50 N para baixo em E e 40 N para cima em G; os pesos são desprezados. Pelo princípio dos trabalhos virtuais, determine a força vertical em C, positiva para cima, que mantém as alavancas em equilíbrio.
two-equal-uniform-ladders-each-4-m-long-with-a-weight-of-200-n-are-hinged-together-at-the-top-and = Duas escadas iguais e homogêneas, cada uma com 4 m de comprimento e peso de 200 N, são articuladas no topo e apoiam-se em um piso liso. Cada uma forma 30° com a vertical. Determine a força horizontal que deve segurar cada pé.
a-step-ladder-is-made-of-two-equal-uniform-halves-of-4-m-and-200-n-each-hinged-at-the-top-on-a-smooth = Uma escada dupla é formada por duas metades iguais e homogêneas de 4 m e 200 N cada uma, articuladas no topo, sobre um piso liso. Uma corda horizontal une as metades na fração 0,75 do comprimento, contada a partir da articulação. Com cada metade a 30° da vertical, determine a tração na corda.
a-uniform-bar-of-10-kg-and-1-5-m-is-pinned-at-one-end-a-cord-runs-from-the-bar-1-5-m-from-the-pin = Uma barra homogênea de 10 kg e 1,5 m está articulada em uma extremidade. Um cabo vai da barra, a 1,5 m da articulação, até uma pequena polia 1,2 m acima da articulação, na mesma vertical, e sustenta uma massa pendurada. Determine essa massa para o equilíbrio com a barra inclinada 20° acima da horizontal.
a-uniform-ladder-of-5-m-and-20-kg-leans-against-a-smooth-wall-and-stands-on-a-smooth-floor-at-an = Uma escada homogênea de 5 m e 20 kg apoia-se em uma parede lisa e em um piso liso, com ângulo de 30° em relação à parede. Não há outra carga (g = 9,81 m/s²). Determine a força horizontal no pé, dirigida para a parede, que a mantém em equilíbrio.
three-uniform-bars-each-2-ft-long-and-weighing-60-lbf-are-pinned-one-below-the-other-and-hang-from-a = Três barras homogêneas, cada uma com 2 ft e peso de 60 lbf, são articuladas uma abaixo da outra e pendem de um pino fixo. Uma força horizontal de 90 lbf puxa a extremidade livre da terceira. Determine os ângulos das barras com a vertical no equilíbrio, começando no pino fixo.
in-a-roberval-balance-two-parallel-beams-0-15-m-apart-have-a-left-arm-of-0-1-m-and-a-right-arm-of-0-5 = Em uma balança de Roberval, duas travessas paralelas, distantes 0,15 m, têm braço esquerdo de 0,1 m e braço direito de 0,5 m; os pratos permanecem nivelados. Uma massa de 10 kg está no prato esquerdo, e as travessas estão inclinadas 5°. Determine a massa no prato direito que mantém a balança em repouso nessa posição.
on-a-single-lever-a-hand-presses-with-30-n-at-an-arm-of-250-mm-the-load-is-on-the-other-side-of-the = Em uma alavanca simples, a mão aplica 30 N com braço de 250 mm. A carga está do outro lado do ponto de apoio, com braço de 50 mm. Determine a força na carga e a vantagem mecânica.
the-ram-of-an-arbor-press-is-a-rack-driven-by-a-pinion-of-30-mm-pitch-radius-a-force-of-200-n-acts-on = O martelo de uma prensa manual é uma cremalheira acionada por um pinhão de 30 mm de raio primitivo. Uma força de 200 N atua na alavanca, perpendicular a ela, a 450 mm do eixo do pinhão. O atrito é desprezado. Determine a força do martelo e a vantagem mecânica.
a-rack-press-of-80-efficiency-has-a-handle-of-0-5-m-a-gear-reduction-of-3-and-a-pinion-of-module-4-mm = Uma prensa de cremalheira com rendimento de 80 % tem alavanca de 0,5 m, redução por engrenagens de 3 e pinhão de módulo 4 mm com 20 dentes sobre a cremalheira. O martelo deve comprimir com 12 kN. Determine a força na alavanca e a vantagem mecânica com as perdas.
the-two-links-of-a-toggle-press-are-250-mm-long-each-the-link-at-the-fixed-pin-makes-10-with-the-line = As duas hastes de uma prensa de joelho têm 250 mm cada uma. A haste do pino fixo forma 10° com a linha de empuxo, e uma força de 500 N atua no joelho, perpendicular a essa linha. O atrito é desprezado. Determine o empuxo do martelo e a força na haste do pino fixo.
a-toggle-press-has-a-link-of-200-mm-at-the-fixed-pin-and-a-link-of-400-mm-at-the-ram-with-the-first = Uma prensa de joelho tem uma haste de 200 mm no pino fixo e uma de 400 mm no martelo. Com a primeira a 30° da linha de empuxo, o martelo deve comprimir com 1 kN. Determine a força no joelho, perpendicular à linha de empuxo, e a força na haste do martelo.
a-crate-of-1000-kg-weight-1000-9-81-n-stands-on-a-lift-table-with-two-equal-scissor-frames-side-by = Uma caixa de 1000 kg (peso 1000·9,81 N) está sobre uma mesa elevadora com duas armações iguais lado a lado (2 armações de 1 estágio), cada uma com seu cilindro hidráulico. As barras têm 1,4 m e formam 60° com a horizontal. O cilindro vai de um ponto do solo 3,2 m à direita do pé fixo até a barra que sobe para a direita no primeiro estágio, a 0,7 m ao longo dela. O peso das barras e da mesa é desprezado. Determine a força de cada cilindro.
a-screw-jack-with-a-single-square-thread-of-30-mm-mean-diameter-and-6-mm-lead-lifts-a-load-of-10-kn = Um macaco de parafuso com rosca quadrada de uma entrada, 30 mm de diâmetro médio e avanço de 6 mm levanta uma carga de 10 kN. O coeficiente de atrito da rosca é 0,12. O colar de escora tem diâmetro médio de 40 mm e coeficiente 0,1. Determine o torque para levantar a carga, o torque para baixá-la e o rendimento ao levantar.
a-car-jack-is-a-rhombus-of-four-links-of-150-mm-each-at-30-from-the-horizontal-drawn-together-by-a = Um macaco de automóvel é um losango de quatro hastes de 150 mm, cada uma a 30° da horizontal, fechado por um parafuso horizontal. O parafuso de rosca trapezoidal tem uma entrada, diâmetro médio de 11 mm, avanço de 3 mm, meio ângulo do filete de 15° e coeficiente de atrito 0,15. Para uma carga de 4 kN, determine a força axial no parafuso e o torque que levanta a carga.
two-equal-uniform-bars-ab-and-bc-of-1-m-and-10-kg-each-are-hinged-at-the-knee-b-which-hangs-below-a = Duas barras iguais e homogêneas AB e BC, de 1 m e 10 kg cada uma, são articuladas no joelho B, que fica abaixo. A é um pino fixo, e C desliza em uma guia horizontal lisa que passa por A. Não há força em B (g = 9,81 m/s²). Determine a força horizontal em C que mantém as barras a 45° da horizontal.
a-mass-of-10-kg-sits-on-an-arm-of-300-mm-fixed-to-a-disc-and-is-straight-above-the-axis-of-the-disc = Uma massa de 10 kg está em um braço de 300 mm fixo a um disco, e fica exatamente acima do eixo do disco quando a mola está sem deformação. Um cabo enrolado no disco no raio de 80 mm vai até uma mola de 4 kN/m. O disco pode girar de 0° a 180° (g = 9,81 m/s²). Determine o ângulo do braço com a posição vertical no equilíbrio estável, e a segunda derivada da energia potencial na posição vertical.
a-horizontal-lever-of-10-in-is-clamped-to-a-torsion-shaft-of-150-lbf-ft-rad-which-is-free-of-torque = Uma alavanca horizontal de 10 in está presa a um eixo de torção de 150 lbf·ft/rad, sem torque nessa posição. Uma carga vertical de 400 lbf atua em sua extremidade. Determine o ângulo com a horizontal, entre 0° e 90°, em que a alavanca fica em equilíbrio.
in-a-crank-and-slotted-lever-mechanism-the-crank-is-100-mm-long-and-its-pivot-is-300-mm-above-that-of = Em um mecanismo de manivela e alavanca ranhurada, a manivela tem 100 mm e seu pivô está 300 mm acima do pivô da alavanca, que tem 600 mm. Com a manivela a 90°, apontando para longe do pivô da alavanca, uma força de −200 N atua na extremidade da alavanca, perpendicular a ela e positiva no sentido anti-horário. As massas são desprezadas. Determine o torque na manivela, a razão dos tempos dos dois cursos e o ângulo que a alavanca percorre.
the-crank-of-a-small-steam-engine-is-50-mm-long-and-turns-about-the-origin-its-cylinder-swings-about = A manivela de uma pequena máquina a vapor tem 50 mm e gira em torno da origem; seu cilindro oscila em torno de um pino fixo em (−200; 0) mm. O vapor tem pressão de 8 bar em um cilindro de 60 mm de diâmetro. Com a manivela a 90° e massas desprezadas, determine a força do cilindro, a distância do seu pino ao pino da manivela e o torque na manivela.
the-crank-of-a-scotch-yoke-is-80-mm-long-and-stands-at-150-from-the-line-of-the-yoke-a-torque-of-12-n = A manivela de um mecanismo de jugo escocês tem 80 mm e está a 150° da linha do jugo. Um torque de 12 N·m atua na manivela, positivo no sentido anti-horário; massas e atrito são desprezados. Determine a força no jugo, segundo x, que mantém o mecanismo em equilíbrio.
a-scotch-yoke-of-4-kg-is-driven-by-a-crank-of-80-mm-that-turns-at-30-rad-s-and-is-at-30-from-the-line = Um jugo escocês de 4 kg é acionado por uma manivela de 80 mm que gira a 30 rad/s e está a 30° da linha do jugo. Uma força de −300 N atua no jugo segundo sua linha; o mecanismo está em um plano horizontal. Determine a posição, a velocidade e a aceleração do jugo e o torque na manivela.
an-engine-has-a-crank-of-50-mm-and-a-connecting-rod-of-200-mm-with-the-crank-at-30-from-the-line-of = Um motor tem manivela de 50 mm e biela de 200 mm. Com a manivela a 30° da linha de curso, uma força de −4 kN atua no pistão, em direção ao virabrequim. Pesos e atrito são desprezados. Determine o momento na manivela que a mantém em equilíbrio.
two-bars-of-0-6-m-and-0-7-m-form-a-slider-crank-the-first-makes-45-with-the-horizontal-guide-and-a = Duas barras de 0,6 m e 0,7 m formam um mecanismo biela-manivela. A primeira forma 45° com a guia horizontal, e uma carga de (0; −200) N atua na articulação entre elas. Não há torque na primeira barra, e os pesos são desprezados. Determine a posição do cursor em relação ao pino fixo e a força horizontal nele.
a-crank-rocker-has-a-crank-of-40-mm-a-coupler-of-120-mm-a-rocker-of-80-mm-and-a-frame-of-100-mm-its = Um mecanismo de quatro barras manivela-balancim tem manivela de 40 mm, acoplador de 120 mm, balancim de 80 mm e base de 100 mm; a montagem é aberta (não cruzada). Um torque de 10 N·m atua na manivela, que está a 60°. Os pesos são desprezados. Determine os ângulos do acoplador e do balancim e o torque no balancim no equilíbrio.
the-crank-of-a-four-bar-linkage-is-300-mm-long-and-turns-at-100-rpm-counter-clockwise-coupler-and = A manivela de um mecanismo de quatro barras tem 300 mm e gira a 100 rpm no sentido anti-horário. Acoplador e balancim têm 360 mm cada um, e a base tem 600 mm. Com a manivela a 60° e a montagem aberta, determine a velocidade angular do acoplador.
the-gas-in-an-engine-at-rest-presses-on-the-piston-with-4-kn-the-crank-is-50-mm-and-the-connecting = O gás em um motor parado empurra o pistão com 4 kN. A manivela tem 50 mm e a biela 200 mm; massas e atrito são desprezados. Determine o momento motor no virabrequim com a manivela 30° depois do ponto morto.
a-couple-of-75-lbf-ft-acts-on-the-crank-of-a-mechanism-with-a-crank-of-2-5-in-and-a-connecting-rod-of = Um momento de 75 lbf·ft atua na manivela de um mecanismo com manivela de 2,5 in e biela de 10 in. Massas e atrito são desprezados. Determine a força no pistão que mantém a manivela em equilíbrio a 60° do ponto morto.
an-engine-runs-at-450-rpm-its-crank-is-150-mm-long-and-its-connecting-rod-600-mm-with-the-crank-60 = Um motor gira a 450 rpm. A manivela tem 150 mm e a biela 600 mm. Com a manivela 60° depois do ponto morto, determine a velocidade e a aceleração do pistão pelos dois primeiros termos da série, e a velocidade e a aceleração angulares da biela pela mesma aproximação.
a-petrol-engine-has-a-bore-of-80-mm-a-crank-of-50-mm-a-connecting-rod-of-200-mm-and-reciprocating = Um motor a gasolina tem cilindro de 80 mm de diâmetro, manivela de 50 mm, biela de 200 mm e massas alternativas de 1 kg. A 1800 rpm, com a manivela 33° depois do ponto morto no tempo de expansão, a pressão manométrica sobre o pistão é de 0,7 MPa; atrás dele está a atmosfera (101,325 kPa). Tome a aceleração do pistão por dois termos. Determine a força resultante na direção do curso, a força na biela, a força na parede do cilindro e a rotação acima da qual o pino do pistão é carregado no outro sentido.
in-an-epicyclic-train-the-sun-has-24-teeth-and-drives-at-1200-rpm-with-10-n-m-the-ring-with-72-teeth = Em um trem epicicloidal, o solar tem 24 dentes e aciona a 1200 rpm com 10 N·m; a coroa, com 72 dentes, está fixa, e o braço é acionado. Não há perdas e o movimento é uniforme. Determine a rotação do braço, a rotação absoluta dos planetas, o torque da carga no braço e o torque que segura a coroa.
the-arm-of-a-gear-train-with-compound-planets-is-fixed-the-sun-has-20-teeth-and-turns-at-600-rpm-with = O braço de um trem de engrenagens com planetas compostos está fixo. O solar tem 20 dentes e gira a 600 rpm com torque motor de 6 N·m; ele engrena com a roda planetária de 40 dentes, e a de 30 dentes, no mesmo eixo, engrena com a coroa de 90 dentes. Sem perdas, determine a rotação da coroa, o torque da carga nela e o torque que segura o braço.
a-valve-is-lifted-by-8-mm-in-simple-harmonic-motion-while-its-cam-turns-through-60-at-1200-rpm-find = Uma válvula é erguida 8 mm em movimento harmônico simples enquanto seu came gira 60° a 1200 rpm. Determine a maior velocidade e a maior aceleração da válvula durante o levantamento.
with-constant-acceleration-and-equal-deceleration-parabolic-motion-a-valve-is-lifted-by-8-mm-while = Com aceleração constante e desaceleração igual (movimento parabólico), uma válvula é erguida 8 mm enquanto seu came gira 60° a 1200 rpm. Determine a maior velocidade e a aceleração.
a-follower-rises-by-25-mm-in-cycloidal-motion-while-the-cam-turns-through-90-the-cam-turns-at-30-rad = Um seguidor sobe 25 mm em movimento cicloidal enquanto o came gira 90°. O came gira a 30 rad/s. Determine a maior velocidade, a maior aceleração e o maior jerk do seguidor.
a-flywheel-of-6500-kg-with-a-radius-of-gyration-of-1-8-m-runs-at-a-mean-speed-of-120-rpm-the-energy = Um volante de 6500 kg com raio de giração de 1,8 m gira à rotação média de 120 rpm. A energia flutua 56 kJ em cada volta. Determine sua maior e sua menor rotação.
the-turning-moment-of-an-engine-is-t-20000-9500-sin-2-5700-cos-2-with-t-in-n-m-and-the-angle-of-the = O momento motor de uma máquina é T = 20000 + 9500 sen 2θ − 5700 cos 2θ, com T em N·m e θ o ângulo da manivela; o torque resistente é constante. À rotação média de 180 rpm, o coeficiente de flutuação de velocidade deve ser de 1 %. Determine a flutuação de energia, o momento de inércia do volante e a potência.
a-motor-of-0-6-kg-m-drives-a-machine-of-45-kg-m-through-a-gear-that-reduces-the-speed-by-9-with-an = Um motor de 0,6 kg·m² aciona uma máquina de 45 kg·m² por um redutor que divide a rotação por 9, com rendimento de 95 %. O torque da carga na máquina é de 100 N·m e o motor fornece 30 N·m. Determine a aceleração angular da máquina e o tempo em que ela atinge 60 rpm a partir do repouso.
a-connecting-rod-of-2-kg-is-250-mm-long-between-its-pins-its-centre-of-mass-is-100-mm-from-the = Uma biela de 2 kg tem 250 mm entre os pinos. Seu centro de massa está a 100 mm do pino do pistão, e o raio de giração em relação a ele é de 110 mm. Ela é substituída por duas partículas dinamicamente equivalentes, a primeira no pino do pistão. Determine a distância da segunda ao centro de massa e as duas massas. Se, em vez disso, forem usadas massas nos dois pinos, determine o momento que as corrige para uma aceleração angular de 23000 rad/s².
a-homogeneous-disc-of-3-kg-and-50-mm-radius-rolls-without-slipping-on-a-horizontal-plane-a-crank-of = Um disco homogêneo de 3 kg e 50 mm de raio rola sem deslizar sobre um plano horizontal. Uma manivela de 100 mm, cujo eixo está na altura do centro do disco, gira a 10 rad/s e aciona esse centro por uma biela leve de √2·100 mm. Com a manivela a 90° e sem outra força horizontal, determine o torque na manivela e o atrito no disco.
both-links-taken-at-the-same-angle-to-the-line-of-thrust = as duas barras tomadas com o mesmo ângulo em relação à linha de empuxo
the-formula-for-two-equal-links-q-p-2-tan-used = usada a fórmula de duas barras iguais, Q = P/(2 tan α)
half-of-the-knee-force-given-to-each-link = metade da força no joelho atribuída a cada barra
the-thrust-resolved-along-the-link = empuxo decomposto ao longo da barra
half-of-the-knee-force-taken-for-that-of-the-guide = tomada metade da força no joelho pela da guia
the-outer-radius-of-the-pinion-used = usado o raio externo do pinhão
the-torque-of-the-hand-on-the-handle-taken = tomado o torque da mão na alavanca
tan-and-tan-added = somadas tan α e tan φ
tan-subtracted-from-tan = subtraída tan α de tan φ
the-collar-taken-to-help-the-load-drive-the-screw = suposto que o colar ajuda a carga a mover o parafuso
the-whole-relative-displacement-of-the-ends-taken = tomado todo o deslocamento relativo das extremidades
the-load-taken-to-rest-on-the-inclined-cylinder-alone = carga suposta apoiada só no cilindro inclinado
the-formula-for-a-cylinder-between-the-feet-nw-tan-used = usada a fórmula de um cilindro entre os pés, nW/tan θ
the-vertical-component-of-the-speed-of-the-cylinder-taken = tomada a componente vertical da velocidade do cilindro
the-rise-of-the-hinge-taken-in-proportion-to-its-distance-from-a = subida da articulação tomada proporcional à sua distância de A
all-hinges-taken-to-rise-including-the-lower-ones = suposto que todas as articulações sobem, também as inferiores
the-load-taken-to-act-at-the-end-of-its-square = carga suposta aplicada no fim do seu quadrado
the-loads-shared-equally-by-the-two-supports = cargas repartidas igualmente entre os dois apoios
the-force-of-the-floor-on-a-foot-taken-along-the-ladder-as-in-a-two-force-member = força do piso no pé tomada ao longo da escada, como em barra de duas forças
the-sine-of-the-change-of-angle-used-in-place-of-the-change-of-the-sine = usado o seno da variação do ângulo em vez da variação do seno
the-cord-taken-as-perpendicular-to-the-bar = corda tomada como perpendicular à barra
the-cord-taken-as-vertical = corda tomada como vertical
the-weights-of-the-bars-above-counted-in-place-of-those-below = contados os pesos das barras acima em vez das abaixo
half-the-weight-of-each-bar-below-counted = contada só metade do peso de cada barra abaixo
the-offsets-of-the-masses-added-to-the-arms-as-on-a-plain-lever = afastamentos das massas somados aos braços, como em uma alavanca simples
the-moment-of-the-weight-taken-about-the-pivot-of-the-beams-not-about-its-stem = momento do peso tomado em relação ao pivô das barras, não à haste
the-ratios-of-the-links-added-not-multiplied = razões das ligações somadas, não multiplicadas
all-moments-balanced-as-on-one-lever-without-the-ratios-of-the-links = momentos equilibrados como em uma só alavanca, sem as razões das ligações
the-spring-taken-as-perpendicular-to-the-arm = mola tomada como perpendicular ao braço
the-ratio-of-sun-and-planet-used-in-place-of-that-of-sun-and-ring = usada a razão entre solar e planeta em vez da entre solar e coroa
the-compound-planet-taken-as-an-idler = planeta composto tomado como engrenagem intermediária
the-ratio-of-the-train-with-its-arm-fixed-used = usada a relação do trem com o braço fixo
the-absolute-speed-of-the-planet-taken-not-that-relative-to-the-arm = tomada a rotação absoluta do planeta, não a relativa ao braço
the-torque-on-the-pinion-shaft-taken-for-that-on-the-driving-member = torque no eixo do pinhão tomado como o do membro motor
the-rod-taken-as-a-uniform-bar-m-l-12 = biela tomada como barra uniforme, m l²/12
the-moment-of-inertia-of-the-rod-about-its-gudgeon-pin-used = usado o momento de inércia da biela em relação ao pino do pistão
the-rod-divided-in-proportion-to-the-lengths-of-the-two-pendulums = biela dividida na proporção dos comprimentos dos dois pêndulos
the-energy-of-the-difference-of-the-speeds-i-used = usada a energia da diferença das velocidades, ½ I (ω₁ − ω₂)²
the-given-speed-taken-as-the-maximum-speed = velocidade dada tomada como a máxima
the-largest-single-area-between-the-moment-and-the-load-taken = tomada só a maior área entre o momento e a carga
all-areas-above-the-load-added-up = somadas todas as áreas acima da carga
the-inertias-referred-to-the-motor-shaft = inércias referidas ao eixo do motor
the-motor-torque-times-the-ratio-taken-the-inertia-of-the-motor-neglected = tomado o torque do motor vezes a relação, desprezada a inércia do motor
the-power-on-the-driven-shaft-taken = tomada a potência no eixo movido
the-obliquity-of-the-rod-neglected = obliquidade da biela desprezada
the-moment-of-inertia-about-the-contact-point-used-together-with-the-translation = usado o momento de inércia no ponto de contato junto com a translação
the-normal-force-taken-as-the-weight-alone = força normal tomada só como o peso
the-obliquity-of-the-rod-neglected-the-arm-r-sin-used = obliquidade da biela desprezada, usado o braço r sen θ
the-obliquity-of-the-rod-neglected-r-cos-used = obliquidade da biela desprezada, usado r ω² cos θ
crank-and-rod-taken-as-perpendicular-at-the-maximum-velocity = manivela e biela tomadas como perpendiculares na velocidade máxima
the-speed-r-of-the-crank-pin-taken = tomada a velocidade r ω do pino da manivela
the-whole-mass-of-the-rod-counted-as-reciprocating = massa inteira da biela contada como alternativa
a-third-of-the-mass-of-the-rod-counted-as-reciprocating = um terço da massa da biela contado como alternativo
half-of-the-mass-of-the-rod-placed-at-each-pin = metade da massa da biela posta em cada pino
the-whole-rod-taken-to-move-with-the-piston = suposto que a biela inteira se move com o pistão
the-obliquity-of-the-rod-neglected-1-cos-2-used = obliquidade da biela desprezada, usado (1 − cos θ)/2
the-cam-angle-divided-by-the-whole-revolution = ângulo do came dividido pela volta inteira
the-distance-of-the-trace-point-from-the-cam-centre-taken = tomada a distância do ponto de referência ao centro do came
the-formula-of-a-flat-face-used = usada a fórmula do seguidor de face plana
the-distance-of-the-trace-point-from-the-cam-centre-used-as-the-arm = usada como braço a distância do ponto de referência ao centro do came
the-magnitudes-of-force-and-displacement-multiplied-without-the-angle-between-them = multiplicados os módulos da força e do deslocamento, sem o ângulo entre eles
the-whole-displacement-used-for-the-weight-not-its-vertical-part = usado o deslocamento inteiro para o peso, não sua parte vertical
the-moment-of-inertia-about-the-pin-used-together-with-the-inertia-force-at-the-centre-of-mass = usado o momento de inércia no pino junto com a força de inércia no centro de massa
the-angular-velocity-of-the-crank-used-not-that-of-the-line-of-sliding = usada a velocidade angular da manivela, não a da linha de deslizamento
the-whole-displacement-of-the-driving-pin-divided-by-the-length-of-the-link = deslocamento inteiro do pino motor dividido pelo comprimento do elo
the-normal-accelerations-r-of-the-two-links-omitted = omitidas as acelerações normais ω² r dos dois elos
the-displacement-of-the-driving-pin-taken-for-that-of-the-slider = deslocamento do pino motor tomado como o do cursor
the-approximate-formula-of-two-terms-used = usada a fórmula aproximada de dois termos
the-normal-acceleration-r-of-the-crank-pin-used = usada a aceleração normal r ω² do pino da manivela
the-angle-between-crank-and-rod-taken = tomado o ângulo entre manivela e biela
the-angle-between-crank-and-rocker-taken = tomado o ângulo entre manivela e balancim
the-angle-between-crank-and-coupler-taken = tomado o ângulo entre manivela e acoplador
the-amplitudes-of-both-torques-added-as-if-reached-at-one-angle = somadas as amplitudes dos dois torques, como se ocorressem no mesmo ângulo
the-whole-displacement-of-the-crank-pin-taken-along-the-cylinder = deslocamento inteiro do pino da manivela tomado ao longo do cilindro
the-whole-displacement-of-the-crank-pin-taken-across-the-cylinder = deslocamento inteiro do pino da manivela tomado transversal ao cilindro
the-whole-velocity-of-the-driving-pin-divided-by-the-length-of-the-link = velocidade inteira do pino motor dividida pelo comprimento do elo
the-magnitudes-of-force-and-velocity-multiplied-without-the-angle-between-them = multiplicados os módulos da força e da velocidade, sem o ângulo entre eles
the-whole-speed-used-for-the-weight-not-its-vertical-part = usada a velocidade inteira para o peso, não sua parte vertical
the-whole-speed-of-the-point-used-not-its-part-along-the-force = usada a velocidade inteira do ponto, não sua parte ao longo da força
the-stretch-and-its-arm-taken-as-at-small-angles = alongamento e braço tomados como em ângulos pequenos
the-length-of-the-pendulum-from-the-gudgeon-pin-taken = tomado o comprimento do pêndulo a partir do pino do pistão
the-force-in-a-link-p-2-sin-taken-for-the-thrust = tomada a força numa barra, P/(2 sen α), pelo empuxo
the-force-in-a-link-p-2-sin-taken-for-that-in-the-screw = tomada a força numa barra, P/(2 sen θ), pela do parafuso
the-pressure-angle-in-the-middle-of-the-stroke-taken = tomado o ângulo de pressão no meio do curso
the-length-of-the-rod-used-in-place-of-the-distance-between-the-masses = usado o comprimento da biela em vez da distância entre as massas
