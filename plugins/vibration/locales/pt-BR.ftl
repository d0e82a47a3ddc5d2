mass-on-beams-and-springs = Massa sobre vigas e molas
mass-damping-and-transmitted-force-of-a-mass-on-a-network-of-beams-and-springs-from-its-free-decay = Massa, amortecimento e força transmitida de uma massa sobre uma associação de vigas e molas, a partir do seu decaimento livre.
the-damped-frequency-is-below-the-natural-frequency = A frequência amortecida é menor que a frequência natural
mass-that-has-this-natural-frequency-on-the-springs = Massa que tem essa frequência natural sobre as molas
damping-coefficient = Coeficiente de amortecimento
stiffness-mass-and-damping-reproduce-the-frequency-of-the-free-vibration = rigidez, massa e amortecimento reproduzem a frequência da vibração livre
the-exponential-decay-reproduces-the-amplitude-ratio = o decaimento exponencial reproduz a razão das amplitudes
stiffness = Rigidez
equivalent-stiffness = Rigidez equivalente
logarithmic-decrement = Decremento logarítmico
damping-ratio = Fator de amortecimento
natural-frequency = Frequência natural
mass = Massa
damping = Amortecimento
frequency-ratio = Razão de frequências
without-damping-a-force-at-the-natural-frequency-makes-the-motion-grow-without-bound-there-is-no = sem amortecimento, uma força na frequência natural faz o movimento crescer sem limite: não há regime permanente
transmissibility-force-on-the-support-over-force-on-the-mass = Transmissibilidade: força no apoio sobre força na massa
transmissibility-from-the-dynamic-stiffness = transmissibilidade pela rigidez dinâmica
transmissibility = Transmissibilidade
steady-state-amplitude-under-the-force = Amplitude em regime permanente sob a força
amplitude-from-the-magnification-of-the-static-deflection = amplitude pela amplificação da deflexão estática
the-motion-lags-the-force-by = Ângulo de fase (atraso) do movimento em relação à força
amplitude-of-the-force-transmitted-to-the-support = Amplitude da força transmitida ao apoio
force-on-the-support-from-the-forces-of-springs-and-damper = força no apoio pelas forças das molas e do amortecedor
amplitude = Amplitude
steady-state-amplitude = Amplitude em regime permanente
phase-lag = Ângulo de fase (atraso)
force-transmitted-to-the-support = Força transmitida ao apoio
f-cos-t = F₀ cos ωt
the-mass-on-its-springs = A massa sobre as suas molas
free-vibration-from-an-initial-amplitude-of-one = Vibração livre a partir de uma amplitude inicial unitária
time = tempo
displacement-over-the-first-amplitude = deslocamento sobre a primeira amplitude
successive-amplitudes = amplitudes sucessivas
transmissibility-against-frequency = Transmissibilidade em função da frequência
frequency-of-the-force = Frequência da força
at-this-frequency = nesta frequência
applied-force-tr-1 = força aplicada (TR = 1)
springs = Molas
a-network-series-and-parallel-groups-may-be-nested = Uma associação: grupos em série e em paralelo podem ser aninhados.
frequency-of-the-free-vibration = Frequência da vibração livre
the-frequency-of-the-decaying-motion-as-counted-below-the-natural-frequency-if-there-is-damping = A frequência do movimento que decai, tal como contada; abaixo da frequência natural quando há amortecimento.
decay-of-the-free-vibration = Decaimento da vibração livre
excitation = Excitação
a-harmonic-force-on-the-mass = Uma força harmônica sobre a massa.
amplitude-of-the-force = Amplitude da força
the-transmissibility-is-independent-of-it = A transmissibilidade não depende dela.
successive-amplitudes-are-one-cycle-apart = Amplitudes sucessivas estão a um ciclo uma da outra
damping-ratio-from-that-decrement = Fator de amortecimento por esse decremento
the-damping-ratio-reproduces-the-decrement = o fator de amortecimento reproduz o decremento
ratio-of-the-first-amplitude-to-the-last = Razão entre a primeira amplitude e a última
n-1-stands-for-a-motion-that-does-not-decay = 1 indica um movimento que não decai.
counted-quantity = Grandeza contada
cycles-between-the-two-amplitudes = Ciclos entre as duas amplitudes
number-of-cycles = Número de ciclos
successive-amplitudes-including-both-ends = Amplitudes sucessivas, incluindo a primeira e a última
seven-successive-amplitudes-span-six-cycles = Sete amplitudes sucessivas abrangem seis ciclos.
number-of-amplitudes = Número de amplitudes
# equivalent-stiffness
along-a-line = Ao longo de uma reta
supported-body = Corpo sustentado
if-omitted-only-the-stiffness-is-found = Se for omitido, só a rigidez é determinada.
masses-of-the-springs-themselves = Massas das próprias molas
between-mass-and-weight = Entre massa e peso.
rotation-about-an-axis = Rotação em torno de um eixo
torsional-springs = Molas de torção
moment-of-inertia-of-the-shaft-about-its-axis = Momento de inércia do eixo em relação à sua linha de centro
one-third-of-it-rotates-with-the-body-omitted-for-a-light-shaft = Um terço dele gira com o corpo; omitido para um eixo leve.
along-a-line-spring-unknown = Ao longo de uma reta, mola desconhecida
the-stiffness-that-gives-a-mass-its-natural-frequency = A rigidez que dá a uma massa a sua frequência natural.
natural-frequency-required = Frequência natural exigida
for-the-static-deflection = Para a deflexão estática.
unknown-mass-natural-frequency-required = Massa desconhecida, frequência natural exigida
unknown-mass-static-deflection-known = Massa desconhecida, deflexão estática conhecida
mass-of-the-spring = Massa da mola
helical-spring-or-bar-1-3 = Mola helicoidal ou barra: 1/3
cantilever-load-at-its-tip-33-140 = Viga em balanço, carga na ponta: 33/140
simply-supported-beam-load-at-midspan-17-35 = Viga biapoiada, carga no meio do vão: 17/35
beam-clamped-at-both-ends-load-at-midspan-13-35 = Viga biengastada, carga no meio do vão: 13/35
given-fraction = Fração dada
effective-mass-fraction = Fração de massa efetiva
moment-of-inertia-known = Momento de inércia conhecido
unknown-natural-frequency-required = Desconhecido, frequência natural exigida
equivalent-spring-of-a-network-of-springs-beams-or-shafts-the-load-on-each-of-them-and-the-natural = Mola equivalente de uma associação de molas, vigas ou eixos, a carga em cada um e a frequência natural da massa sobre eles.
effective-mass-of-a-helical-spring-or-bar-one-third-of-its-mass-at-the-moving-end = Massa efetiva de uma mola helicoidal ou barra: um terço da sua massa, na extremidade móvel
effective-mass-of-a-cantilever-33-140-of-its-mass-at-the-tip = Massa efetiva de uma viga em balanço: 33/140 da sua massa, na ponta
effective-mass-of-a-simply-supported-beam-17-35-of-its-mass-at-midspan = Massa efetiva de uma viga biapoiada: 17/35 da sua massa, no meio do vão
effective-mass-of-a-beam-clamped-at-both-ends-13-35-of-its-mass-at-midspan = Massa efetiva de uma viga biengastada: 13/35 da sua massa, no meio do vão
effective-mass-of-the-spring-moving-with-the-load = Massa efetiva da mola, que se move com a carga
total-moving-mass-the-kinetic-energies-add-up = Massa móvel total: as energias cinéticas se somam
the-natural-frequency-of-the-springs-alone-is-below-the-required-one-write-a-lower-frequency-or = a frequência natural das molas sozinhas está abaixo da exigida: escreva uma frequência menor ou molas mais leves
remaining-mass-of-the-load-after-subtracting-the-effective-mass-of-the-springs = Massa restante da carga, descontada a massa efetiva das molas
mass-of-the-weight = Massa do peso
mass-whose-weight-causes-this-deflection = Massa cujo peso causa essa deflexão
weight-of-the-mass = Peso da massa
the-maximum-kinetic-energy-equals-the-maximum-elastic-energy = a energia cinética máxima é igual à energia elástica máxima
natural-frequency-from-the-static-deflection-g-m-m = frequência natural pela deflexão estática, ωₙ² = (g/δ) m/m'
mass-of-the-load = Massa da carga
weight-of-the-load = Peso da carga
natural-frequency-in-hertz = Frequência natural em hertz
equivalent-torsional-stiffness = Rigidez torcional equivalente
effective-inertia-of-the-shaft-one-third-at-the-moving-end = Inércia efetiva do eixo: um terço, na extremidade móvel
moment-of-inertia-that-has-this-natural-frequency-on-the-springs = Momento de inércia que tem essa frequência natural sobre as molas
the-natural-frequency-of-the-shaft-alone-is-below-the-required-one-write-a-lower-frequency-or-a = a frequência natural do eixo sozinho está abaixo da exigida: escreva uma frequência menor ou um eixo mais leve
remaining-inertia-of-the-body-after-subtracting-the-rotating-part-of-the-shaft = Inércia restante do corpo, descontada a parte do eixo que gira
total-rotating-moment-of-inertia-the-kinetic-energies-add-up = Momento de inércia girante total: as energias cinéticas se somam
moment-of-inertia-of-the-body = Momento de inércia do corpo
natural-frequency-from-the-static-deflection = frequência natural pela deflexão estática
stiffness-of-the-spring = Rigidez da mola
period-of-the-free-motion = Período da vibração livre
the-same-frequency-in-hz = A mesma frequência em Hz
natural-frequency-against-the-load = Frequência natural em função da carga
this-load = esta carga
the-springs-and-the-body-they-support = As molas e o corpo que sustentam
# inertia
moment-of-inertia-given = Momento de inércia dado
about-the-axis-of-rotation = Em relação ao eixo de rotação.
weight-times-the-square-of-the-radius-of-gyration = Peso vezes o quadrado do raio de giração
w-r-of-older-books-with-the-weight-as-a-force-lbf-ft = W R² de livros antigos, com o peso como força: lbf·ft².
moment-of-inertia-the-weight-over-gravity-is-the-mass = Momento de inércia: o peso sobre a gravidade é a massa
mass-and-radius-of-gyration = Massa e raio de giração
radius-of-gyration = Raio de giração
solid-disc = Disco maciço
ring = Anel
all-of-its-mass-at-one-radius = Toda a massa num só raio.
mean-diameter = Diâmetro médio
moment-of-inertia-of-a-ring-about-its-axis = Momento de inércia de um anel em relação ao seu eixo
moment-of-inertia-from-the-radius-of-gyration = Momento de inércia pelo raio de giração
moment-of-inertia-of-a-solid-disc-about-its-axis = Momento de inércia de um disco maciço em relação ao seu eixo
identification-from-a-frequency-response = Identificação por resposta em frequência
the-damping-ratio-is-above-0-1-the-textbook-method-peak-frequency-natural-frequency-is-in-error-by = o fator de amortecimento está acima de 0,1: o método dos livros, frequência do pico = frequência natural, erra mais de 1 % na frequência e 2 % na massa
at-rest-only-the-spring-balances-the-force-the-receptance-is-1-k = Em repouso só a mola equilibra a força: a receptância é 1/k
ratio-of-peak-height-to-static-value = Razão entre a altura do pico e o valor estático
the-peak-is-not-above-the-static-value-so-there-is-no-resonance-write-the-larger-receptance-as-the = o pico não está acima do valor estático, portanto não há ressonância: escreva a maior receptância como pico
the-peak-is-1-2-1-a-quadratic-equation-in-its-smaller-root = O pico é 1/(2ζ√(1 − ζ²)), uma equação do segundo grau em ζ²; a sua raiz menor
the-peak-lies-at-1-2-below-the-natural-frequency = O pico fica em ωₙ√(1 − 2ζ²), abaixo da frequência natural
mass-that-has-this-natural-frequency = Massa que tem essa frequência natural
mass-from-the-parabola-of-1-h-over-through-static-value-and-peak = massa pela parábola de 1/H² sobre ω² que passa pelo valor estático e pelo pico
damping-from-mass-stiffness-and-peak = amortecimento por massa, rigidez e pico
stiffness-mass-and-damping-reproduce-the-measured-receptance-at-the-peak = rigidez, massa e amortecimento reproduzem a receptância medida no pico
the-response-curve-has-zero-slope-at-the-peak-k-m-c-2m = a curva de resposta tem inclinação nula no pico: k = m ωₚ² + c²/(2m)
textbook-approximation-the-peak-frequency-taken-as-the-natural-frequency = Aproximação dos livros: a frequência de pico tomada como frequência natural
textbook-approximation-at-resonance-only-the-damper-balances-the-force = Aproximação dos livros: na ressonância só o amortecedor equilibra a força
error-of-the-textbook-estimate-of-the-mass = Erro da estimativa dos livros-texto para a massa
error-of-the-textbook-estimate-of-the-damping = Erro da estimativa dos livros-texto para o amortecimento
mass-peak-taken-as-natural-frequency = Massa, com o pico tomado como frequência natural
damping-peak-taken-as-natural-frequency = Amortecimento, com o pico tomado como frequência natural
error-of-that-mass = Erro dessa massa
error-of-that-damping-value = Erro desse valor de amortecimento
maximum-amplitude-per-newton-of-force = Amplitude máxima por newton de força
amplitude-at-resonance-per-unit-force = Amplitude na ressonância por unidade de força
maximum-amplitude-under-this-force = Amplitude máxima sob esta força
amplitude-at-the-natural-frequency-where-only-the-damper-balances-the-force = Amplitude na frequência natural, onde só o amortecedor equilibra a força
amplitude-at-the-natural-frequency-from-the-static-deflection-over-2 = amplitude na frequência natural pela deflexão estática sobre 2ζ
maximum-amplitude-under-the-force = Amplitude máxima sob a força
amplitude-at-the-natural-frequency = Amplitude na frequência natural
receptance-against-frequency = Receptância em função da frequência
frequency = Frequência
receptance = Receptância
identified = identificada
measured = medida
peak = pico
one-degree-of-freedom = Um grau de liberdade
one-degree-of-freedom-at-the-start = Um grau de liberdade, no início
three-methods-of-evaluating-the-response = Três métodos de avaliar a resposta
method = método
measurement = Medição
if-given-the-amplitude-at-resonance-is-also-computed-in-metres = Se for dada, a amplitude na ressonância também é calculada em metros.
static-value-and-peak = Valor estático e pico
static-receptance = Receptância estática
deflection-under-a-constant-force-over-that-force = Deflexão sob uma força constante, dividida por essa força.
receptance-at-the-peak = Receptância no pico
frequency-of-the-peak = Frequência do pico
table-of-the-frequency-response = Tabela da resposta em frequência
points = Pontos
in-any-order-at-least-five-with-the-peak-among-them-and-not-at-an-end = Em qualquer ordem; pelo menos cinco, com o pico entre eles e não numa extremidade.
the-table-has-fewer-than-five-points-measure-more-frequencies = a tabela tem menos de cinco pontos: meça mais frequências
the-largest-receptance-is-the-first-or-the-last-of-the-table-so-the-peak-was-not-measured-continue = a maior receptância é a primeira ou a última da tabela, portanto o pico não foi medido: meça além dela
least-squares = mínimos quadrados
peak-and-lowest-frequency = pico e menor frequência
peak-and-half-power-points = pico e pontos de meia potência
the-table-does-not-reach-down-to-1-2-of-the-peak-on-both-sides-there-is-no-half-power-reading = a tabela não desce até 1/√2 do pico dos dois lados: não há leitura de meia potência
the-points-are-higher-than-any-damping-allows-do-they-belong-to-one-mass-on-one-spring = os pontos são mais altos do que qualquer amortecimento permite: eles são de uma só massa sobre uma só mola?
no-stiffness-and-mass-fit-these-points-do-they-belong-to-one-mass-on-one-spring = nenhuma rigidez e massa se ajustam a estes pontos: eles são de uma só massa sobre uma só mola?
the-least-squares-fit-finds-no-damping-measure-more-points-about-the-peak = o ajuste por mínimos quadrados não encontra amortecimento: meça mais pontos em torno do pico
stiffness-by-least-squares-over-all-points-1-h-k-m-c-is-linear-in-k-c-2km-and-m = Rigidez por mínimos quadrados sobre todos os pontos: 1/H² = (k − m ω²)² + (c ω)² é linear em k², c² − 2km e m²
mass-by-the-same-least-squares = Massa pelos mesmos mínimos quadrados
damping-by-the-same-least-squares = Amortecimento pelos mesmos mínimos quadrados
viscous-damping-alone-the-least-squares-solution-satisfies-its-normal-equations = só amortecimento viscoso: a solução de mínimos quadrados satisfaz as suas equações normais
friction-alone-the-least-squares-solution-satisfies-its-normal-equations = só atrito: a solução de mínimos quadrados satisfaz as suas equações normais
both-together-the-least-squares-solution-satisfies-its-normal-equations = ambos juntos: a solução de mínimos quadrados satisfaz as suas equações normais
root-mean-square-of-the-relative-differences-between-the-fitted-receptance-and-the-measured-one = Valor quadrático médio das diferenças relativas entre a receptância ajustada e a medida
fit-residual-of-the-points = Resíduo do ajuste dos pontos
the-points-scatter-by-more-than-5-about-the-fit-noise-or-more-than-one-mode-in-this-range = os pontos dispersam-se mais de 5 % em torno do ajuste: ruído, ou mais de um modo nesta faixa
natural-frequency-without-damping = Frequência natural sem amortecimento
damping-ratio-damping-over-critical-damping = Fator de amortecimento: amortecimento sobre amortecimento crítico
the-fitted-damping-is-so-strong-that-the-response-has-no-peak = o amortecimento ajustado é tão forte que a resposta não tem pico
peak-of-the-fitted-response = Pico da resposta ajustada
its-height = A sua altura
the-measured-peak-vertex-of-the-parabola-of-1-h-over-through-the-highest-point-and-its-neighbours = O pico medido: vértice da parábola de 1/H² sobre ω² que passa pelo ponto mais alto e seus vizinhos
height-of-the-measured-peak = Altura do pico medido
lowest-frequency-of-the-table = Frequência mínima da tabela
receptance-at-this-point = Receptância nesse ponto
mass-from-peak-and-lowest-frequency-1-h-1-h-m-at-every-frequency = Massa pelo pico e pela menor frequência: 1/H² = 1/Hₕ² + m²(ω² − ωₕ²)² em toda frequência
half-power-frequency-below-the-peak-the-receptance-is-1-2-of-the-peak-value = Frequência de meia potência abaixo do pico: a receptância é 1/√2 do valor de pico
half-power-frequency-above-the-peak = Frequência de meia potência acima do pico
mass-from-the-half-power-frequencies-there-m-b-1-h-b = Massa pelas frequências de meia potência: nelas m²(ω² − ω_b²)² = 1/H_b²
frequency-of-the-peak-between-them = Frequência do pico entre elas
damping-ratio-from-the-half-power-frequencies-alone = fator de amortecimento só pelas frequências de meia potência
textbook-approximation-of-the-bandwidth-for-light-damping = Aproximação dos livros para a largura de banda, com amortecimento fraco
damping-ratio-half-power-points = Fator de amortecimento, pontos de meia potência
damping-ratio-bandwidth-over-twice-the-peak-frequency = Fator de amortecimento, largura de banda sobre o dobro da frequência do pico
stiffness-the-same-parabola-at-0-where-1-h-k = Rigidez: a mesma parábola em ω = 0, onde 1/H² = k²
damping-the-response-has-zero-slope-at-the-peak-c-2m-k-m = Amortecimento: a resposta tem tangente horizontal no pico, c² = 2m(k − m ω²)
difference-between-the-damping-ratio-readings = Diferença entre as leituras do fator de amortecimento
spread-of-the-damping-ratio = Dispersão do fator de amortecimento
the-readings-of-the-damping-ratio-differ-by-spread-the-points-about-the-peak-are-too-few-or-too-noisy = as leituras do fator de amortecimento diferem em { $spread }: os pontos em torno do pico são poucos ou ruidosos, ou não se trata de uma só massa sobre uma só mola
# mass-on-shaft
rotation-of-the-body = Rotação do corpo
for-the-torsional-frequency = Para a frequência torcional.
fixed-at-one-end-body-at-the-other = Fixo numa extremidade, corpo na outra
fixed-at-both-ends = Fixo nas duas extremidades
from-one-end-to-the-body = De uma extremidade ao corpo
from-the-body-to-the-other-end = Do corpo à outra extremidade
simply-supported = Biapoiado
free-to-turn-and-to-slide-only-the-transverse-frequency-exists = Livre para girar e deslizar: só existe a frequência transversal.
from-one-support-to-the-body = De um apoio ao corpo
from-the-body-to-the-other-support = Do corpo ao outro apoio
fixed-at-one-end-in-a-bearing-at-the-other = Fixo numa extremidade, em mancal na outra
the-bearing-allows-the-shaft-to-rotate-and-slide = O mancal permite que o eixo gire e deslize.
from-the-fixed-end-to-the-body = Da extremidade fixa ao corpo
from-the-body-to-the-bearing = Do corpo ao mancal
solid = Maciça
hollow = Oca
radius-of-gyration-of-the-body = Raio de giração do corpo
about-the-axis-of-the-shaft = Em relação à linha de centro do eixo.
mass-on-a-shaft = Massa sobre um eixo
longitudinal-transverse-and-torsional-natural-frequencies-of-a-mass-or-flywheel-on-a-light-shaft = Frequências naturais longitudinal, transversal e torcional de uma massa ou volante sobre um eixo leve.
transverse-maximum-kinetic-energy-maximum-elastic-energy-of-the-bending-moments = transversal: energia cinética máxima = energia elástica máxima dos momentos fletores
torsional-maximum-kinetic-energy-maximum-elastic-energy-of-the-parts-of-the-shaft = torcional: energia cinética máxima = energia elástica máxima dos trechos do eixo
longitudinal-maximum-kinetic-energy-maximum-elastic-energy-of-the-parts-of-the-shaft = longitudinal: energia cinética máxima = energia elástica máxima dos trechos do eixo
stiffness-along-the-shaft = Rigidez ao longo do eixo
stiffness-along-the-shaft-both-parts-have-the-same-deflection = Rigidez ao longo do eixo: as duas partes têm a mesma deflexão
longitudinal-natural-frequency = Frequência natural longitudinal
longitudinal-stiffness-from-the-elastic-energy-of-the-parts-of-the-shaft = rigidez longitudinal pela energia elástica das partes do eixo
longitudinal-stiffness = Rigidez longitudinal
longitudinal = longitudinal
longitudinal-frequency = Frequência longitudinal
transverse = transversal
torsional = torcional
a-simply-supported-shaft-can-rotate-freely-there-is-no-torsional-frequency = um eixo biapoiado gira livremente: não há frequência torcional
second-moment-of-area-of-the-section = Momento de inércia de área da seção
transverse-stiffness-at-the-tip-of-a-cantilever = Rigidez transversal na ponta de um eixo em balanço
transverse-stiffness-of-a-simply-supported-shaft-at-the-body = Rigidez transversal de um eixo biapoiado na posição do corpo
transverse-stiffness-at-the-body-of-a-shaft-fixed-at-both-ends = Rigidez transversal, na posição do corpo, de um eixo fixo nas duas extremidades
transverse-stiffness-at-the-body-of-a-shaft-fixed-at-one-end-and-in-a-bearing-at-the-other = Rigidez transversal, na posição do corpo, de um eixo fixo numa extremidade e em mancal na outra
transverse-natural-frequency = Frequência natural transversal
transverse-stiffness-from-the-elastic-energy-of-the-bending-moments = rigidez transversal pela energia elástica dos momentos fletores
transverse-stiffness = Rigidez transversal
transverse-frequency = Frequência transversal
polar-second-moment-of-area-of-the-section = Momento polar de inércia da seção
torsional-stiffness-both-parts-of-the-shaft-have-the-same-twist = Rigidez torcional: as duas partes do eixo têm a mesma torção
torsional-natural-frequency = Frequência natural torcional
torsional-stiffness-from-the-elastic-energy-of-the-parts-of-the-shaft = rigidez torcional pela energia elástica das partes do eixo
torsional-frequency = Frequência torcional
frequencies-of-the-body-on-the-shaft = Frequências do corpo sobre o eixo
per-minute = por minuto
the-body-on-the-shaft = O corpo sobre o eixo
rotating-unbalance = Desbalanceamento rotativo
steady-state-amplitude-phase-and-transmitted-force-of-an-unbalanced-machine-on-an-elastic-damped = Amplitude em regime permanente, fase e força transmitida de uma máquina desbalanceada sobre um apoio elástico e amortecido.
maximum-amplitude-as-a-multiple-of-m-e-m = Amplitude máxima como múltiplo de m₀e/m
the-largest-amplitude-is-not-above-m-e-m-so-no-damping-gives-a-peak-at-a-finite-speed = a maior amplitude não está acima de m₀e/m, portanto nenhum amortecimento dá um pico a uma rotação finita
its-larger-root-lies-above-1-2-where-the-response-has-no-peak-rejected = A raiz maior fica acima de 1/√2, onde a resposta não tem pico: rejeitada
substituting-reproduces-the-given-peak-amplitude = com esse ζ recupera-se a amplitude máxima dada
without-damping-the-amplitude-at-the-natural-frequency-grows-without-bound-there-is-no-steady-state = sem amortecimento, a amplitude na frequência natural cresce sem limite: não há regime permanente
steady-state-amplitude-at-the-running-speed = Amplitude em regime permanente na rotação de operação
the-motion-lags-the-unbalance-by = Ângulo de fase (atraso) do movimento em relação ao desbalanceamento
amplitude-of-the-force-transmitted-to-the-foundation = Amplitude da força transmitida à fundação
amplitude-from-the-dynamic-stiffness = amplitude pela rigidez dinâmica
transmitted-force-from-the-transmissibility-of-the-unbalance-force = força transmitida à fundação pela transmissibilidade da força de desbalanceamento
phase-lag-from-stiffness-mass-and-damping = atraso de fase por rigidez, massa e amortecimento
stiffness-of-the-support = Rigidez do apoio
amplitude-at-this-speed = Amplitude nesta rotação
force-transmitted-to-the-foundation = Força transmitida à fundação
speed-of-maximum-steady-state-amplitude = Rotação de máxima amplitude em regime permanente
peak-response-speed = Velocidade de pico (ressonância)
    .rotating-unbalance = Rotação de pico (ressonância)
maximum-steady-state-amplitude-at-any-speed = Amplitude máxima em regime permanente em qualquer rotação
maximum-amplitude-from-the-dynamic-stiffness-at-its-speed = amplitude máxima pela rigidez dinâmica na sua rotação
maximum-amplitude-at-any-speed = Amplitude máxima em qualquer rotação
the-machine-runs-within-5-of-its-natural-frequency-with-little-damping-small-errors-of-mass-stiffness = a máquina trabalha a menos de 5 % da sua frequência natural com pouco amortecimento: pequenos erros de massa, rigidez ou rotação mudam muito a amplitude
steady-state-amplitude-against-speed = Amplitude em regime permanente em função da rotação
at-this-speed = nesta rotação
    .base-excitation = nesta velocidade
the-machine-on-its-support = A máquina sobre o seu apoio
mass-of-the-machine = Massa da máquina
unbalance = Desbalanceamento
the-eccentric-mass-times-its-eccentricity = A massa excêntrica vezes a sua excentricidade.
support = Apoio
speed-of-the-machine = Rotação da máquina
damping-ratio-given = Fator de amortecimento dado
zero-for-no-damping = Zero para nenhum amortecimento.
damping-coefficient-given = Coeficiente de amortecimento dado
from-the-maximum-steady-state-amplitude-at-any-speed = Pela amplitude máxima em regime permanente em qualquer rotação
maximum-steady-state-amplitude = Amplitude máxima em regime permanente
from-a-free-decay = Por um decaimento livre
amplitudes = Amplitudes
second-moment-of-area-of-a-round-section = Momento de inércia de área de uma seção circular
the-inner-diameter-of-the-tube-is-not-below-the-outer-one-write-the-larger-one-as-the-outer = o diâmetro interno do tubo não é menor que o externo: escreva o maior como externo
second-moment-of-area-of-a-tube = Momento de inércia de área de um tubo
second-moment-of-area-of-a-rectangle = Momento de inércia de área de um retângulo
second-moment-of-area-given = Momento de inércia de área dado
second-moment-of-area = Momento de inércia de área
round = Circular
circular = Circular
diameter = Diâmetro
tube = Tubo
outer-diameter = Diâmetro externo
inner-diameter = Diâmetro interno
rectangle = Retângulo
width = Largura
perpendicular-to-the-plane-of-bending = Perpendicular ao plano de flexão.
height = Altura
in-the-plane-of-bending = No plano de flexão.
shaft-for-a-rotor-with-clearance = Eixo para um rotor com folga
distance-of-the-centre-of-mass-from-the-axis = Distância do centro de massa ao eixo de rotação
permitted-diameters = Diâmetros permitidos
maximum-stiffness-supercritical-operation = Rigidez máxima, operação supercrítica
maximum-diameter-supercritical-operation = Diâmetro máximo, operação supercrítica
minimum-stiffness-subcritical-operation = Rigidez mínima, operação subcrítica
minimum-diameter-subcritical-operation = Diâmetro mínimo, operação subcrítica
maximum-amplitude-of-any-shaft-at-any-speed = Amplitude máxima de qualquer eixo em qualquer rotação
the-lowest-speed-is-above-the-highest-one-write-the-smaller-speed-as-the-lowest = a menor rotação está acima da maior: escreva a rotação mais baixa como menor
minimum-speed-including-the-margin = Rotação mínima, com a margem
maximum-speed-including-the-margin = Rotação máxima, com a margem
these-numbers-do-not-describe-a-rotor-or-lead-to-values-outside-the-representable-range = estes números não descrevem um rotor, ou levam a valores fora da faixa representável
clearance-as-a-multiple-of-the-eccentricity = Folga como múltiplo da excentricidade
damping-ratio-for-which-the-peak-e-2-1-just-reaches-the-clearance = Fator de amortecimento para o qual o pico, e/(2ζ√(1 − ζ²)), atinge exatamente a folga
the-peak-with-that-damping-ratio-is-the-clearance = o pico com esse fator de amortecimento é igual à folga
minimum-damping-ratio-for-no-contact-with-any-shaft = Fator de amortecimento mínimo sem contato com nenhum eixo
maximum-amplitude-of-any-shaft-at-its-worst-case-speed-the-peak-does-not-depend-on-the-stiffness = Amplitude máxima de qualquer eixo, na sua rotação mais desfavorável: o pico não depende da rigidez
the-same-from-the-whirl-amplitude-at-the-frequency-ratio-of-the-peak = o mesmo pela amplitude de precessão na razão de frequências do pico
second-moment-of-area-from-k-3ei-l-of-a-cantilever = Momento de inércia de área, por k = 3EI/L³ de um eixo em balanço
second-moment-of-area-from-k-48ei-l-of-a-simply-supported-shaft = Momento de inércia de área, por k = 48EI/L³ de um eixo biapoiado
second-moment-of-area-from-k-192ei-l-of-a-shaft-clamped-at-both-ends = Momento de inércia de área, por k = 192EI/L³ de um eixo biengastado
second-moment-of-area-from-k-768ei-7l-of-a-clamped-and-pinned-shaft = Momento de inércia de área, por k = 768EI/(7L³) de um eixo engastado e apoiado
diameter-of-the-solid-circular-shaft-with-i-d-64 = Diâmetro do eixo circular maciço com I = πd⁴/64
the-shaft-of-that-diameter-has-the-limiting-stiffness = o eixo desse diâmetro tem a rigidez-limite
minimum-available-diameter = Diâmetro mínimo disponível
maximum-available-diameter = Diâmetro máximo disponível
the-clearance-is-reached-at-the-lowest-speed-speed = a folga é atingida na menor rotação, { $speed }
the-clearance-is-reached-at-the-highest-speed-speed = a folga é atingida na maior rotação, { $speed }
the-clearance-is-reached-at-the-peak-of-the-response-at-speed = a folga é atingida no pico da resposta, a { $speed }
the-clearance-is-not-a-constraint-with-this-damping-the-rotor-stays-clear-of-the-stator-at-every = a folga não é restritiva: com este amortecimento o rotor não toca o estator com nenhum diâmetro, portanto folga e rotações não determinam o diâmetro; resistência e mancais determinam
in-supercritical-operation-the-rotor-passes-its-critical-speed-before-reaching-the-lowest-speed-run = na operação supercrítica o rotor passa pela sua velocidade crítica antes de atingir a menor rotação: passe por ela rapidamente
no-available-diameter-keeps-the-rotor-clear-change-clearance-unbalance-damping-or-speeds = nenhum diâmetro disponível evita o contato: mude folga, desbalanceamento, amortecimento ou rotações
stator = estator
the-rotor-in-its-stator-clearance-and-diameter-drawn-wider = O rotor dentro do estator (folga e diâmetro desenhados maiores)
the-amplitude-with-that-stiffness-is-the-clearance = a amplitude com essa rigidez é a folga
same-limit-evaluated-over-the-whole-speed-range = mesmo limite avaliado em toda a faixa de rotações
supercritical-operation-m-e-m-k-r-worst-case-at-the-lowest-speed = Operação supercrítica, m₀eω²/(mω² − k) = R: o pior caso é a menor rotação
subcritical-operation-m-e-k-m-r-worst-case-at-the-highest-speed = Operação subcrítica, m₀eω²/(k − mω²) = R: o pior caso é a maior rotação
supercritical-operation-the-smaller-stiffness-for-which-the-amplitude-at-the-lowest-speed-equals-the = Operação supercrítica: a menor rigidez para a qual a amplitude na menor rotação é igual à folga
subcritical-operation-the-larger-stiffness-for-which-the-amplitude-at-the-highest-speed-equals-the = Operação subcrítica: a maior rigidez para a qual a amplitude na maior rotação é igual à folga
speed-of-maximum-amplitude = Rotação de amplitude máxima
amplitude-at-that-speed = Amplitude nessa rotação
supercritical-operation-the-largest-stiffness-with-k-m-c-m-e-r-at-every-speed-of-the-range = Operação supercrítica: a maior rigidez com (k − mω²)² + (cω)² ≥ (m₀eω²/R)² em toda rotação da faixa
subcritical-operation-the-smallest-stiffness-with-k-m-c-m-e-r-at-every-speed-of-the-range = Operação subcrítica: a menor rigidez com (k − mω²)² + (cω)² ≥ (m₀eω²/R)² em toda rotação da faixa
mass-of-the-rotor = Massa do rotor
mass-of-the-rotor-times-the-distance-of-its-centre-of-mass-from-the-axis = Massa do rotor vezes a distância do seu centro de massa ao eixo de rotação.
radial-clearance-between-rotor-and-stator = Folga radial entre rotor e estator
minimum-speed = Rotação mínima
maximum-speed = Rotação máxima
margin-on-the-speed-range = Margem sobre a faixa de rotações
taken-off-the-lowest-speed-and-added-to-the-highest = Tirada da menor rotação e somada à maior.
shaft = Eixo
diameter-to-be-checked = Diâmetro a verificar
undamped = Sem amortecimento
mounting = Montagem
length = Comprimento
of-the-overhang-where-the-rotor-is-at-its-end-of-the-span-otherwise = Do balanço, quando o rotor está na sua extremidade; do vão, nos outros casos.
young-s-modulus = Módulo de elasticidade
cantilever-rotor-at-its-end = Em balanço, rotor na extremidade
simply-supported-rotor-at-midspan = Biapoiado, rotor no meio do vão
clamped-at-both-ends-rotor-at-midspan = Biengastado, rotor no meio do vão
clamped-and-pinned-rotor-at-midspan = Engastado e apoiado, rotor no meio do vão
second-moment-of-area-of-the-shaft-to-be-checked = Momento de inércia de área do eixo a verificar
its-stiffness-at-the-rotor = A sua rigidez no rotor
its-critical-speed = A sua velocidade crítica
its-damping-coefficient = O seu coeficiente de amortecimento
its-worst-case-speed-the-lowest = A sua rotação mais desfavorável: a menor
its-worst-case-speed-the-highest = A sua rotação mais desfavorável: a maior
its-worst-case-speed-the-peak-of-the-response-within-the-range = A sua rotação mais desfavorável: o pico da resposta, dentro da faixa
its-maximum-amplitude = A sua amplitude máxima
maximum-amplitude-in-the-range-of-speeds-against-diameter = Amplitude máxima na faixa de rotações em função do diâmetro
clearance = folga
end-of-the-supercritical-range = fim da faixa supercrítica
start-of-the-subcritical-range = início da faixa subcrítica
permitted = permitido
springs-in-series-the-deflections-add-up = Molas em série: as deflexões somam-se
springs-in-parallel-the-forces-add-up = Molas em paralelo: as forças somam-se
stiffness-of-a-cantilever-under-a-force-at-its-end = Rigidez de uma viga em balanço com força na extremidade
midspan-stiffness-of-a-simply-supported-beam = Rigidez de uma viga biapoiada no meio do vão
stiffness-of-a-simply-supported-beam-at-the-load = Rigidez de uma viga biapoiada no ponto da carga
midspan-stiffness-of-a-beam-clamped-at-both-ends = Rigidez no meio do vão de uma viga biengastada
stiffness-at-the-load-of-a-beam-clamped-at-both-ends = Rigidez no ponto da carga de uma viga biengastada
midspan-stiffness-of-a-beam-clamped-at-one-end-and-pinned-at-the-other = Rigidez no meio do vão de uma viga engastada e apoiada
stiffness-at-the-load-of-a-beam-clamped-at-one-end-and-pinned-at-the-other = Rigidez no ponto da carga de uma viga engastada e apoiada
stiffness-of-a-beam-at-the-end-of-its-overhang = Rigidez de uma viga na ponta do seu balanço
stiffness-of-a-fixed-guided-column = Rigidez de uma coluna engastada–guiada
axial-stiffness-of-a-bar = Rigidez axial de uma barra
polar-second-moment-of-area-of-a-round-section = Momento polar de inércia de uma seção circular
torsional-stiffness-of-the-bar = Rigidez torcional da barra
stiffness-at-the-end-of-the-lever = Rigidez na ponta da alavanca
stiffness-of-a-helical-spring = Rigidez de uma mola helicoidal
the-load-acts-at-or-beyond-the-far-support-of-its-beam-write-a-distance-smaller-than-the-span = a carga atua no apoio mais distante da viga ou além dele: escreva uma distância menor que o vão
spring = Mola
cantilever = Viga em balanço
simply-supported-beam = Viga biapoiada
clamped-beam = viga biengastada
clamped-and-pinned-beam = viga engastada e apoiada
overhang = Balanço
column = coluna
bar = barra
torsion-bar = barra de torção
helical-spring = Mola helicoidal
in-series = em série
in-parallel = em paralelo
stiffness-given = Rigidez dada
from-the-clamp-to-the-load-the-part-beyond-the-load-does-not-bend = Do engaste até a carga; a parte além da carga não se flexiona.
section = Seção
span = Vão
distance-of-the-load-from-a-support = Distância da carga a um apoio
the-load-is-at-midspan-if-this-is-omitted = A carga está no meio do vão se isto for omitido.
beam-clamped-at-both-ends = Viga biengastada
distance-of-the-load-from-a-clamp = Distância da carga a um engaste
beam-clamped-at-one-end-and-pinned-at-the-other = Viga engastada numa extremidade e apoiada na outra
distance-of-the-load-from-the-clamp = Distância da carga ao engaste
overhang-of-a-simply-supported-beam = Balanço de uma viga biapoiada
span-between-the-supports = Vão entre os apoios
from-the-nearer-support-to-the-load = Do apoio mais próximo até a carga.
fixed-guided-column = Coluna engastada–guiada
bar-in-tension = Barra tracionada
area-of-the-section = Área da seção
shear-modulus = Módulo de elasticidade transversal
lever = Alavanca
from-the-axis-of-the-bar-to-the-load-small-angles = Do eixo da barra até a carga; ângulos pequenos.
diameter-of-the-wire = Diâmetro do arame
mean-diameter-of-the-coils = Diâmetro médio das espiras
active-coils = Espiras ativas
series-end-to-end = Série: uma após a outra
every-member-carries-the-whole-force = Cada membro leva toda a força.
members = Membros
parallel-side-by-side = Paralelo: lado a lado
all-members-have-the-same-deflection = Todos os membros têm a mesma deflexão.
the-energy-in-the-members-is-the-energy-in-the-equivalent-spring = a energia nos membros é a energia na mola equivalente
fraction-of-the-deflection-in-series-the-force-is-the-same = Fração da deflexão: em série a força é a mesma
fraction-of-the-force-in-parallel-the-deflection-is-the-same = Fração da força: em paralelo a deflexão é a mesma
the-deflections-of-the-members-in-series-add-up = as deflexões dos membros em série somam-se
the-forces-of-the-members-in-parallel-add-up = as forças dos membros em paralelo somam-se
kind = Tipo
share-of-the-force = parcela da força
share-of-the-deflection = parcela da deflexão
amplitude-of-the-deflection = amplitude da deflexão
force-in-each-spring = Força em cada mola
beam = viga
# base-excitation
inertia = Inércia
may-be-omitted-if-the-natural-frequency-or-the-static-deflection-is-known-the-forces-are-then-not = Pode ser omitida quando se conhece a frequência natural ou a deflexão estática; nesse caso as forças não são calculadas.
base = Base
start-from-rest = Partida do repouso
the-base-motion-starts-as-a-sine-the-mass-is-at-rest-until-then = O movimento da base começa como um seno; até então a massa está em repouso.
displacement-given = Deslocamento dado
amplitude-of-the-base = Amplitude da base
frequency-of-the-base = Frequência da base
acceleration-given = Aceleração dada
acceleration-of-the-base = Aceleração da base
base-acceleration = Aceleração da base
its-amplitude-zero-to-peak = A sua amplitude, de zero a pico.
vehicle-on-a-wavy-road = Veículo em estrada ondulada
amplitude-of-the-road = Amplitude da estrada
half-the-height-from-trough-to-crest = Metade da altura do vale à crista.
wavelength = Comprimento de onda
from-crest-to-crest = De crista a crista.
speed-of-the-vehicle = Velocidade do veículo
from-the-start-of-the-base-motion = Contado do início do movimento da base.
base-excitation = Excitação pela base
at-the-critical-speed-the-time-from-wave-to-wave-is-the-natural-period = na velocidade crítica o tempo de onda a onda é o período natural
at-this-speed-the-slope-of-the-transmissibility-is-zero-2-r-r-1 = nesta velocidade a inclinação da transmissibilidade é zero, 2ζ²r⁴ + r² = 1
absolute-and-relative-motion-acceleration-and-force-of-a-mass-under-harmonic-base-excitation = Movimento absoluto e relativo, aceleração e força de uma massa sob excitação harmônica pela base, inclusive uma estrada ondulada.
the-amplitude-is-unbounded-it-grows-with-t-per-second-by = A amplitude é ilimitada: cresce com t, a cada segundo de
growth-rate-of-the-amplitude-at-the-base-frequency = taxa de crescimento da amplitude na frequência da base
growth-of-the-amplitude-with-time = Crescimento da amplitude com o tempo
undamped-resonance-the-amplitude-is-unbounded-it-grows-with-t-and-there-is-no-steady-state = ressonância sem amortecimento: a amplitude é ilimitada, cresce com t e não há regime permanente
displacement = deslocamento
displacement-of-the-mass-at-that-time = Deslocamento da massa nesse instante
motion-of-the-mass-from-rest = Movimento da massa a partir do repouso
relative-motion-against-frequency-ratio = Movimento relativo em função da razão de frequências
relative-motion-over-motion-of-the-base = movimento relativo sobre movimento da base
amplitude-of-the-base-with-this-acceleration = Amplitude da base com essa aceleração
frequency-one-road-wave-per-wavelength-travelled = Frequência: uma onda da estrada a cada comprimento de onda percorrido
critical-speed-the-road-waves-excite-at-the-natural-frequency = Velocidade crítica: as ondas da estrada excitam na frequência natural
critical-speed = Velocidade crítica
frequency-ratio-at-maximum-transmissibility = Razão de frequências na transmissibilidade máxima
largest-transmissibility = Maior transmissibilidade
maximum-transmissibility = Transmissibilidade máxima
at-its-peak-the-transmissibility-is-1-1-r = no pico a transmissibilidade vale 1/√(1 − r⁴)
maximum-transmissibility-at-any-speed = Transmissibilidade máxima em qualquer velocidade
transmissibility-motion-of-the-mass-over-motion-of-the-base = Transmissibilidade: movimento da massa sobre movimento da base
amplitude-of-the-mass = Amplitude da massa
the-mass-lags-the-base-by = Ângulo de fase (atraso) da massa em relação à base
amplitude-of-the-motion-relative-to-the-base-travel-of-the-springs = Amplitude do movimento relativo à base: curso das molas
the-relative-motion-lags-the-base-by = Ângulo de fase (atraso) do movimento relativo em relação à base
acceleration-of-the-mass = Aceleração da massa
motion-of-the-mass-motion-of-the-base-and-relative-motion-in-phase-with-the-base = movimento da massa = movimento da base e movimento relativo, em fase com a base
the-same-in-quadrature-90-behind = o mesmo em quadratura (90° atrás)
phase-lag-of-the-mass = Ângulo de fase (atraso) da massa
amplitude-of-the-relative-motion = Amplitude do movimento relativo
phase-lag-of-the-relative-motion = Ângulo de fase (atraso) do movimento relativo
amplitude-of-the-force-in-spring-and-damper-it-accelerates-the-mass = Amplitude da força na mola e no amortecedor: é ela que acelera a massa
force-from-the-relative-motion = força pelo movimento relativo
force-on-the-mass = Força na massa
amplitude-against-speed = Amplitude em função da velocidade
the-mass-on-its-base = A massa sobre a sua base
the-barrel-on-its-recoil-spring-distances-not-to-scale = O cano na sua mola de recuo (distâncias fora de escala)
the-rotor-and-its-pendulum-r-is-not-to-scale = O rotor e o seu pêndulo (r fora de escala)
the-crankshaft-from-the-free-end = O virabrequim a partir da extremidade livre
the-system-equal-masses-and-springs = O sistema: massas e molas iguais
the-body-from-above = O corpo visto de cima
the-body-between-its-ends = O corpo entre as suas extremidades
the-blade-on-its-hub-and-its-section = A pá no seu cubo, e a sua seção
the-spans-and-their-supports = Os vãos e os seus apoios
the-beam-and-its-section = A viga e a sua seção
the-beam-on-its-moving-supports = A viga sobre apoios móveis
the-chain-as-a-building-on-its-moving-base = A cadeia como um edifício sobre a base móvel
the-disc-on-its-shaft = O disco no seu eixo
the-pendulum = O pêndulo
the-mass-and-its-springs-y-is-not-to-scale = A massa e as suas molas (y fora de escala)
the-mass-on-its-nonlinear-spring = A massa na sua mola não linear
the-vehicle-on-its-wavy-road-not-to-scale = O veículo na estrada ondulada (fora de escala)
# harmonic-force
the-displacement-at-a-time-after-the-force-is-applied = O deslocamento num instante após a aplicação da força.
force-given = Força dada
amplitude-of-the-motion-given-force-unknown = Amplitude do movimento dada, força desconhecida
amplitude-of-the-motion = Amplitude do movimento
zero-to-peak-unless-the-unit-specifies-otherwise = De zero a pico, salvo se a unidade indicar outra coisa.
mean-power-given-force-sought = Potência média dada, força procurada
mean-power = Potência média
from-the-start-of-the-force = Contado do início da força.
work-of-the-force-in-a-cycle-energy-dissipated-by-the-damper-f-x-sin = trabalho da força em um ciclo = energia dissipada pelo amortecedor, πF₀X sen φ
maximum-acceleration-zero-slope-with-respect-to-frequency-1-2 = aceleração máxima: inclinação nula em relação à frequência, (ωₙ/ω)² = 1 − 2ζ²
deflection-under-a-constant-force-f = Deflexão sob uma força constante F₀
the-motion-from-rest-represents-hysteretic-damping-by-a-viscous-damper-with-the-same-energy-loss-per = o movimento a partir do repouso representa o amortecimento histerético por um amortecedor viscoso com a mesma perda de energia por ciclo nesta frequência
displacement-at-that-time = Deslocamento nesse instante
motion-from-rest = Movimento a partir do repouso
magnification-of-the-static-deflection = Amplificação da deflexão estática
magnification = Amplificação
magnification-factor = Fator de amplificação
force-required-for-this-amplitude = Força necessária para essa amplitude
without-damping-the-steady-state-motion-requires-no-power-write-some-damping-or-give-the-force = sem amortecimento o regime permanente não consome potência: escreva algum amortecimento ou dê a força
amplitude-from-the-power-p-c-x-dissipated-by-the-damper = Amplitude, pela potência P = ½ c ω² X² dissipada no amortecedor
amplitude-of-the-velocity = Amplitude da velocidade
amplitude-of-the-acceleration = Amplitude da aceleração
force-in-the-spring = Força na mola
force-in-the-damper = Força no amortecedor
spring-damper-and-inertia-forces-close-the-force-polygon = as forças da mola, do amortecedor e de inércia fecham o polígono de forças
transmitted-force-from-the-transmissibility = força transmitida à fundação pela transmissibilidade
energy-dissipated-by-the-damper-per-cycle = Energia dissipada pelo amortecedor por ciclo
mean-power-that-energy-2-times-per-second = Potência média: essa energia, ω/2π vezes por segundo
mean-power-from-force-velocity-and-the-angle-between-them = potência média por força, velocidade e o ângulo entre elas
energy-lost-per-cycle = Energia dissipada por ciclo
with-a-damping-ratio-of-1-2-or-more-the-displacement-has-no-peak-it-is-largest-at-low-frequencies = com fator de amortecimento de 1/√2 ou mais o deslocamento não tem pico: é máximo nas baixas frequências
frequency-of-maximum-displacement-the-velocity-is-maximum-at = Frequência do deslocamento máximo; a velocidade é máxima em ωₙ
frequency-of-maximum-acceleration = Frequência da aceleração máxima
maximum-amplitude-at-any-frequency = Amplitude máxima em qualquer frequência
maximum-amplitude-from-the-dynamic-stiffness-at-its-frequency = amplitude máxima pela rigidez dinâmica na sua frequência
frequency-of-maximum-displacement = Frequência do deslocamento máximo
maximum-amplitude-at-where-only-the-loss-of-the-spring-balances-the-force = Amplitude máxima, em ωₙ, onde só a perda da mola equilibra a força
without-damping-no-force-is-needed-to-keep-a-motion-at-the-natural-frequency-and-any-force-makes-it = sem amortecimento nenhuma força é necessária para manter um movimento na frequência natural, e qualquer força o faz crescer sem limite: dê a força
growth-rate-from-the-impulse-of-the-force = taxa de crescimento pelo impulso da força
amplitude-of-the-angular-acceleration = Amplitude da aceleração angular
amplitude-of-the-angular-velocity = Amplitude da velocidade angular
amplitude-of-the-rotation = Amplitude da rotação
amplitude-of-the-rotation-given-torque-unknown = Amplitude da rotação dada, torque desconhecido
amplitude-of-the-torque-transmitted-to-the-foundation = Amplitude do torque transmitido à fundação
amplitude-from-the-power-p-c-t-dissipated-by-the-damper = Amplitude, pela potência P = ½ c_t ω² Θ² dissipada pelo amortecedor
angle-at-that-time = Ângulo nesse instante
angle-of-twist-under-a-constant-torque-t = Ângulo de torção sob um torque constante T₀
for-a-rotation = Para uma rotação.
harmonic-force-or-torque = Força ou torque harmônico
one-degree-of-freedom-in-rotation = Um grau de liberdade em rotação
rotating-vectors-of-the-torques = Vetores girantes dos torques
rotation-moment-of-inertia = Rotação: momento de inércia
springs-damping-and-excitation-are-then-torsional = Molas, amortecimento e excitação são então torcionais.
steady-state-amplitude-phase-forces-and-power-of-one-mass-under-a-harmonic-force-or-of-a-rotating = Amplitude em regime permanente, fase, forças e potência de uma massa sob uma força harmônica, ou de um corpo em rotação sob um torque harmônico, e o seu movimento a partir do repouso.
the-motion-lags-the-torque-by = Ângulo de fase (atraso) do movimento em relação ao torque
torque-given = Torque dado
torque-in-the-damper = Torque no amortecedor
torque-in-the-spring = Torque na mola
torque-required-for-this-amplitude = Torque necessário para esta amplitude
torque-transmitted-to-the-foundation = Torque transmitido à fundação
torsional-damping-coefficient-given = Coeficiente de amortecimento torcional dado
torsional-springs-and-shafts = Molas de torção e eixos
torsional-stiffness-that-gives-the-moment-of-inertia-this-natural-frequency = Rigidez torcional que dá ao momento de inércia esta frequência natural
a-mass-moves-along-a-line-give-its-springs-its-damping-coefficient-and-its-excitation-for-a = uma massa move-se em linha reta: dê as molas, o coeficiente de amortecimento e a excitação de uma translação, ou escolha a rotação como inércia
a-moment-of-inertia-rotates-give-torsional-springs-or-the-natural-frequency-the-torsional-damping = um momento de inércia gira: dê molas de torção ou a frequência natural, o coeficiente de amortecimento torcional ou o fator de amortecimento, e um torque ou um ângulo
angle = Ângulo
growth-rate-from-the-impulse-of-the-torque = taxa de crescimento pelo impulso do torque
mean-power-from-torque-angular-velocity-and-the-angle-between-them = potência média por torque, velocidade angular e o ângulo entre eles
torques-of-spring-damper-and-inertia-close-the-polygon-of-torques = os torques de mola, amortecedor e inércia fecham o polígono dos torques
transmitted-torque-from-the-transmissibility = torque transmitido pela transmissibilidade
without-damping-no-torque-is-needed-to-keep-a-rotation-at-the-natural-frequency-and-any-torque-makes = sem amortecimento nenhum torque é necessário para manter uma rotação na frequência natural, e qualquer torque a faz crescer sem limite: dê o torque
work-of-the-torque-in-a-cycle-energy-dissipated-by-the-damper-t-sin = trabalho do torque em um ciclo = energia dissipada pelo amortecedor, πT₀Θ sen φ
# harmonic-sum
phase = Fase
find = Determinar
sum-of-harmonic-motions = Soma de movimentos harmônicos
written-as = Escritos como
motions = Movimentos
at-which-the-displacement-is-requested = Em que se pede o deslocamento.
work-of-a-harmonic-force-on-a-harmonic-motion = Trabalho de uma força harmônica num movimento harmônico
the-force-is-f-sin-t = A força é F₀ sen ωt.
phase-lag-of-the-motion = Ângulo de fase (atraso) do movimento
the-motion-is-x-sin-t = O movimento é X sen (ωt − φ).
from-the-beginning-of-the-force = Contado do início da força.
the-phase-added-to-t-positive-for-a-leading-motion = A fase somada a ωt: positiva para um movimento adiantado.
superposition-of-harmonic-motions = Superposição de movimentos harmônicos
phasor-sum-of-harmonic-motions-beats-of-two-with-nearly-equal-frequencies-and-the-work-of-a-harmonic = Soma de movimentos harmônicos por fasores, batimento de dois com frequências próximas, e o trabalho de uma força harmônica num movimento harmônico.
amplitude-of-the-sum = Amplitude da soma
phase-of-the-sum = Fase da soma
the-displacement-never-exceeds-the-sum-of-the-amplitudes = O deslocamento nunca passa da soma das amplitudes
upper-bound-of-the-displacement = Limite superior do deslocamento
root-mean-square-over-a-long-time = Valor eficaz num tempo longo
root-mean-square = Valor eficaz
sum-of-the-individual-motions-at-that-time = soma dos movimentos individuais nesse instante
mean-square-from-the-products-of-all-pairs = valor quadrático médio pelos produtos de todos os pares
rotating-vectors-of-the-same-frequency-keep-their-relative-angles-their-components-add-up = Os vetores girantes de mesma frequência mantêm os seus ângulos relativos: as suas componentes se somam
transverse-components = Componentes transversais
length-of-the-resulting-vector = Comprimento do vetor resultante
its-angle = O seu ângulo
maximum-amplitude-when-the-two-motions-are-in-phase = Amplitude máxima, quando os dois movimentos estão em fase
minimum-amplitude-when-they-are-in-opposite-phase = Amplitude mínima, quando eles estão em oposição de fase
beat-frequency-rate-at-which-the-faster-vector-overtakes-the-slower-one = Frequência do batimento: taxa com que o vetor mais rápido ultrapassa o mais lento
time-between-two-maxima-of-the-amplitude = Tempo entre dois máximos da amplitude
frequency-of-the-oscillation-within-the-beats = Frequência da oscilação dentro dos batimentos
maximum-and-minimum-amplitude-give-the-mean-square-of-the-envelope = as amplitudes máxima e mínima dão o valor quadrático médio da envoltória
largest-amplitude = Maior amplitude
maximum-amplitude = Amplitude máxima
least-amplitude = Menor amplitude
minimum-amplitude = Amplitude mínima
beat-frequency = Frequência do batimento
beat-period = Período do batimento
mean-frequency = Frequência média
the-frequencies-are-so-far-apart-that-the-sum-shows-no-beats-the-fast-motion-is-superposed-on-the = as frequências são tão distantes que a soma não mostra batimento: o movimento rápido se superpõe ao lento
envelope = envoltória
sum-against-time = Soma em função do tempo
rotating-vectors-at-the-start = Vetores girantes no início
work-up-to-that-time-the-integral-of-f-sin-t-x-cos-t = Trabalho até esse instante: a integral de F₀ sen ωt · Xω cos (ωt − φ)
work-per-cycle-only-the-component-of-the-force-in-phase-with-the-velocity-does-work = Trabalho por ciclo: só a componente da força em fase com a velocidade realiza trabalho
mean-power-that-work-2-times-per-second = Potência média: esse trabalho, ω/2π vezes por segundo
maximum-instantaneous-power-it-oscillates-about-the-mean-with-amplitude-f-x-2 = Potência instantânea máxima: ela oscila em torno da média com amplitude F₀Xω/2
work-by-numerical-integration = trabalho por integração numérica
work-up-to-that-time = Trabalho até esse instante
work-of-a-cycle = Trabalho de um ciclo
work-per-cycle = Trabalho por ciclo
largest-power = Maior potência
maximum-power = Potência máxima
power-against-time = Potência em função do tempo
force-against-displacement = Força em função do deslocamento
# modal-analysis, frequency-response-matrix, multi-degree-response, bar-on-two-springs, coupled-pendulums, half-car
k-m-i-c-x-f-at-frequency-place-coordinate-at-the-part-in-phase-with-cos-t = (K − ω²M + iωC) X = F na frequência { $place }, coordenada { $at }: a parte em fase com cos ωt
a-damping-ratio-for-each-mode = Um fator de amortecimento para cada modo
a-taut-string-resists-a-small-transverse-offset-between-its-ends-with-t-l = Uma corda tracionada resiste a um pequeno desnível transversal entre as suas extremidades com T/l
about-its-centre-of-mass = Em relação ao seu centro de massa.
acceleration-accelerance-for-1-n = Aceleração (acelerância para 1 N)
all-at-the-same-frequency-a-single-force-of-1-n-gives-a-column-of-the-frequency-response-matrix = Todas de mesma frequência. Uma única força de 1 N dá uma coluna da matriz de resposta em frequência.
amplitudes-of-the-damped-mode = Amplitudes do modo amortecido
at-which-the-motion-is-requested = Nos quais se pede o movimento.
at-which-the-response-is-requested = Nas quais se pede a resposta.
bar-on-two-springs = Barra sobre duas molas
mode-shape-body-front-body-rear-wheel-front-wheel-rear = Forma modal: carroceria dianteira, carroceria traseira, roda dianteira, roda traseira
bounce-pitch-and-wheel-hop-of-a-vehicle-seen-from-the-side-natural-frequencies-modes-and-damping = Salto vertical, arfagem e vibração das rodas de um veículo visto de lado: frequências naturais, modos e fatores de amortecimento de quatro graus de liberdade.
equal-masses-springs-and-dampers-in-a-chain = Cadeia de massas, molas e amortecedores iguais
number-of-masses = Número de massas
mass-of-each = Massa de cada uma
damping-coefficient-of-each-damper = Coeficiente de amortecimento de cada amortecedor
ends = Extremidades
springs-to-a-wall-at-both-ends = Molas à parede em ambas as extremidades
spring-to-a-wall-before-the-first-mass-last-mass-free = Mola à parede antes da primeira massa, última massa livre
both-ends-free = Ambas as extremidades livres
chain-of-masses-springs-and-dampers = Cadeia de massas, molas e amortecedores
coordinate = Coordenada
coordinates-that-are-not-listed-start-from-rest = As coordenadas que não constam partem do repouso.
coupled-pendulums = Pêndulos acoplados
coupling-of-the-two-coordinates = Acoplamento das duas coordenadas
time-history = Evolução no tempo
damped-frequency = Frequência amortecida
damper-to-the-ground = Amortecedor ao solo
damper-to-the-previous-mass = Amortecedor à massa anterior
damper-to-the-wall-on-the-right = Amortecedor à parede da direita
damping-matrix-c = Matriz de amortecimento C
damping-of-the-mode-c-m-c-does-not-couple-the-modes-so-the-mode-shapes-are-unchanged = Amortecimento do modo φᵀCφ/φᵀMφ: C não acopla os modos, de modo que as formas modais não mudam
damping-of-the-suspension = Amortecimento da suspensão
damping-ratio-at-the-first-frequency = Fator de amortecimento na primeira frequência
damping-ratio-at-the-second-frequency = Fator de amortecimento na segunda frequência
damping-ratio-of-the-damped-mode = Fator de amortecimento do modo amortecido
damping-ratio-of-the-mode = Fator de amortecimento do modo
damping-ratios = Fatores de amortecimento
displacement-receptance-for-1-n = Deslocamento (receptância para 1 N)
displacement-of-coordinate-at-at-time-place-modal-responses-from-breakpoint-to-breakpoint-of-the = Deslocamento da coordenada { $at } no instante { $place }: respostas modais entre pontos de quebra das forças, cada uma em forma fechada
distance-from-the-centre-of-mass-of-the-body = Distância ao centro de massa da carroceria
distance-of-the-spring-from-the-pivot = Distância da mola à articulação
time-span-of-the-plots = Intervalo de tempo dos gráficos
effective-mass = Massa efetiva
effective-mass-the-part-of-the-total-mass-that-moves-with-the-ground-in-this-mode = Massa efetiva: a parte da massa total que acompanha o solo neste modo
eigenvalue-root-of-det-k-m-0-found-numerically = Autovalor, λ = ω²: raiz de det(K − λM) = 0, encontrada numericamente
matrix-entries = Elementos das matrizes
stiffness-matrix-entry-force-on-the-mass-for-its-own-unit-displacement = Elemento da matriz de rigidez: força na massa para o seu próprio deslocamento unitário
excitation-by-uniform-motion-of-the-ground-at-all-springs-m1 = Excitação por movimento uniforme do solo em todas as molas: φᵀM1
first = primeira
first-component-is-1 = Primeira componente igual a 1
first-frequency = Primeira frequência
first-pendulum = Primeiro pêndulo
first-row-of-k-m-0-the-second-amplitude-over-the-first = Primeira linha de (K − λM) φ = 0: a segunda amplitude sobre a primeira
force-at-its-end = Força no fim
force-on-the-bar-for-a-unit-displacement-of-its-centre-of-mass = Força na barra para um deslocamento unitário do seu centro de massa
frequencies = Frequências
frequency-of-the-beats = Frequência dos batimentos
frequency-response-of-multi-degree-of-freedom-systems = Resposta em frequência de sistemas com vários graus de liberdade
from-left-to-right-each-with-the-length-of-string-before-it = Da esquerda para a direita, cada uma com o comprimento de corda que a antecede.
from-left-to-right-the-spring-and-the-damper-of-a-mass-connect-it-to-the-previous-mass-those-of-the = Da esquerda para a direita. A mola e o amortecedor de uma massa a ligam à massa anterior; os da primeira massa, à parede da esquerda.
from-the-first-of-the-two-points = Do primeiro dos dois pontos
from-the-table-of-the-matrices = Da tabela das matrizes
front-axle = Eixo dianteiro
front-spring = Mola dianteira
front-spring-ahead-of-the-centre-of-mass = Mola dianteira à frente do centro de massa
gravity-along-the-pendulums-at-rest = Gravidade ao longo dos pêndulos em repouso
half-car-model = Modelo de meio veículo
harmonic-f-cos-t = Harmônica: F cos(Ωt − φ)
maximum-frequency-of-the-curves = Frequência máxima das curvas
inertia-coupling-of-the-two-ends-zero-if-j-m-l-f-l-r-front-and-rear-are-then-uncoupled = Acoplamento inercial das duas extremidades; nulo se J = m l_f l_r: dianteira e traseira ficam então desacopladas
its-duration = Sua duração
its-imaginary-part-frequency-of-the-damped-motion = Sua parte imaginária: frequência do movimento amortecido
its-modulus-natural-frequency-of-the-damped-mode = Seu módulo: frequência natural do modo amortecido
its-start = Seu início
its-time = Seu instante
maximum-displacement-in-the-plotted-time-the-extremum-farthest-from-zero-end-points-included = Deslocamento máximo no tempo traçado: o extremo mais afastado de zero, incluídos o início e o fim
the-largest-displacement-of-coordinate-at-is-not-sought-over-so-many-oscillations-shorten-the = o maior deslocamento da coordenada { $at } não é procurado em tantas oscilações: encurte a duração das curvas
maximum-displacement-in-the-time-shown = Deslocamento máximo no tempo mostrado
largest-component-is-1 = Maior componente igual a 1
last = última
last-component-is-1 = Última componente igual a 1
omit-if-they-lie-in-a-horizontal-plane-negative-if-they-are-inverted = Omitida se estão em um plano horizontal; negativa se estão invertidos.
length-after-the-last-mass = Comprimento depois da última massa
length-of-string-before-it = Comprimento de corda antes dela
length-of-the-bar = Comprimento da barra
mass-matrix-m = Matriz de massa M
mass-of-the-bar = Massa da barra
mass-of-the-body = Massa da carroceria
effective-body-mass-at-an-axle-that-moves-while-the-other-is-at-rest-t-m-j-2-with-y-l-r-u-f-l-f-u-r-l = Massa efetiva da carroceria em um eixo que se move enquanto o outro está em repouso: T = (m ẏ² + J θ̇²)/2 com y = (l_r u_f + l_f u_r)/l, θ = (u_r − u_f)/l
mass-of-wheel-and-axle = Massa de roda e eixo
mass-damping-and-stiffness-matrices = Matrizes de massa, amortecimento e rigidez
masses = Massas
masses-on-a-stretched-string = Massas em uma corda tracionada
modal-analysis = Análise modal
mode-mode-modal-stiffness-from-the-stiffness-matrix-k = modo { $mode }: rigidez modal pela matriz de rigidez, φᵀKφ
mode-mode-i-d-is-a-root-of-det-m-c-k-0 = modo { $mode }: −ζω + iω_d é raiz de det(λ²M + λC + K) = 0
damped-mode-place-powers-of-inertia-damping-and-stiffness-in-its-mode-shape-v-m-c-k-v-0 = modo amortecido { $place }: potências de inércia, amortecimento e rigidez na sua forma modal, vᵀ(λ²M + λC + K)v = 0
modal-mass = Massa modal
nodes-position-in-mass-spacings = Nós (posição em espaçamentos de massas)
from-the-table-of-frequencies = Da tabela de frequências
dynamic-stiffness-k-m = Rigidez dinâmica
determinant-of-k-m-zero-at-a-natural-frequency = Determinante de K − ω²M; nulo em uma frequência natural
displacement-in-phase-with-the-forces-by-cramer-s-rule = Deslocamento em fase com as forças, pela regra de Cramer
displacement-at-at-frequency-place-by-elimination = deslocamento { $at } na frequência { $place } por eliminação
modal-mass-given = Massa modal dada
modal-mass-of-every-mode = Massa modal de cada modo
modal-mass-m-for-the-chosen-normalisation = Massa modal φᵀMφ, para a normalização escolhida
modal-stiffness = Rigidez modal
modal-stiffness-k-m = Rigidez modal φᵀKφ = ω²φᵀMφ
mode-shape = Forma modal
mode-shapes-largest-component-1 = Formas modais, maior componente = 1
mode-mode = Modo { $mode }
moment-for-a-unit-rotation = Momento para uma rotação unitária
moment-for-that-displacement-and-force-for-a-unit-rotation-that-lowers-the-front = Momento para esse deslocamento, e força para uma rotação unitária que abaixa a dianteira
moment-of-inertia-about-the-centre-of-mass = Momento de inércia em relação ao centro de massa
moment-of-inertia-of-a-slender-uniform-bar-about-its-centre = Momento de inércia de uma barra esbelta uniforme em relação ao seu centro
moment-of-inertia-of-the-body-in-pitch = Momento de inércia da carroceria em arfagem
moment-of-inertia-of-the-rod-about-its-pivot = Momento de inércia da barra em relação à articulação
moment-of-inertia-of-the-small-mass-about-the-pivot = Momento de inércia da pequena massa em relação à articulação
moment-of-spring-and-weight-for-a-unit-rotation-of-this-pendulum-the-other-fixed = Momento da mola e do peso para uma rotação unitária deste pêndulo, com o outro fixo
moment-on-one-for-a-unit-rotation-of-the-other-transmitted-by-the-spring = Momento em um para uma rotação unitária do outro, transmitido pela mola
motion-of-many-degrees-of-freedom-in-time = Movimento de vários graus de liberdade no tempo
velocity-at-at-time-place-by-taylor-series-of-m-c-k-x-f-step-by-step = velocidade { $at } no instante { $place } por série de Taylor de M ẍ + C ẋ + K x = f, passo a passo
the-velocity-at-is-zero-at-its-maximum-displacement-by-taylor-series = a velocidade { $at } é zero no seu deslocamento máximo, por série de Taylor
maximum-displacement-at-by-taylor-series-of-m-c-k-x-f-up-to-its-time = deslocamento máximo { $at }, por série de Taylor de M ẍ + C ẋ + K x = f até o seu instante
natural-frequencies-of-bounce-and-pitch-of-a-rigid-body-on-two-springs-and-the-nodes-about-which-it = Frequências naturais de salto vertical e arfagem de um corpo rígido sobre duas molas, e os nós em torno dos quais oscila.
natural-frequencies-amplitude-ratios-and-beats-of-two-rods-or-pendulums-joined-by-a-spring = Frequências naturais, razões de amplitude e batimentos de duas barras ou pêndulos unidos por uma mola.
natural-frequencies-mode-shapes-modal-masses-participation-and-damping-ratios-of-a-chain-of-masses-on = Frequências naturais, formas modais, massas modais, participação e fatores de amortecimento de uma cadeia, de massas em uma corda ou de matrizes dadas.
natural-frequency-of-the-damped-mode = Frequência natural do modo amortecido
negative-if-it-is-ahead-of-it = Negativa se está à frente dele.
negative-if-it-is-behind-it = Negativa se está atrás dele.
node-behind-the-centre-of-mass = Nó atrás do centro de massa
node-the-point-behind-the-centre-of-mass-that-remains-at-rest-y-x-0 = Nó: o ponto atrás do centro de massa que fica em repouso, y + θx = 0
nyquist-plot = Diagrama de Nyquist
observed-coordinates = Coordenadas observadas
one-per-line-from-the-lowest-mode-up-the-last-applies-to-all-higher-modes = Um por linha, a partir do modo mais baixo; o último vale para todos os modos mais altos.
phase-against-frequency = Fase em função da frequência
phase-lag-90-for-a-sine = Ângulo de fase (atraso); 90° para um seno
phase-ahead-of-cos-t = Fase, adiantada em relação a cos ωt
phases-of-the-damped-mode = Fases do modo amortecido
radius-of-gyration-given = Raio de giração dado
ramp-to-a-constant-force = Rampa até uma força constante
rayleigh-damping-c-m-k = Amortecimento de Rayleigh C = αM + βK
rayleigh-damping-at-the-second-point = amortecimento de Rayleigh no segundo ponto
rayleigh-damping-has-2-2-from-the-two-points = O amortecimento de Rayleigh tem ζ = α/(2ω) + βω/2; dos dois pontos
rayleigh-damping-through-two-points = Amortecimento de Rayleigh por dois pontos
rear-axle = Eixo traseiro
rear-spring = Mola traseira
rear-spring-behind-the-centre-of-mass = Mola traseira atrás do centro de massa
receptance-mobility-or-accelerance-of-a-chain-or-of-given-matrices-steady-state-amplitudes-and-phases = Receptância, mobilidade ou acelerância de uma cadeia ou de matrizes dadas: amplitudes e fases em regime permanente sob forças harmônicas em quaisquer massas.
receptances-h-at-the-first-frequency = Receptâncias |Hᵢⱼ| na primeira frequência
rectangular-pulse = Pulso retangular
rigid-body-mode-the-system-moves-as-a-whole-no-spring-is-stretched = Modo de corpo rígido: o sistema se move como um todo, nenhuma mola se deforma
root-of-det-m-c-k-0-from-the-first-order-state-equations = Raiz de det(λ²M + λC + K) = 0, pelas equações de estado de primeira ordem
root-without-oscillation = Raiz sem oscilação
row = Linha
row-column-mass-damping-stiffness-entries-not-listed-are-zero-an-off-diagonal-entry-also-applies-to = Linha, coluna, massa, amortecimento, rigidez. O que não consta é zero; um elemento fora da diagonal vale também para o seu simétrico. Ângulos são escritos em SI como se fossem comprimentos.
second-frequency = Segunda frequência
second-pendulum = Segundo pêndulo
mass-proportional-coefficient = Coeficiente proporcional à massa
stiffness-proportional-coefficient = Coeficiente proporcional à rigidez
mode-normalisation = Normalização dos modos
slender-uniform-bar = Barra esbelta uniforme
slender-uniform-rod-pivoted-at-its-end = Barra esbelta uniforme, articulada na extremidade
small-mass-on-a-light-rod = Pequena massa em uma haste leve
spring-to-the-ground = Mola ao solo
spring-to-the-previous-mass = Mola à massa anterior
spring-to-the-wall-on-the-right = Mola à parede da direita
square-of-the-frequency-of-one-coordinate-alone-the-other-fixed = Quadrado da frequência de uma coordenada sozinha, com a outra fixa
step-constant-from-its-start = Degrau: constante a partir do seu início
stiffness-matrix-k = Matriz de rigidez K
stiffness-of-the-spring-between-them = Rigidez da mola entre eles
stiffness-of-the-suspension = Rigidez da suspensão
stiffness-of-the-tyre = Rigidez do pneu
table-linear-between-its-points-zero-before-and-after = Tabela: linear entre os seus pontos, zero antes e depois
the-bar-on-its-springs = A barra sobre as suas molas
the-dampers-of-the-system-if-any = Os amortecedores do sistema, se houver
the-force-on-a-mass-for-a-unit-displacement-of-its-neighbour = A força em uma massa para um deslocamento unitário da sua vizinha
the-half-car = O meio veículo
the-motion-passes-from-one-pendulum-to-the-other-and-back-beats = O movimento passa de um pêndulo ao outro e volta: batimentos
the-component-leading-by-90-a-lag-is-negative = A componente adiantada de 90°; o atraso é negativo
the-pendulums-and-their-spring = Os pêndulos e a sua mola
the-same-damping-ratio-in-every-mode = O mesmo fator de amortecimento em todos os modos
the-smaller-root-the-product-of-the-two-is = A raiz menor: o produto das duas é Λ₁Λ₂ − Γ
the-system = O sistema
times = Instantes
to-the-wall-for-the-first-one = À parede, para a primeira.
angle-of-the-second-over-that-of-the-first = Ângulo do segundo sobre o do primeiro
velocity-mobility-for-1-n = Velocidade (mobilidade para 1 N)
wall-on-the-right = Parede à direita
wheelbase = Distância entre eixos
if-omitted-slightly-above-the-highest-natural-frequency = Se omitida, um pouco acima da frequência natural mais alta.
a-force-acts-at-the-natural-frequency-mode-without-damping-the-motion-is-unbounded-it-grows-with-t = uma força atua na frequência natural { $mode } sem amortecimento: o movimento é ilimitado, cresce com t
amplitude-over-the-maximum-amplitude = amplitude sobre a amplitude máxima
at-most-50-frequencies-and-50-coordinates-are-computed-at-a-time = calculam-se no máximo 50 frequências e 50 coordenadas de cada vez
at-most-50-times-and-50-coordinates-are-computed-at-a-time = calculam-se no máximo 50 instantes e 50 coordenadas de cada vez
at-the-natural-frequency-mode-without-damping-the-motion-is-unbounded-it-grows-with-t-and-there-is-no = na frequência natural { $mode }, sem amortecimento, o movimento é ilimitado: cresce com t e não há regime permanente
both-springs-resist-a-displacement-of-the-centre-of-mass-without-a-moment-bounce-and-pitch-are = as duas molas resistem a um deslocamento do centro de massa sem momento: translação vertical e arfagem são desacopladas
coordinate-at = coordenada { $at }
coordinate-row-has-no-mass-write-a-positive-mass-on-the-diagonal-or-eliminate-it = a coordenada { $row } não tem massa: escreva uma massa positiva na diagonal, ou elimine-a
det-k-m-0-is-with-its-larger-root = det(K − λM) = 0 é (Λ₁ − λ)(Λ₂ − λ) = Γ, com λ = ω²; a raiz maior
displacement-at-at-time-place-by-taylor-series-of-m-c-k-x-f-step-by-step = deslocamento { $at } no instante { $place } pela série de Taylor de M ẍ + C ẋ + K x = f, passo a passo
every-mode-is-overdamped-the-system-returns-without-oscillating = todos os modos são superamortecidos: o sistema retorna sem oscilar
frequency-mode-from-the-eigenvalues-of-m-k = frequência { $mode } pelos autovalores de M⁻¹K
masses-springs-and-dampers-differ-so-much-in-magnitude-that-numbers-overflow = massas, molas e amortecedores diferem tanto em ordem de grandeza que ocorre estouro numérico
mode-mode-is-overdamped-it-returns-without-oscillating = o modo { $mode } é superamortecido: retorna sem oscilar
mode-mode-maximum-potential-energy-k-2-maximum-kinetic-energy-m-2 = modo { $mode }: energia potencial máxima φᵀKφ/2 = energia cinética máxima ω²φᵀMφ/2
modes-first-and-second-have-the-same-frequency-any-linear-combination-of-their-shapes-is-also-a-mode = os modos { $first } e { $second } têm a mesma frequência: qualquer combinação linear das suas formas também é um modo
rigid-body-mode-mode-is-unrestrained-under-a-constant-force-the-motion-is-unbounded-it-grows-with-t = o modo de corpo rígido { $mode } não tem restrição: sob uma força constante o movimento é ilimitado, cresce com t²
or-is-negative-between-the-two-frequencies-the-damping-fits-outside-them-it-becomes-negative-and-the = α ou β é negativo: entre as duas frequências o amortecimento se ajusta, fora delas torna-se negativo e o movimento cresce
reciprocity-h-h = reciprocidade: Hᵢⱼ = Hⱼᵢ
mode-shape-mode-from-the-eigenvectors-of-m-k = forma modal { $mode } pelos autovetores de M⁻¹K
so-close-to-an-undamped-resonance-the-response-is-unbounded-and-has-no-significant-digits = tão perto de uma ressonância sem amortecimento a resposta é ilimitada e não tem algarismos significativos
the-damping-couples-the-modes-without-damping-the-masses-no-longer-pass-through-rest-together-and-the = o amortecimento acopla os modos não amortecidos: as massas já não passam juntas pelo repouso, e os modos amortecidos são complexos
the-product-of-the-distances-of-the-two-nodes-is-the-square-of-the-radius-of-gyration = o produto das distâncias dos dois nós é o quadrado do raio de giração
the-effective-masses-add-up-to-the-total-mass = as massas efetivas somam a massa total
the-entries-row-column-and-column-row-differ-the-matrices-of-masses-springs-and-dampers-are-symmetric = os elementos ({ $row }, { $column }) e ({ $column }, { $row }) diferem: as matrizes de massas, molas e amortecedores são simétricas
the-entry-row-column-is-listed-twice-keep-one-line-for-it = o elemento ({ $row }, { $column }) consta duas vezes: mantenha uma linha para ele
the-lowest-root-of-det-m-c-k-0-lies-at-the-lowest-natural-frequency = a menor raiz de det(λ²M + λC + K) = 0 está na menor frequência natural
the-mass-matrix-is-not-positive-definite-some-motion-has-no-kinetic-energy-so-it-has-no-frequency = a matriz de massa não é positiva definida: algum movimento não tem energia cinética, portanto não tem frequência
the-modes-are-orthogonal-with-respect-to-the-mass-matrix-m-0 = os modos são ortogonais em relação à matriz de massa: φᵢᵀMφⱼ = 0
the-modes-are-orthogonal-with-respect-to-the-stiffness-matrix-k-0 = os modos são ortogonais em relação à matriz de rigidez: φᵢᵀKφⱼ = 0
the-modes-cannot-be-computed-with-sufficient-accuracy = os modos não podem ser calculados com exatidão suficiente
the-rear-spring-is-not-behind-the-front-one-so-pitch-is-unrestrained-write-distances-whose-sum-is = a mola traseira não está atrás da dianteira e a arfagem fica sem restrição; escreva distâncias cuja soma seja maior que zero
the-response-as-a-sum-over-the-modes = a resposta como soma sobre os modos
the-stiffness-matrix-is-indefinite-the-rest-position-is-unstable-and-does-not-vibrate = a matriz de rigidez é indefinida: a posição de repouso é instável e não há vibração
the-sum-of-all-roots-is-tr-m-c = a soma de todas as raízes é −tr(M⁻¹C)
the-times-of-a-force-table-must-not-decrease-sort-its-rows = os tempos de uma tabela de força não devem diminuir: ordene as suas linhas
the-two-frequencies-of-the-rayleigh-damping-are-the-same-write-two-different-ones = as duas frequências do amortecimento de Rayleigh são iguais: escreva duas diferentes
the-at-coordinate-is-a-node-of-mode-mode-it-cannot-be-set-to-1-choose-another-mode-normalisation = a { $at } coordenada é um nó do modo { $mode }: não pode ser feita igual a 1; escolha outra normalização dos modos
there-is-no-coordinate-at-the-system-has-n = não há coordenada { $at }: o sistema tem { $n }
these-inputs-lead-to-a-damping-that-cannot-be-represented = estes dados levam a um amortecimento que não pode ser representado
these-inputs-lead-to-a-motion-that-cannot-be-represented = estes dados levam a um movimento que não pode ser representado
two-damped-modes-share-one-root-and-one-mode-shape-critical-damping-change-a-damper-by-a-millionth = dois modos amortecidos têm a mesma raiz e a mesma forma modal (amortecimento crítico): mude um amortecedor em um milionésimo
have-degrees-of-freedom-exceed-the-limit-of-most-for-interactive-solution = { $have } graus de liberdade excedem o limite de { $most } para a solução interativa
number-is-not-a-row-or-column-of-a-matrix-write-whole-numbers-from-1-to-most = { $number } não é linha nem coluna de uma matriz: escreva números inteiros de 1 a { $most }
the-smaller-root-is-zero-a-rigid-body-mode = Λ₁Λ₂ = Γ: a raiz menor é zero, um modo de corpo rígido
# oscillator
mass-given = Massa dada
weight-given = Peso dado
weight = Peso
springs-and-beams = Molas e vigas
static-deflection-under-the-weight = Deflexão estática sob o peso
static-deflection = Deflexão estática
without-damping = Sem amortecimento.
hysteretic-loss-factor-given = Histerético: fator de perda dado
complex-stiffness-k-1-i-the-energy-loss-per-cycle-is-independent-of-frequency = Rigidez complexa k(1 + iη): a perda de energia por ciclo não depende da frequência.
loss-factor = Fator de perda
mass-of-this-weight = Massa desse peso
natural-frequency-from-the-weight-m-g-k-st = Frequência natural, pelo peso m g = k δ_st
stiffness-that-gives-the-mass-this-natural-frequency = Rigidez que dá à massa essa frequência natural
a-damping-coefficient-is-not-sufficient-without-the-mass-write-the-mass-or-the-damping-ratio = um coeficiente de amortecimento não basta sem a massa: escreva a massa, ou o fator de amortecimento
viscous-damper-with-the-same-energy-loss-per-cycle-at-this-frequency = Amortecedor viscoso com a mesma perda de energia por ciclo nesta frequência
damping-ratio-of-the-viscous-damper-with-the-same-energy-loss-per-cycle-at-this-frequency = Fator de amortecimento do amortecedor viscoso com a mesma perda de energia por ciclo nesta frequência
the-natural-frequency-of-these-springs-needs-the-mass-on-them-write-the-mass-or-give-the-natural = a frequência natural dessas molas depende da massa sobre elas: escreva a massa, ou dê a frequência natural ou a deflexão estática
with-a-damping-ratio-of-1-or-more-the-free-motion-does-not-oscillate-give-the-natural-frequency = com fator de amortecimento de 1 ou mais a vibração livre não oscila: dê a frequência natural
hysteretic-damping-has-no-damped-natural-frequency-give-the-undamped-natural-frequency = o amortecimento histerético não tem frequência natural amortecida: dê a frequência natural não amortecida
sine-starts-at-zero = Seno: começa em zero
cosine-starts-at-its-maximum = Cosseno: começa no valor máximo
displacement-from-the-exponential-of-the-matrix-of-the-system = deslocamento pela exponencial da matriz do sistema
asked = pedido
requested = pedido
without-damping-at-the-natural-frequency-the-motion-grows-with-the-time = Sem amortecimento, na frequência natural, o movimento cresce com o tempo
the-initial-free-displacement-cancels-that-of-the-steady-state-motion = O deslocamento livre inicial compensa o do regime permanente
and-the-initial-free-velocity-cancels-that-of-the-steady-state-motion-together-rest = Velocidade inicial da parcela transitória: cancela a do regime permanente, e a massa parte do repouso
sine-component-of-the-free-vibration = Componente em seno da vibração livre
displacement-steady-state-motion-and-decaying-free-vibration = Deslocamento: movimento permanente e vibração livre que decai
displacement-steady-state-motion-and-free-vibration-which-does-not-decay-without-damping = Deslocamento: movimento permanente e vibração livre, que não decai sem amortecimento
growing-part-of-the-critically-damped-free-motion = Parte crescente do movimento livre com amortecimento crítico
the-slower-and-the-faster-decay-of-the-free-motion = O decaimento mais lento e o mais rápido do movimento livre
the-faster-decay = O decaimento mais rápido
coefficient-of-the-slower-decaying-term = Coeficiente do termo de decaimento mais lento
coefficient-of-the-faster-decaying-term = Coeficiente do termo de decaimento mais rápido
this-oscillator = este oscilador
here = aqui
magnification-against-frequency-ratio = Amplificação em função da razão de frequências
phase-lag-against-frequency-ratio = Ângulo de fase (atraso) em função da razão de frequências
transmissibility-against-frequency-ratio = Transmissibilidade em função da razão de frequências
rotating-vectors-of-the-forces = Vetores girantes das forças
# overhung-disc
overhung-disc-with-gyroscopic-action = Disco em balanço com efeito giroscópico
natural-frequencies-at-rest-forward-and-backward-whirl-at-a-speed-and-synchronous-critical-speeds-of = Frequências naturais em repouso, precessão direta e retrógrada a uma rotação e velocidades críticas síncronas de um disco em um eixo leve.
if-given-the-whirl-frequencies-at-this-speed-are-computed-and-the-margin-to-a-critical-speed = Se for dada, calculam-se as frequências de precessão nesta rotação e a margem até uma velocidade crítica.
cantilever-with-the-disc-at-its-tip = Viga engastada com o disco na ponta
influence-coefficients-at-the-disc = Coeficientes de influência no disco
for-any-other-shaft-and-bearings = Para qualquer outro eixo e mancais.
deflection-per-unit-force = Deflexão por unidade de força
slope-per-unit-force = Inclinação por unidade de força
equal-to-the-deflection-per-unit-moment = Igual à deflexão por unidade de momento.
slope-per-unit-moment = Inclinação por unidade de momento
mass-radius-of-gyration-and-width = Massa, raio de giração e largura
radius-of-gyration-about-the-axis = Raio de giração em torno do eixo
diameter-width-and-density = Diâmetro, largura e massa específica
natural-frequency-at-rest = Frequência natural em repouso
effective-tilting-inertia-of-the-disc-in-synchronous-forward-whirl = Inércia efetiva de inclinação do disco em precessão direta síncrona
critical-speed-of-forward-whirl = Velocidade crítica da precessão direta
effective-tilting-inertia-of-the-disc-in-synchronous-backward-whirl = Inércia efetiva de inclinação do disco em precessão retrógrada síncrona
critical-speed-of-backward-whirl = Velocidade crítica da precessão retrógrada
i-p-i-d-gyroscopic-action-stiffens-the-tilting-of-the-disc-faster-than-the-speed-rises-so-there-is-no = I_p ≥ I_d: o efeito giroscópico enrijece a inclinação do disco mais depressa do que a rotação sobe, de modo que não há segunda velocidade crítica direta; o desbalanceamento só excita a primeira
the-speed-is-within-10-of-the-critical-speed-critical = a rotação está a menos de 10 % da velocidade crítica { $critical }
half-of-the-coefficient-of-in-the-frequency-equation-m-i-d-2p-0 = Metade do coeficiente de ω² na equação de frequências m I_d ω⁴ − 2p ω² + Δ = 0
lower-natural-frequency-of-the-disc-that-does-not-spin = Menor frequência natural do disco que não gira
upper-natural-frequency-of-the-non-rotating-disc = Maior frequência natural do disco sem rotação
the-natural-frequency-makes-the-determinant-of-the-influence-coefficients-vanish = a frequência natural anula o determinante dos coeficientes de influência
the-same-with-the-effective-inertia-in-forward-whirl = O mesmo, com a inércia efetiva da precessão direta
critical-speed-of-forward-whirl-excited-by-unbalance = Velocidade crítica da precessão direta: excitada pelo desbalanceamento
second-critical-speed-of-forward-whirl = Segunda velocidade crítica da precessão direta
the-forward-critical-speed-makes-the-determinant-of-the-influence-coefficients-vanish = a velocidade crítica direta anula o determinante dos coeficientes de influência
the-same-with-the-effective-inertia-in-backward-whirl = O mesmo, com a inércia efetiva da precessão retrógrada
first-critical-speed-of-backward-whirl = Primeira velocidade crítica da precessão retrógrada
second-critical-speed-of-backward-whirl = Segunda velocidade crítica da precessão retrógrada
the-backward-critical-speed-makes-the-determinant-of-the-influence-coefficients-vanish = a velocidade crítica retrógrada anula o determinante dos coeficientes de influência
force-at-the-tip-per-unit-deflection-with-the-rotation-of-the-tip-prevented = Força na ponta por unidade de deflexão, com a rotação da ponta impedida
moment-at-the-tip-per-unit-deflection-with-the-tip-prevented-from-rotating = Momento na ponta por unidade de deflexão, com a ponta impedida de girar
moment-at-the-tip-per-unit-slope-with-the-tip-held-in-place = Momento na ponta por unidade de inclinação, com a ponta mantida no lugar
is-not-above-so-the-shaft-would-not-resist-some-load-check-the-influence-coefficients = α γ não é maior que β², de modo que o eixo não resistiria a alguma carga: confira os coeficientes de influência
determinant-of-the-influence-coefficients = Determinante dos coeficientes de influência
stiffness-is-the-inverse-of-the-influence-coefficients-force-per-unit-deflection = A rigidez é a inversa dos coeficientes de influência: força por unidade de deflexão
moment-per-unit-deflection = Momento por unidade de deflexão
moment-per-unit-slope = Momento por unidade de inclinação
determinant-of-the-stiffness-of-the-shaft-at-the-disc = Determinante da rigidez do eixo no disco
the-frequency-equation-at-this-speed-could-not-be-solved-check-units-and-sizes = a equação de frequências nesta rotação não pôde ser resolvida: confira unidades e tamanhos
the-whirl-frequency-satisfies-the-frequency-equation-k-m-k-i-d-i-p-k = a frequência de precessão satisfaz a equação de frequências (k₁₁ − mω²)(k₂₂ − I_d ω² ± I_p Ω ω) = k₁₂²
forward-whirl-root-of-k-m-k-i-d-i-p-k = Precessão direta: raiz de (k₁₁ − mω²)(k₂₂ − I_d ω² + I_p Ω ω) = k₁₂²
forward-whirl-at-this-speed = Precessão direta nesta rotação
backward-whirl-root-of-k-m-k-i-d-i-p-k = Precessão retrógrada: raiz de (k₁₁ − mω²)(k₂₂ − I_d ω² − I_p Ω ω) = k₁₂²
backward-whirl-at-this-speed = Precessão retrógrada nesta rotação
frequency-of-whirl = frequência de precessão
backward-1 = retrógrada 1
forward-1 = direta 1
backward-2 = retrógrada 2
forward-2 = direta 2
forward-critical-speed = velocidade crítica direta
backward-critical-speed = velocidade crítica retrógrada
the-disc-on-its-bent-shaft = O disco no seu eixo fletido
# periodic-excitation
mean-of-the-motion-the-wave-lies-equally-above-and-below-zero = Média do movimento: a onda fica igualmente acima e abaixo de zero
mean-of-the-motion-the-mean-of-the-wave-is-half-its-height = Média do movimento: a média da onda é metade da sua altura
mean-of-the-motion-the-mean-of-one-half-sine-per-period-is-1-of-its-height = Média do movimento: a média de uma meia-onda senoidal por período é 1/π da sua altura
mean-of-the-motion-the-mean-of-a-sine-arch-is-2-of-its-height = Média do movimento: a média de um arco de seno é 2/π da sua altura
mean-of-the-motion-the-mean-of-the-pulses-is-their-fraction-of-the-period = Média do movimento: a média dos pulsos é a sua fração do período
table = Tabela
wave = Onda
frequency-of-the-wave = Frequência da onda
once-in-a-period = Uma vez por período.
from-the-start-of-a-period-of-the-steady-state-motion-the-displacement-there-is-computed = Contado do início de um período do regime permanente; calcula-se o deslocamento nesse instante.
height-of-the-wave = Altura da onda
the-value-that-the-picture-of-the-wave-shows-as-one = O valor que a figura da onda mostra como um.
motion-of-the-base = Movimento da base
harmonic-n-equation-of-motion-component-in-phase-with-the-wave = harmônico { $n }: equação de movimento, componente em fase com a onda
harmonic-n-equation-of-motion-quadrature-component-90-ahead = harmônico { $n }: equação de movimento, componente em quadratura (90° à frente)
displacement-at-that-time-by-convolution-of-the-wave-with-the-unit-impulse-response = deslocamento nesse instante, pela convolução da onda com a resposta ao impulso unitário
maximum-displacement-by-convolution-at-the-instant-at-which-the-velocity-changes-sign = deslocamento máximo: pela convolução, no instante em que a velocidade troca de sinal
minimum-displacement-by-convolution-at-the-instant-at-which-the-velocity-changes-sign = deslocamento mínimo: pela convolução, no instante em que a velocidade troca de sinal
damping-coefficient-by-mass-and-natural-frequency-2-m = coeficiente de amortecimento pela massa e pela frequência natural, 2ζmωₙ
hysteretic-damping-has-no-equation-of-motion-in-the-time-domain-give-the-damping-ratio-of-an = o amortecimento histerético não tem equação de movimento no domínio do tempo: dê o fator de amortecimento de um amortecedor viscoso equivalente
frequency-ratio-of-the-first-harmonic = Razão de frequências do primeiro harmônico
a-force-moves-a-mass-write-the-mass-or-choose-base-excitation = uma força move uma massa: escreva a massa, ou escolha excitação pela base
static-deflection-under-the-height-of-the-waveform = Deflexão estática sob a altura da forma de onda
without-damping-harmonic-order-coincides-with-the-natural-frequency-the-motion-is-unbounded-it-grows = sem amortecimento, o harmônico { $order } coincide com a frequência natural: o movimento é ilimitado, cresce com t
mean-of-the-wave-from-its-pieces = média da onda pelos seus trechos
mean-of-the-motion-the-static-deflection-under-the-mean-of-the-wave = Média do movimento: a deflexão estática sob a média da onda
mean-displacement = Deslocamento médio
coefficient-of-the-harmonic-from-the-pieces-of-the-wave = coeficiente do harmônico pelos trechos da onda
its-frequency-ratio = A sua razão de frequências
no-response-this-harmonic-is-absent-from-the-wave = Sem resposta: este harmônico está ausente da onda
response-to-this-harmonic-magnified-static-deflection = Resposta a este harmônico: deflexão estática amplificada
response-to-this-harmonic-transmitted-motion-of-the-base = Resposta a este harmônico: movimento da base transmitido
its-lag-behind-this-harmonic-of-the-wave = O seu atraso em relação a este harmônico da onda
amplitude-of-harmonic = Amplitude do harmônico
phase-lag-of-the-first-of-them = Ângulo de fase (atraso) do primeiro deles
harmonics-of-the-wave-and-of-the-motion = Harmônicos da onda e do movimento
motion = movimento
line-spectrum-of-the-motion = Espectro de linhas do movimento
the-total-motion-of-all-harmonics-is-omitted-it-cannot-be-computed-exactly = o movimento total de todos os harmônicos é omitido: não pode ser calculado com exatidão
root-mean-square-over-the-static-deflection-of-the-exact-motion-piece-by-piece-closed-over-a-period = Valor eficaz sobre a deflexão estática, do movimento exato: trecho por trecho, fechado num período
mean-square-of-the-exact-motion-half-the-sum-of-the-squares-of-all-harmonics = valor quadrático médio do movimento exato = metade da soma dos quadrados de todos os harmônicos
root-mean-square-of-the-displacement = Valor eficaz do deslocamento
maximum-displacement-of-the-exact-motion-over-the-static-deflection = Deslocamento máximo do movimento exato, sobre a deflexão estática
minimum-displacement-of-the-exact-motion-over-the-static-deflection = Deslocamento mínimo do movimento exato, sobre a deflexão estática
largest-displacement = Maior deslocamento
maximum-displacement = Deslocamento máximo
minimum-displacement = Deslocamento mínimo
displacement-of-the-exact-motion-at-that-time-over-the-static-deflection = Deslocamento do movimento exato nesse instante, sobre a deflexão estática
steady-state-motion-over-two-periods = Movimento em regime permanente em dois períodos
exact = exato
sum-of-the-listed-harmonics = soma dos harmônicos listados
at-rest-under-the-wave = em repouso sob a onda
square-wave = Onda quadrada
positive-for-the-first-half-of-the-period-equally-negative-for-the-second = Positiva na primeira metade do período, igualmente negativa na segunda.
triangular-wave = Onda triangular
rises-from-zero-falls-as-far-below-it-and-returns = Sobe do zero, desce igualmente abaixo dele e volta.
sawtooth = Dente de serra
rises-from-zero-over-the-period-then-drops-at-once-to-zero-a-cam = Cresce do zero ao longo do período e cai de súbito a zero: um came.
half-rectified-sine = Seno de meia onda
the-positive-half-of-a-sine-zero-for-the-second-half-of-the-period = A metade positiva de um seno, zero na segunda metade do período.
rectified-sine = Seno retificado
one-arch-after-another-the-period-is-that-of-one-arch = Um arco após o outro; o período é o de um arco.
rectangular-pulses = Pulsos retangulares
one-for-a-fraction-of-the-period-zero-for-the-rest = Um numa fração do período, zero no resto.
fraction-of-the-period = Fração do período
straight-lines-from-point-to-point-and-from-the-last-to-the-first-of-the-next-period = Retas de ponto a ponto, e do último ao primeiro do período seguinte.
ascending-two-points-at-the-same-fraction-define-a-step = Crescente; dois pontos na mesma fração definem um degrau.
value-over-the-height-of-the-wave = Valor sobre a altura da onda
the-table-has-count-points-at-most-most-can-be-summed-reduce-it = a tabela tem { $count } pontos; no máximo { $most } podem ser somados: reduza-a
the-table-requires-two-points-or-more-with-fractions-of-the-period-ascending-from-0-to-100 = a tabela requer dois pontos ou mais, com frações do período crescentes de 0 a 100 %
mean-of-the-wave-integrated-segment-by-segment = Média da onda, integrada trecho a trecho
fourier-coefficient-of-a-square-wave-4-n-for-odd-n = Coeficiente de Fourier de uma onda quadrada: 4/(nπ) para n ímpar
fourier-coefficient-of-a-triangular-wave-8-n-for-odd-n = Coeficiente de Fourier de uma onda triangular: 8/(nπ)² para n ímpar
fourier-coefficient-of-a-sawtooth-1-n = Coeficiente de Fourier de um dente de serra: 1/(nπ)
first-harmonic-of-a-half-rectified-sine-half-its-height = Primeiro harmônico de um seno de meia onda: metade da sua altura
fourier-coefficient-of-a-half-rectified-sine-2-n-1-for-even-n = Coeficiente de Fourier de um seno de meia onda: 2/((n² − 1)π) para n par
fourier-coefficient-of-a-rectified-sine-4-4n-1 = Coeficiente de Fourier de um seno retificado: 4/((4n² − 1)π)
fourier-coefficient-of-rectangular-pulses-2-sin-n-d-n = Coeficiente de Fourier de pulsos retangulares: 2|sen nπd|/(nπ)
cosine-coefficient-integrated-segment-by-segment = Coeficiente do cosseno, integrado trecho a trecho
sine-coefficient-integrated-segment-by-segment = Coeficiente do seno, integrado trecho a trecho
amplitude-from-the-cosine-and-sine-coefficients = Amplitude pelos coeficientes do cosseno e do seno
# rotating-unbalance
damping-ratio-between-two-values = Fator de amortecimento entre dois valores
the-amplitude-is-largest-with-the-minimum-damping-for-which-all-other-results-are-computed = A amplitude é maior com o amortecimento mínimo, para o qual se calculam todos os outros resultados.
least-damping-ratio = Menor fator de amortecimento
minimum-damping-ratio = Fator de amortecimento mínimo
maximum-damping-ratio = Fator de amortecimento máximo
the-minimum-damping-ratio-exceeds-the-maximum-one-exchange-them = o fator de amortecimento mínimo excede o máximo: troque-os
steady-state-amplitude-with-the-maximum-damping = Amplitude em regime permanente com o amortecimento máximo
amplitude-with-the-largest-damping-from-the-dynamic-stiffness = amplitude com o maior amortecimento pela rigidez dinâmica
amplitude-with-the-maximum-damping = Amplitude com o amortecimento máximo
from-its-deflection-under-a-load = A partir da deflexão sob uma carga
deflection = Deflexão
from-the-natural-frequency-of-a-mass-on-it = A partir da frequência natural de uma massa sobre ela
mass-on-the-spring = Massa sobre a mola
stiffness-load-over-deflection = Rigidez: carga sobre deflexão
stiffness-that-gives-this-mass-this-natural-frequency = Rigidez que dá a esta massa esta frequência natural
# damped-absorber, vibration-absorber
absorber = Absorvedor
absorber-by-itself-at-this-frequency-f-g = Absorvedor isolado nesta frequência, f² − g²
absorber-given = Absorvedor dado
also-for-an-absorber-not-tuned-to-the-speed = Também para um absorvedor não sintonizado na rotação.
amplitude-of-the-absorber = Amplitude do absorvedor
amplitude-of-the-main-system-with-and-without-the-absorber = Amplitude do sistema principal, com e sem o absorvedor
amplitude-without-the-absorber = Amplitude sem o absorvedor
as-a-fraction-of-the-natural-frequency = Como fração da frequência natural
auxiliary-number = Número auxiliar
optimum-damping-relative-to-the-main-frequency-c-2-m-a-m-the-peak-lies-at-the-fixed-point-of-an = Amortecimento ótimo em relação à frequência principal, c/(2 m_a ω_m): o pico fica no ponto fixo de um sistema principal sem amortecimento
optimum-tuning-and-damping-of-an-absorber-by-the-fixed-points-and-for-the-minimum-peak-of-a-viscous = Sintonia e amortecimento ótimos de um absorvedor pelos pontos fixos e para o pico mínimo, de um absorvedor viscoso sem mola, e a resposta antes e depois.
both-resonances-must-lie-outside-this-range-with-a-new-absorber-tuned-like-the-trial-one = As duas ressonâncias devem ficar fora dessa faixa, com um novo absorvedor sintonizado como o de ensaio.
from-both-resonances-natural-frequency-of-the-main-system-since-the-product-of-the-two-resonances = Pelas duas ressonâncias: frequência natural do sistema principal, pois o produto das duas ressonâncias é igual ao das duas frequências naturais
by-itself-on-a-fixed-base-the-speed-it-is-tuned-to = Isolado, sobre base fixa: a rotação em que está sintonizado.
by-itself-without-the-absorber = Isolado, sem o absorvedor.
damped-vibration-absorber = Absorvedor de vibrações amortecido
without-the-absorber-the-magnification-where-the-slope-of-the-response-is-zero = sem o absorvedor: a amplificação onde a inclinação da resposta é zero
the-slope-of-the-response-is-zero-at-the-peak = a inclinação da resposta é zero no pico
stroke-of-the-absorber-from-the-full-equations-of-motion = curso do absorvedor, pelas equações de movimento completas
main-mass-motion-at-its-natural-frequency-from-the-full-equations-with-spring-and-damper = movimento da massa principal na sua frequência natural, pelas equações completas com mola e amortecedor
absorber-motion-at-that-frequency-from-the-full-equations-with-spring-and-damper = movimento do absorvedor nessa frequência, pelas equações completas com mola e amortecedor
amplitude-of-the-main-mass-at-the-peak-from-the-equations-of-motion-in-full = amplitude da massa principal no pico, pelas equações de movimento completas
damping-coefficient-of-the-absorber = Coeficiente de amortecimento do absorvedor
damping-coefficient-of-the-absorber-2-m-a-m = Coeficiente de amortecimento do absorvedor, 2 m_a ω_m γ
damping-for-the-minimum-peak = Amortecimento para o pico mínimo
damping-for-the-minimum-peak-with-this-damping-of-the-main-system-newton-s-method = Amortecimento para o pico mínimo com este amortecimento do sistema principal (método de Newton)
damping-ratio-relative-to-the-absorber = Fator de amortecimento em relação ao próprio absorvedor
damping-ratio-relative-to-the-absorber-c-2-m-a-a-fixed-points = Fator de amortecimento em relação ao próprio absorvedor, c/(2 m_a ω_a), pontos fixos
damping-ratio-relative-to-the-absorber-c-2-m-a-a-minimum-peak = Fator de amortecimento em relação ao próprio absorvedor, c/(2 m_a ω_a), pico mínimo
damping-ratio-relative-to-the-main-frequency = Fator de amortecimento em relação à frequência principal
damping-ratio-relative-to-the-main-frequency-c-2-m-a-m = Fator de amortecimento em relação à frequência principal, c/(2 m_a ω_m)
damping-ratio-relative-to-the-main-frequency-c-2-m-a-m-fixed-points = Fator de amortecimento em relação à frequência principal, c/(2 m_a ω_m), pontos fixos
damping-ratio-relative-to-the-main-frequency-c-2-m-a-m-minimum-peak = Fator de amortecimento em relação à frequência principal, c/(2 m_a ω_m), pico mínimo
damping-ratio-relative-to-the-main-frequency-c-2-m-a-m-f-a = Fator de amortecimento em relação à frequência principal, c/(2 m_a ω_m) = f ζ_a
damping-ratio-of-the-main-system = Fator de amortecimento do sistema principal
damping-mean-square-of-the-two-values-that-give-zero-slope-of-the-response-at-one-or-the-other-fixed = Amortecimento: a média dos quadrados dos dois valores que dão tangente horizontal à resposta em um ou no outro ponto fixo
determinant-of-the-equations-of-both-masses-at-the-speed = Determinante das equações das duas massas na rotação
determinant-of-the-equations-of-both-masses-real-part = Determinante das equações das duas massas: parte real
disc-on-a-torsional-spring = Disco sobre mola de torção
each-by-itself = Cada um isolado.
fixed-point = Ponto fixo
for-the-amplitudes-required-for-a-stroke-limit = Para as amplitudes; necessária para um limite de curso.
unbalance-force-at-this-speed = Força do desbalanceamento nesta rotação
frequency-at-which-the-motion-is-requested = Frequência em que se pede o movimento
frequency-given = Frequência dada
frequency-over-the-natural-frequency-of-the-main-system = Frequência sobre a frequência natural do sistema principal
frequency-ratio-of-the-fixed-point = Razão de frequências do ponto fixo
frequency-ratio-of-the-highest-peak-the-response-has-zero-slope-there = Razão de frequências do pico mais alto: nele a resposta tem tangente horizontal
frequency-ratio-of-the-highest-peak-with-the-chosen-absorber = Razão de frequências do pico mais alto com o absorvedor escolhido
from-the-two-resonances-with-a-trial-absorber = A partir das duas ressonâncias com um absorvedor de ensaio
half-of-their-difference = Metade da sua diferença
upper-limit-of-the-lower-resonance-as-a-ratio-to-the-speed = Limite superior da ressonância inferior, em relação à rotação
in-torsion-inertia-over-inertia = Em torção, inércia sobre inércia.
inertia-given-tuned-to-the-speed = Inércia dada, sintonizado na rotação
inertia-of-the-absorber = Inércia do absorvedor
inertia-of-the-absorber-over-that-of-the-rotor = Inércia do absorvedor sobre a do rotor
inertia-of-the-absorber-from-the-ratio-of-the-inertias = Inércia do absorvedor, pela razão das inércias
inertia-of-the-new-absorber-by-the-mean = Inércia do novo absorvedor, pela média
inertia-of-the-new-absorber-exact = Inércia do novo absorvedor, exata
inertia-of-the-rotor = Inércia do rotor
inertia-of-the-trial-absorber = Inércia do absorvedor de ensaio
inertia-that-tunes-the-absorber-to-the-speed = Inércia que sintoniza o absorvedor na rotação
inertia-by-the-mean = Inércia, pela média
inertia-exact = Inércia, exata
its-damper = O seu amortecedor
its-damping-ratio-relative-to-the-absorber-alone = O seu fator de amortecimento, em relação ao absorvedor isolado
its-stiffness = A sua rigidez
its-stiffness-tuned-like-the-trial-absorber = A sua rigidez, com a sintonia do absorvedor de ensaio
maximum-amplitude-of-the-absorber = Amplitude máxima do absorvedor
maximum-amplitude-of-the-main-mass = Amplitude máxima da massa principal
maximum-magnification-by-the-fixed-points = Amplificação máxima pelos pontos fixos
maximum-magnification-with-the-chosen-absorber = Amplificação máxima com o absorvedor escolhido
maximum-magnification-with-this-tuning-and-damping-the-peaks-lie-a-little-above-the-fixed-points = Amplificação máxima com esta sintonia e este amortecimento: os picos ficam um pouco acima dos pontos fixos
maximum-magnification-without-the-absorber = Amplificação máxima sem o absorvedor
maximum-relative-motion-of-the-absorber-over-the-static-deflection-of-the-main-mass = Movimento relativo máximo do absorvedor, dividido pela deflexão estática da massa principal
maximum-relative-motion-over-the-static-deflection = Movimento relativo máximo dividido pela deflexão estática
maximum-stroke-of-the-absorber = Curso máximo do absorvedor
maximum-stroke-of-the-absorber-clearance-required-on-each-side = Curso máximo do absorvedor: folga necessária de cada lado
minimum-separation-from-the-speed-as-a-fraction-of-it = Separação mínima da rotação, como fração dela
minimum-possible-peak-magnification = Valor mínimo possível da amplificação máxima
limited-stroke = Curso limitado
lower-end-of-the-range-over-the-frequency-of-the-absorber = Extremo inferior da faixa, sobre a frequência do absorvedor
lower-end-of-the-range-over-the-speed = Extremo inferior da faixa, sobre a rotação
lower-fixed-point = Ponto fixo inferior
lower-resonance = Ressonância inferior
lower-resonance-measured = Ressonância inferior medida
lower-resonance-over-the-frequency-of-the-absorber = Ressonância inferior sobre a frequência do absorvedor
lower-resonance-over-the-speed = Ressonância inferior sobre a rotação
lower-resonance-as-a-ratio = Ressonância inferior, como razão
lower-limit-of-the-upper-resonance-as-a-ratio-to-the-speed = Limite inferior da ressonância superior, em relação à rotação
machine-on-springs = Máquina sobre molas
magnification-at-both-points = Amplificação em ambos os pontos
magnification-at-the-fixed-point = Amplificação no ponto fixo
magnification-at-the-fixed-points = Amplificação nos pontos fixos
magnification-at-this-frequency = Amplificação nesta frequência
magnification-for-other-values-of-absorber-damping = Amplificação para outros valores de amortecimento do absorvedor
magnification-of-the-main-mass-at-this-frequency = Amplificação da massa principal nesta frequência
magnification-of-the-main-system-with-and-without-the-absorber = Amplificação do sistema principal, com e sem o absorvedor
magnification-at-this-point = Amplificação nesse ponto
main-mass = Massa principal
main-system = Sistema principal
main-system-by-the-mean = Sistema principal pela média
main-system-that-has-exactly-these-resonances = Sistema principal que tem exatamente estas ressonâncias
mass-and-spring-of-an-absorber-for-a-limited-stroke-or-for-separated-resonances-its-two-resonances = Massa e mola de um absorvedor para um curso limitado ou para ressonâncias afastadas, as suas duas ressonâncias e amplitudes, e um sistema principal a partir de um absorvedor de ensaio.
mass-given-tuned-to-the-speed = Massa dada, sintonizado na rotação
mass-of-the-absorber = Massa do absorvedor
mass-of-the-absorber-over-that-of-the-machine = Massa do absorvedor sobre a da máquina
mass-of-the-absorber-over-the-main-mass = Massa do absorvedor sobre a massa principal
mass-of-the-absorber-from-the-mass-ratio = Massa do absorvedor, pela razão de massas
mass-of-the-new-absorber-by-the-mean = Massa do novo absorvedor, pela média
mass-of-the-new-absorber-exact = Massa do novo absorvedor, exata
mass-of-the-trial-absorber = Massa do absorvedor de ensaio
mass-on-a-spring = Massa sobre mola
mass-ratio = Razão de massas
mass-ratio-by-the-lower-resonance-if-the-absorber-were-tuned-to-the-natural-frequency-of-the-main = Razão de massas pela ressonância inferior, se o absorvedor estivesse sintonizado na frequência natural do sistema principal
mass-ratio-by-the-upper-resonance = Razão de massas pela ressonância superior
mass-ratio-given = Razão de massas dada
mass-ratio-that-places-the-lower-resonance-at-the-lower-end = Razão de massas que leva a ressonância inferior ao extremo inferior
mass-ratio-that-places-the-lower-resonance-at-this-limit-by-the-frequency-equation = Razão de massas que leva a ressonância inferior a esse limite, pela equação das frequências
mass-ratio-that-places-the-upper-resonance-at-the-upper-end = Razão de massas que leva a ressonância superior ao extremo superior
mass-ratio-that-places-the-upper-resonance-at-this-limit-by-the-frequency-equation = Razão de massas que leva a ressonância superior a esse limite, pela equação das frequências
without-the-absorber-inertia-and-spring-balance-the-excitation-m-m-x-f = sem o absorvedor: inércia e mola equilibram a excitação, m|ω_m² − ω²|X = F₀
mass-ratio-from-the-sum-of-the-squares-of-the-two-resonances = Razão de massas, pela soma dos quadrados das duas ressonâncias
mass-ratio-absorber-over-machine = Razão de massas: absorvedor sobre máquina
mass-ratio-absorber-over-main-mass = Razão de massas: absorvedor sobre massa principal
mass-ratio-the-larger-required-by-the-lower-resonance = Razão de massas: a maior, exigida pela ressonância inferior
mass-ratio-the-larger-required-by-the-upper-resonance = Razão de massas: a maior, exigida pela ressonância superior
mass-that-tunes-the-absorber-to-the-speed = Massa que sintoniza o absorvedor na rotação
mass-by-the-mean = Massa, pela média
mass-exact = Massa, exata
mean-of-the-two-which-differ-because-the-tuning-is-not-exact = Média das duas, que diferem porque a sintonia não é exata
relative-motion-of-the-absorber-over-the-static-deflection = Movimento relativo do absorvedor, dividido pela deflexão estática
motion-of-the-absorber-relative-to-the-main-system = Movimento do absorvedor em relação ao sistema principal
motion-of-the-absorber-along-the-excitation = Movimento do absorvedor, no sentido da excitação
motion-of-the-absorber-negative-if-opposite-to-the-excitation = Movimento do absorvedor: negativo quando contrário à excitação
motion-of-the-absorber-the-main-system-is-at-rest-and-the-force-of-the-spring-is-opposite-to-the = Movimento do absorvedor: o sistema principal está parado, e a força da mola é oposta à excitação
motion-of-the-main-system-along-the-excitation = Movimento do sistema principal, no sentido da excitação
motion-of-the-main-system-negative-if-opposite-to-the-excitation = Movimento do sistema principal: negativo quando contrário à excitação
natural-frequency-of-the-absorber = Frequência natural do absorvedor
natural-frequency-of-the-absorber-by-itself = Frequência natural do absorvedor isolado
natural-frequency-of-the-absorber-over-that-of-the-main-system = Frequência natural do absorvedor sobre a do sistema principal
natural-frequency-of-the-chosen-absorber-by-itself = Frequência natural do absorvedor escolhido, isolado
natural-frequency-of-the-main-system-exact = Frequência natural do sistema principal, exata
natural-frequency-of-the-main-system-without-the-absorber = Frequência natural do sistema principal, sem o absorvedor
natural-frequency-of-the-trial-absorber = Frequência natural do absorvedor de ensaio
natural-frequency-without-the-absorber = Frequência natural sem o absorvedor
new-absorber-for-the-exact-main-system = Novo absorvedor para o sistema principal exato
new-absorber-the-larger-of-the-two-mass-ratios-keeps-both-resonances-out-of-the-range = Novo absorvedor: a maior das duas razões de massas mantém as duas ressonâncias fora da faixa
number-of-springs = Número de molas
on-a-fixed-base = Sobre base fixa.
on-the-main-mass-for-the-amplitudes = Sobre a massa principal; para as amplitudes.
only-the-mass-ratio = Só a razão de massas
over-the-natural-frequency = Sobre a frequência natural
support-of-the-pendulum = Suporte do pêndulo
radius-of-the-circle = Raio da circunferência
range = Faixa
ratio-of-the-inertias-given = Razão das inércias dada
ratio-of-the-inertias-absorber-over-rotor = Razão das inércias: absorvedor sobre rotor
ratio-of-the-natural-frequencies = Razão das frequências naturais
relative-motion-at-this-frequency-over-the-static-deflection = Movimento relativo nesta frequência sobre a deflexão estática
resonances-against-the-mass-ratio = Ressonâncias em função da razão de massas
resonances-kept-away-from-the-speed = Ressonâncias afastadas da rotação
resonances-kept-out-of-a-range-of-speeds = Ressonâncias fora de uma faixa de rotações
rotor-on-a-shaft = Rotor em um eixo
speed-of-the-excitation = Rotação da excitação
speed-over-the-natural-frequency-of-the-main-system = Rotação sobre a frequência natural do sistema principal
speed-from-the-given-fraction-of-the-natural-frequency = Rotação, pela fração dada da frequência natural
speeds-without-resonance = Rotações sem ressonância
springs-between-absorber-and-rotor = Molas entre absorvedor e rotor
springs-of-the-machine = Molas da máquina
springs-of-the-main-mass = Molas da massa principal
squares-of-the-ratios-of-the-fixed-points-their-mean = Quadrados das razões dos pontos fixos: a sua média
static-deflection-under-the-force = Deflexão estática sob a força
stiffness-of-each-spring = Rigidez de cada mola
stiffness-of-each-spring-at-radius-a-rotation-stretches-it-by-and-its-force-acts-at = Rigidez de cada mola: no raio ρ uma rotação θ a alonga de ρθ, e a sua força age em ρ
stiffness-of-the-absorber = Rigidez do absorvedor
stiffness-of-the-absorber-with-the-main-system-at-rest-its-spring-alone-balances-the-excitation = Rigidez do absorvedor: com o sistema principal parado, só a sua mola equilibra a excitação
stiffness-of-the-new-absorber-from-the-mean = Rigidez do novo absorvedor, pela média
stiffness-of-the-new-absorber-exact = Rigidez do novo absorvedor, exata
stiffness-that-gives-the-main-system-its-natural-frequency = Rigidez que dá ao sistema principal a sua frequência natural
stiffness-that-tunes-the-absorber-to-the-running-speed = Rigidez que sintoniza o absorvedor na rotação de operação
stiffness-from-the-mean = Rigidez, pela média
stiffness-exact = Rigidez, exata
stiffness-from-the-natural-frequency-of-the-absorber = Rigidez, pela frequência natural do absorvedor
straight-springs-arranged-along-the-circumference = Molas retas dispostas ao longo da circunferência.
sum-of-the-two-resonances-over-the-natural-frequency-of-the-main-system-from-their-product-f-and-the = Soma das duas ressonâncias, sobre a frequência natural do sistema principal: pelo seu produto f e pela equação das frequências
the-absorber-is-tuned-to-it = O absorvedor é sintonizado nela.
the-results-are-ratios = Os resultados são razões.
the-minimum-peak = O pico mínimo
the-main-system-and-its-absorber = O sistema principal e o seu absorvedor
the-main-system-and-its-damped-absorber = O sistema principal e o seu absorvedor amortecido
the-same-damping-relative-to-the-main-frequency-c-2-m-a-m = O mesmo amortecimento em relação à frequência principal, c/(2 m_a ω_m)
the-softest-and-lightest-absorber-that-does-not-exceed-this-rotation = O absorvedor mais flexível e mais leve que não excede esta rotação.
the-softest-and-lightest-absorber-whose-mass-does-not-exceed-this-displacement = O absorvedor mais flexível e mais leve cuja massa não excede este deslocamento.
their-difference = A sua diferença
torsional-stiffness-of-its-springs = Rigidez torcional das suas molas
trial-absorber = Absorvedor de ensaio
tuned-by-the-fixed-points-den-hartog = Sintonizado pelos pontos fixos (Den Hartog)
tuned-for-the-minimum-peak = Sintonizado para o pico mínimo
tuning = Sintonia
tuning-and-damping-given = Sintonia e amortecimento dados
tuning-by-the-fixed-points = Sintonia pelos pontos fixos
tuning-by-the-fixed-points-the-two-frequencies-at-which-the-response-is-independent-of-damping = Sintonia pelos pontos fixos: as duas frequências em que a resposta não depende do amortecimento, levadas à mesma altura
tuning-of-the-absorber-to-the-exact-main-system = Sintonia do absorvedor em relação ao sistema principal exato
optimum-tuning-minimum-peak = Sintonia ótima, pico mínimo
optimum-tuning-with-this-damping-of-the-main-system-two-peaks-of-equal-height-where-no-change-lowers = Sintonia ótima com este amortecimento do sistema principal: dois picos da mesma altura, onde nenhuma mudança abaixa os dois (método de Newton)
optimum-tuning-exact-two-peaks-of-equal-and-minimum-height = Sintonia ótima, exata: dois picos de altura igual e mínima
tuning-absorber-frequency-over-main-system-frequency-uncoupled = Sintonia: frequência do absorvedor sobre a do sistema principal, desacoplados
tuning-absorber-frequency-speed-over-main-system-frequency = Sintonia: frequência do absorvedor (= rotação) sobre a do sistema principal
undamped-vibration-absorber = Absorvedor de vibrações sem amortecimento
moment-of-the-springs-about-the-centre-for-a-unit-rotation-one-by-one = momento das molas em torno do centro para uma rotação unitária, uma a uma
main-system-by-the-mean-sum-of-the-squares-of-its-resonances-with-the-trial-absorber-as-eigenvalues = sistema principal pela média: soma dos quadrados das suas ressonâncias com o absorvedor de ensaio, como autovalores
upper-limit-of-the-range-over-the-frequency-of-the-absorber = Limite superior da faixa, sobre a frequência do absorvedor
upper-limit-of-the-range-over-the-speed = Limite superior da faixa, sobre a rotação
upper-fixed-point = Ponto fixo superior
upper-resonance = Ressonância superior
upper-resonance-measured = Ressonância superior medida
upper-resonance-over-the-frequency-of-the-absorber = Ressonância superior sobre a frequência do absorvedor
upper-resonance-over-the-speed = Ressonância superior sobre a rotação
upper-resonance-frequency-ratio = Ressonância superior, razão de frequências
viscous-without-spring-houdaille-optimum-damping = Viscoso sem mola (Houdaille), amortecimento ótimo
viscous-without-spring-damping-given = Viscoso sem mola, amortecimento dado
without-the-absorber = Sem o absorvedor.
a-stiffness-a-damping-coefficient-or-a-frequency-needs-masses-and-springs-of-the-main-system-write = uma rigidez, um coeficiente de amortecimento ou uma frequência precisam das massas e das molas do sistema principal: escreva-as, ou dê razões
optimum-damping-by-newton-s-method = amortecimento ótimo pelo método de Newton
height-of-the-fixed-point-with-the-masses-locked-together = altura do ponto fixo, com as massas solidárias
height-of-the-lower-fixed-point-with-the-masses-locked-together = altura do ponto fixo inferior, com as massas solidárias
height-of-the-upper-fixed-point-with-the-masses-locked-together = altura do ponto fixo superior, com as massas solidárias
minimum-peak-by-newton-s-method = pico mínimo pelo método de Newton
locked = travado
lower-resonance-as-an-eigenvalue-of-the-two-mass-system = ressonância inferior, como autovalor do sistema de duas massas
magnification-at-the-peak-from-the-equations-of-both-masses = amplificação no pico pelas equações das duas massas
magnification-at-this-frequency-from-the-equations-of-both-masses = amplificação nesta frequência pelas equações das duas massas
motion-of-the-absorber-from-the-equations-of-both-masses = movimento do absorvedor pelas equações das duas massas
there-is-no-damping-and-this-frequency-is-a-resonance-the-motion-grows-with-time-without-bound = não há amortecimento e esta frequência é uma ressonância: o movimento cresce com o tempo sem limite
there-is-no-damping-at-both-resonances-the-motion-grows-with-time-without-bound-and-there-is-no-peak = não há amortecimento: nas duas ressonâncias o movimento cresce com o tempo sem limite, e não há pico
one-resonance-at-the-end-of-the-range-as-an-eigenvalue = uma ressonância no extremo da faixa, como autovalor
relative-motion-from-the-equations-of-both-masses = movimento relativo pelas equações das duas massas
relative-motion-over-static-deflection = movimento relativo sobre deflexão estática
resonance = ressonância
that-magnification-from-the-equations-of-both-masses = essa amplificação pelas equações das duas massas
the-absorber-is-not-tuned-to-the-speed-the-main-system-still-vibrates = o absorvedor não está sintonizado na rotação: o sistema principal continua a vibrar
the-forces-on-the-main-system-balance = as forças sobre o sistema principal se equilibram
the-highest-of-all-peaks = o mais alto de todos os picos
the-minimum-peak-by-newton-s-method = o pico mínimo pelo método de Newton
the-lower-frequency-peak = o pico de menor frequência
the-main-system-is-damped-it-has-no-fixed-points-whose-formulas-hold-only-for-an-undamped-one-the = o sistema principal é amortecido: não tem pontos fixos, cujas fórmulas só valem para um sistema sem amortecimento; o pico mínimo leva em conta o seu amortecimento
the-main-system-is-so-heavily-damped-that-its-response-with-this-absorber-has-no-peaks-to-equalise = o sistema principal é tão amortecido que a sua resposta com este absorvedor não tem picos a igualar: escreva um fator de amortecimento menor, ou um absorvedor mais pesado
the-main-system-is-so-heavily-damped-that-there-are-no-two-peaks-to-equalise-there-is-no-minimum-peak = o sistema principal é tão amortecido que não há dois picos a igualar: não existe pico mínimo
the-main-system-is-at-rest = o sistema principal fica em repouso
the-mass-ratio-of-the-absorber-is-not-between-0-000001-and-1000000-where-an-absorber-means-something = a razão de massas do absorvedor não está entre 0,000001 e 1000000, onde um absorvedor tem sentido
mean-of-the-squares-of-the-two-damping-ratios-with-a-horizontal-tangent-at-a-fixed-point = média dos quadrados dos dois amortecimentos com tangente horizontal num ponto fixo
the-natural-frequency-of-the-absorber-does-not-lie-between-the-two-resonances-as-it-must-for-any = a frequência natural do absorvedor não fica entre as duas ressonâncias, como deve ser em todo absorvedor sem amortecimento: confira as frequências medidas
the-range-does-not-contain-the-speed-to-which-the-absorber-is-tuned-whose-resonances-enclose-it-write = a faixa não contém a rotação em que o absorvedor está sintonizado, entre cujas ressonâncias ela fica: escreva uma rotação mínima abaixo dela e uma máxima acima dela
the-resonances-lie-outside-of-that-range-with-any-absorber-however-light-as-the-natural-frequency-of = as ressonâncias ficam fora dessa faixa com qualquer absorvedor, por mais leve que seja, pois a frequência natural do sistema principal não está nela: dê o curso ou a massa do absorvedor
the-response-of-the-main-system-has-no-peak-it-is-largest-at-frequency-zero = a resposta do sistema principal não tem pico: ela é máxima na frequência zero
the-speed-is-one-of-the-two-resonances-the-motion-with-the-absorber-grows-with-time-without-bound = a rotação é uma das duas ressonâncias: o movimento com o absorvedor cresce com o tempo sem limite
the-speed-is-the-natural-frequency-without-the-absorber-and-without-damping-the-motion-grows-with = a rotação é a frequência natural: sem o absorvedor e sem amortecimento o movimento cresce com o tempo sem limite
the-stroke-of-the-absorber-follows-from-the-force-write-the-excitation = o curso do absorvedor decorre da força: escreva a excitação
the-trial-absorber-is-not-tuned-to-the-natural-frequency-of-the-main-system-the-mean-of-the-mass = o absorvedor de ensaio não está sintonizado na frequência natural do sistema principal: a média das razões de massas erra { $off }; use o sistema principal exato
the-higher-frequency-peak = o pico de maior frequência
upper-resonance-as-an-eigenvalue-of-the-two-mass-system = ressonância superior, como autovalor do sistema de duas massas
with-the-absorber = com o absorvedor
without-it = sem ele
without-resonance = sem ressonância
without-the-absorber-and-without-damping-the-amplitude-at-resonance-grows-without-bound = sem o absorvedor e sem amortecimento, a amplitude na ressonância cresce sem limite
c-2-m-a-m-as-in-den-hartog = γ = c/(2 m_a ω_m), como em Den Hartog.
# rotor-dynamics
rotor-on-bearings-by-finite-elements = Rotor sobre mancais por elementos finitos
area-of-the-orbit-divided-by-the-sum-of-the-squares-of-its-amplitudes-b-a-a-b = área da órbita dividida pela soma dos quadrados das suas amplitudes, b a/(a² + b²)
amplitude-and-phase-along-x-component-in-phase = amplitude e fase ao longo de x: componente em fase
amplitude-and-phase-along-x-component-leading-by-90 = amplitude e fase ao longo de x: componente adiantada de 90°
natural-frequencies-with-direction-of-whirl-and-damping-critical-speeds-unbalance-response-and = Frequências naturais com sentido da precessão e amortecimento, velocidades críticas, resposta ao desbalanceamento e limiar de estabilidade de um eixo escalonado com discos sobre mancais.
shaft-segments = Trechos do eixo
from-left-to-right = Da esquerda para a direita.
material-of-the-shaft = Material do eixo
supports = Apoios
unbalances = Desbalanceamentos
maximum-speed-of-the-diagrams = Rotação máxima dos diagramas
upper-limit-of-the-search-for-critical-speeds-and-the-stability-threshold = Limite superior da busca das velocidades críticas e do limiar de estabilidade.
frequency-of-the-excitation-over-the-speed = Frequência da excitação sobre a rotação
n-1-for-unbalance-2-for-a-non-circular-shaft-the-slope-of-the-line-in-the-campbell-diagram = 1 para desbalanceamento; 2 para um eixo que não é circular; a inclinação da reta no diagrama de Campbell.
position-of-the-response = Posição da resposta
distance-from-the-left-end-by-default-that-of-the-first-unbalance = Distância à extremidade esquerda; por omissão, a do primeiro desbalanceamento.
axial-tension-of-the-shaft = Tração axial do eixo
negative-for-compression = Negativa para compressão.
bending-of-the-shaft = Flexão do eixo
elements-per-segment = Elementos por trecho
between-neighbouring-steps-of-the-shaft-discs-supports-and-unbalances = Entre mudanças de seção do eixo, discos, apoios e desbalanceamentos vizinhos.
length-of-the-segment = Comprimento do trecho
outer-diameter-at-the-right-end = Diâmetro externo na extremidade direita
only-for-a-tapered-segment = Somente para um trecho cônico.
omit-for-a-solid-shaft = Omitido para um eixo maciço.
also-gives-poisson-s-ratio-for-the-shear-factor = Dá também o coeficiente de Poisson usado no fator de cisalhamento.
internal-damping = Amortecimento interno
no-internal-damping = Sem amortecimento interno
viscous-internal-damping = Amortecimento interno viscoso
coefficient-of-internal-rotating-damping = Coeficiente de amortecimento interno (rotativo)
stress-e-d-dt = Tensão E (ε + ηᵥ dε/dt).
hysteretic-internal-damping = Amortecimento interno histerético
place = Posição
position = Posição
distance-from-the-left-end-of-the-shaft = Distância à extremidade esquerda do eixo.
size-of-the-disc = Tamanho do disco
diameters-and-width = Diâmetros e largura
outer-diameter-of-the-disc = Diâmetro externo do disco
bore-of-the-disc = Furo do disco
the-diameter-of-the-shaft-that-runs-through-it = O diâmetro do eixo que passa por ele.
width-of-the-disc = Largura do disco
density-of-the-disc = Massa específica do disco
mass-and-moments-of-inertia = Massa e momentos de inércia
moment-of-inertia-about-the-axis = Momento de inércia em torno do eixo
bearing = Mancal
the-same-in-every-direction = Igual em todas as direções
different-along-x-and-y = Diferente ao longo de x e y
stiffness-along-x = Rigidez ao longo de x
stiffness-along-y = Rigidez ao longo de y
damping-along-x = Amortecimento ao longo de x
damping-along-y = Amortecimento ao longo de y
eight-coefficients = Oito coeficientes
stiffness-k-xx = Rigidez k_xx
stiffness-k-xy = Rigidez k_xy
stiffness-k-yx = Rigidez k_yx
stiffness-k-yy = Rigidez k_yy
force-along-x-due-to-motion-along-y = Força ao longo de x devida a um movimento ao longo de y.
damping-c-xx = Amortecimento c_xx
damping-c-xy = Amortecimento c_xy
damping-c-yx = Amortecimento c_yx
damping-c-yy = Amortecimento c_yy
table-of-coefficients-against-speed = Tabela de coeficientes em função da rotação
rows-of-the-table = Linhas da tabela
in-order-of-increasing-speed-linear-between-rows-all-requested-speeds-must-lie-within-the-table-a = Por rotação crescente, linear entre linhas; todas as rotações pedidas devem ficar dentro da tabela. Uma única linha vale para todas as rotações.
rigid-free-to-tilt = Rígido, livre para inclinar
rigid-not-free-to-tilt = Rígido, sem inclinação
speed-for-this-row = Rotação desta linha
mass-times-its-distance-from-the-axis = Massa vezes a sua distância ao eixo.
angle-of-the-unbalance-on-the-shaft = Posição angular do desbalanceamento no eixo
timoshenko-bending-and-shear = Timoshenko: flexão e cisalhamento
euler-bernoulli-bending-alone = Euler–Bernoulli: somente flexão
mass-of-the-segment = Massa do trecho
mass-of-the-rotor-shaft-and-discs = Massa do rotor: eixo e discos
rotor-mass-from-a-lateral-rigid-translation-of-all-nodes-in-the-mass-matrix = massa do rotor por uma translação lateral rígida de todos os nós na matriz de massa
no-mode-oscillates-all-motions-are-overdamped-reduce-the-bearing-damping = nenhum modo oscila: todos os movimentos são superamortecidos; diminua o amortecimento dos mancais
the-inner-diameter-of-a-shaft-segment-is-not-below-the-outer-one-write-the-larger-one-as-the-outer = o diâmetro interno de um trecho do eixo não é menor que o externo: escreva o maior como externo
place-is-not-on-the-shaft-which-is-length-long-place-discs-supports-and-unbalances-on-it = { $place } não está no eixo, que tem { $length } de comprimento: ponha discos, apoios e desbalanceamentos sobre ele
the-speeds-of-a-bearing-table-must-increase-from-row-to-row-and-at-least-one-row-is-required = as rotações da tabela de um mancal devem crescer de linha a linha, e é necessária ao menos uma linha
damped-natural-frequency-of-mode-n-eigenvalue-i-of-m-c-g-k-assembled-from-shaft-elements-discs-and = Frequência natural amortecida do modo { $n }: autovalor λ = σ + iω de λ²M + λ(C + ΩG) + K, montado com os elementos do eixo, os discos e os apoios
the-same-in-hertz = A mesma em hertz
growth-rate-real-part-of-the-eigenvalue-negative-if-the-motion-decays = Taxa de crescimento: parte real do autovalor; negativa se o movimento decai
damping-ratio-from-the-real-part-and-modulus-of-the-eigenvalue = Fator de amortecimento, da parte real e do módulo do autovalor
logarithmic-decrement-the-decrease-over-one-period-2 = Decremento logarítmico: a redução em um período 2π/ω
the-decrement-from-the-damping-ratio-2-1 = o decremento pelo fator de amortecimento, δ = 2πζ/√(1 − ζ²)
whirl-ratio-of-minor-to-major-axis-of-the-orbit-where-it-is-largest-positive-for-forward-whirl-the = Precessão: razão entre o eixo menor e o maior da órbita onde ela é maior, positiva para precessão direta; o modo { $direction }
axis-ratio-b-a-forward-whirl = Razão dos eixos b/a, precessão direta
axis-ratio-b-a-backward-whirl = Razão dos eixos b/a, precessão retrógrada
axis-ratio-b-a-of-the-largest-orbit-mixed-whirl = Razão dos eixos b/a da maior órbita, precessão mista
axis-ratio-b-a-motion-in-a-plane = Razão dos eixos b/a, movimento em um plano
critical-speed-with-s-free-whirl-obeys-k-m-ig-s-v-0-an-eigenproblem-for-the-whirl-direction = Velocidade crítica: com ω = sΩ a precessão livre obedece a (K − ω²(M − iG/s)) v = 0, um problema de autovalor em ω; a precessão { $direction }
critical-speed-intersection-of-a-damped-natural-frequency-with-s-the-whirl-direction = Velocidade crítica: interseção de uma frequência natural amortecida com sΩ; a precessão { $direction }
there-is-no-critical-speed-up-to-the-highest-speed-of-the-diagrams = não há velocidade crítica até a maior rotação dos diagramas
a-non-oscillatory-motion-grows-the-bearings-push-the-shaft-away-at-some-of-the-speeds = um movimento não oscilatório cresce: os mancais repelem o eixo em algumas das rotações
mode-n-near-frequency-could-not-be-refined-on-the-equations-of-all-nodes-it-is-omitted = o modo { $n }, perto de { $frequency }, não pôde ser refinado nas equações de todos os nós: foi omitido
at-this-frequency-the-powers-of-inertia-rotation-damping-and-stiffness-balance-for-the-mode-shape = nesta frequência as potências de inércia, rotação, amortecimento e rigidez se equilibram na forma modal
at-this-growth-rate-the-powers-of-inertia-rotation-damping-and-stiffness-balance-for-the-mode-shape = nesta taxa de crescimento as potências de inércia, rotação, amortecimento e rigidez se equilibram na forma modal
at-this-speed-a-natural-frequency-from-the-equations-of-all-nodes-is-the-required-multiple-of-the = nesta rotação uma frequência natural das equações de todos os nós é o múltiplo exigido da rotação
the-critical-speed-near-speed-could-not-be-refined-on-the-equations-of-all-nodes-it-is-omitted = a velocidade crítica perto de { $speed } não pôde ser refinada nas equações de todos os nós: foi omitida
no-mode-can-grow-up-to-the-highest-speed-of-the-diagrams-every-stiffness-is-symmetric-and-damping = nenhum modo pode crescer até a maior rotação dos diagramas: toda rigidez é simétrica, e o amortecimento só dissipa energia
the-limit-of-stability-near-speed-could-not-be-refined-on-the-equations-of-all-nodes-it-is-omitted = o limite de estabilidade perto de { $speed } não pôde ser refinado nas equações de todos os nós: foi omitido
no-mode-grows-at-the-count-speeds-examined-up-to-the-highest-speed-of-the-diagrams = nenhum modo cresce nas { $count } rotações examinadas até a maior rotação dos diagramas
at-the-limit-of-stability-the-mode-neither-grows-nor-decays = no limite de estabilidade o modo não cresce nem decai
uniform-rotor-on-soft-bearings-euler-bernoulli = Rotor uniforme sobre mancais flexíveis, Euler-Bernoulli
the-same-rotor-with-more-elements = O mesmo rotor com mais elementos
the-same-rotor-on-bearings-ten-times-as-stiff-at-rest = O mesmo rotor sobre mancais dez vezes mais rígidos, em repouso
a-thick-shaft-on-soft-bearings-at-rest = Um eixo grosso sobre mancais moles, em repouso
two-restoring-springs-and-no-compression-it-cannot-be-statically-unstable = Duas molas restauradoras e nenhuma compressão: não pode ser estaticamente instável.
two-discs-on-very-soft-bearings-bending-alone-forty-elements-in-a-stretch = Dois discos sobre mancais muito moles, só flexão, quarenta elementos em cada trecho
two-discs-on-very-soft-bearings-twenty-elements-in-a-stretch = Dois discos sobre mancais muito moles, vinte elementos em cada trecho
two-discs-on-damped-bearings = Dois discos sobre mancais amortecidos
the-rotor-of-ex-5-9-5-of-friswell-et-al = O rotor do ex. 5.9.5 de Friswell et al.
a-band-of-instability-between-two-speeds-of-the-diagrams = Uma faixa de instabilidade entre duas rotações dos diagramas
the-same-rotor-far-below-the-band = O mesmo rotor muito abaixo da faixa
a-threshold-of-stability-far-below-the-highest-speed-7200-rpm = Um limiar de estabilidade muito abaixo da maior rotação, 7200 rpm
a-threshold-of-stability-far-below-the-highest-speed-30000-rpm = Um limiar de estabilidade muito abaixo da maior rotação, 30000 rpm
the-same-elements-assembled-by-crates-mechanics-tests-reference-rotors-py-mpmath-1-4-1-40-digits = Os mesmos elementos montados por crates/mechanics/tests/reference/rotors.py (mpmath 1.4.1, 40 algarismos)
the-same-elements-assembled-in-closed-form-eigenvalues-by-lapack-numpy-2-4-6 = Os mesmos elementos montados em forma fechada, autovalores por LAPACK (NumPy 2.4.6)
stability-threshold-unstable-above-this-speed-whirl-direction = Limiar de estabilidade: acima desta rotação um modo é instável; precessão { $direction }
further-stability-threshold = Outro limiar de estabilidade
a-mode-is-unstable-even-at-rest-the-rotor-is-unstable-at-every-speed-examined = um modo é instável mesmo em repouso: o rotor é instável em todas as rotações examinadas
a-mode-is-unstable-even-at-rest = um modo é instável mesmo em repouso
upper-limit-of-the-instability-above-this-speed-the-mode-is-stable-again-whirl-direction = Limite superior da instabilidade: acima desta rotação o modo volta a ser estável; precessão { $direction }
upper-limit-of-the-instability = Limite superior da instabilidade
a-mode-is-unstable-between-from-and-to-the-rotor-is-unstable-there = um modo é instável entre { $from } e { $to }: o rotor é instável ali
the-search-for-the-modes-of-this-rotor-did-not-converge-this-is-a-limitation-of-the-program-not-of = a busca dos modos deste rotor não convergiu; isso é uma limitação do programa, não do rotor: outro número de elementos pode evitá-la
limit-of-stability-0 = limite de estabilidade, δ = 0
stability-threshold = Limiar de estabilidade
the-speed-lies-above-the-stability-threshold-threshold-the-whirl-grows-until-another-effect-limits-it = a rotação está acima do limiar de estabilidade, { $threshold }: a precessão cresce até que outro efeito a limite
unbalance-response-m-i-c-g-k-q-m-e-e-i-motion-along-x-in-phase-with-the-mark-on-the-shaft = Resposta ao desbalanceamento (−Ω²M + iΩ(C + ΩG) + K) q = Ω² m e e^(iδ): movimento ao longo de x em fase com a marca no eixo
the-same-90-ahead-of-the-mark = O mesmo, 90° à frente da marca
motion-along-y-in-phase-with-the-mark-on-the-shaft = Movimento ao longo de y em fase com a marca no eixo
radius-of-the-forward-rotating-component = Raio da componente de precessão direta
radius-of-the-backward-rotating-component = Raio da componente de precessão retrógrada
semi-major-axis-of-the-orbit-maximum-deflection-zero-to-peak = Semieixo maior da órbita: deflexão máxima, zero a pico
semi-minor-axis-of-the-orbit-negative-for-backward-whirl = Semieixo menor da órbita, negativo na precessão retrógrada
amplitude-along-x-zero-to-peak = Amplitude ao longo de x, zero a pico
amplitude-along-y-zero-to-peak = Amplitude ao longo de y, zero a pico
the-forces-of-inertia-damping-and-stiffness-of-this-motion-balance-the-unbalance-at-every-node = as forças de inércia, amortecimento e rigidez deste movimento equilibram o desbalanceamento em cada nó
the-squares-of-the-two-semi-axes-sum-to-those-of-the-two-amplitudes = os quadrados dos dois semieixos somam o mesmo que os das duas amplitudes
semi-major-axis-of-the-orbit = Semieixo maior da órbita
semi-minor-axis-of-the-orbit-forward-whirl = Semieixo menor da órbita, precessão direta
semi-minor-axis-of-the-orbit-backward-whirl = Semieixo menor da órbita, precessão retrógrada
amplitude-along-x = Amplitude ao longo de x
amplitude-along-y = Amplitude ao longo de y
phase-lead-of-the-motion-along-x-relative-to-the-mark-on-the-shaft = Avanço de fase do movimento ao longo de x em relação à marca no eixo
phase-lead-along-x-relative-to-the-mark = Avanço de fase ao longo de x, em relação à marca
the-mesh-is-coarse-with-twice-as-many-elements-a-frequency-changes-by-change-write-more-elements = a malha é grosseira: com o dobro de elementos uma frequência muda { $change }; escreva mais elementos
count-motions-at-this-speed-are-overdamped-they-return-almost-without-oscillating-and-are-not-listed = { $count } movimentos nesta rotação são superamortecidos: voltam quase sem oscilar e não constam entre os modos
one-motion-at-this-speed-is-overdamped-it-returns-almost-without-oscillating-and-is-not-listed-among = um movimento nesta rotação é superamortecido: volta quase sem oscilar e não consta entre os modos
a-mode-is-unstable-at-this-speed-the-rotor-is-unstable-there = um modo é instável nesta rotação: o rotor é instável ali
a-disc-is-thin-i-p-greater-than-i-d-the-gyroscopic-effect-stiffens-its-forward-tilting-so-much-that = um disco é fino, I_p maior que I_d: o efeito giroscópico enrijece tanto a sua inclinação direta que ela não tem velocidade crítica síncrona; só a precessão retrógrada do disco cruza a reta
a-bearing-has-only-one-of-k-xy-and-k-yx-is-its-partner-missing-an-elastic-support-has-both-alike-a = um mancal tem só um de k_xy e k_yx: falta o outro? um apoio elástico tem os dois iguais, um filme fluido tem os dois com sinais opostos
the-speed-speed-lies-outside-the-bearing-table-of-support-n-which-goes-from-from-to-to-write-a-speed = a rotação { $speed } está fora da tabela do mancal { $n }, que vai de { $from } a { $to }: escreva uma rotação dentro dela ou acrescente linhas à tabela
the-highest-speed-of-the-diagrams-speed-lies-outside-the-bearing-table-of-support-n-which-goes-from = a maior rotação dos diagramas, { $speed }, está fora da tabela do mancal { $n }, que vai de { $from } a { $to }: escreva uma rotação dentro dela ou acrescente linhas à tabela
a-mode-is-unstable-even-at-the-lowest-speed-of-the-bearing-tables-speed-the-stability-threshold-lies = um modo é instável já na menor rotação das tabelas dos mancais, { $speed }: o limiar de estabilidade fica abaixo dela
forward-whirl-n = precessão direta, { $n }
backward-whirl-n = precessão retrógrada, { $n }
at-the-given-stiffness = na rigidez dada
undamped-critical-speeds-against-bearing-stiffness = Velocidades críticas não amortecidas em função da rigidez dos mancais
stiffness-of-the-first-bearing-the-others-in-proportion = rigidez do primeiro mancal, as outras em proporção
this-model-of-hysteretic-damping-destabilises-every-forward-whirl-at-every-speed-in-a-real-shaft-this = este modelo de amortecimento histerético desestabiliza toda precessão direta em toda rotação; em um eixo real isso só ocorre acima da velocidade crítica do modo
rotates-forward = gira no sentido direto
rotates-backward = gira no sentido retrógrado
rotates-forward-at-some-points-and-backward-at-others = gira no sentido direto em alguns pontos e no retrógrado em outros
stays-in-a-plane = fica em um plano
the-shaft-would-have-more-than-400-elements-write-fewer-elements-in-every-segment = o eixo teria mais de 400 elementos: escreva menos elementos em cada trecho
the-rotor-is-statically-unstable-the-compression-buckles-the-shaft-or-a-bearing-has-negative = o rotor é estaticamente instável: a compressão flamba o eixo, ou um mancal tem rigidez negativa
no-node-of-the-shaft-can-move-write-more-elements-in-every-segment-or-check-masses-and-densities = nenhum nó do eixo pode se mover: escreva mais elementos em cada trecho, ou confira massas e massas específicas
speed-is-a-critical-speed-without-damping-the-unbalance-response-is-unbounded-and-grows-with-time = { $speed } é uma velocidade crítica sem amortecimento: a resposta ao desbalanceamento é ilimitada e cresce com o tempo
the-values-of-this-rotor-are-outside-the-range-of-computation-check-units-diameters-and-stiffnesses = os valores deste rotor estão fora da faixa de cálculo: confira unidades, diâmetros e rigidezes
moment-of-inertia-of-the-disc-about-the-axis = Momento de inércia do disco em torno do eixo
moment-of-inertia-of-the-disc-about-a-diameter = Momento de inércia do disco em torno de um diâmetro
the-bore-of-a-disc-is-not-below-its-outer-diameter-write-the-larger-one-as-the-outer = o furo de um disco não é menor que o seu diâmetro externo: escreva o maior como externo
modes-at-this-speed-and-with-twice-as-many-elements = Modos nesta rotação, e com o dobro de elementos
whirl = precessão
f-finer-mesh = f, malha mais fina
change = variação
campbell-diagram = Diagrama de Campbell
critical-speed-n = velocidade crítica { $n }
critical-speeds-first-last = velocidades críticas { $first }–{ $last }
stability-map = Mapa de estabilidade
mode-n = modo { $n }
unbalance-response-zero-to-peak = Resposta ao desbalanceamento, zero a pico
semi-axes-of-the-orbit = semieixos da órbita
semi-major-axis = semieixo maior
semi-minor-axis = semieixo menor
phase-of-the-unbalance-response-along-x = Fase da resposta ao desbalanceamento ao longo de x
phase-ahead-of-the-mark = fase à frente da marca
the-rotor-with-the-places-of-its-parts-from-the-left-end = O rotor, com os lugares das suas partes a partir da extremidade esquerda
mode-n-at-frequency-it-direction = Modo { $n } em { $frequency }: { $direction }
mode-n-at-frequency = Modo { $n } em { $frequency }
order-speed = { $order }× rotação
mode-n-whirl = modo { $n }, { $whirl }
forward = direto
backward = retrógrado
mixed = misto
in-a-plane = em um plano
# vibration-instrument
maximum-permitted-ratio-of-reading-to-true-value = Razão máxima permitida entre leitura e valor verdadeiro
instrument = Instrumento
allowed-error = Erro admissível
of-the-amplitude-up-or-down-the-frequencies-within-it-are-reported = Da amplitude, para mais ou para menos: calculam-se as frequências dentro dele.
frequency-of-the-motion = Frequência do movimento
amplitude-and-phase-errors-are-computed-at-this-frequency = Calculam-se os erros de amplitude e de fase nessa frequência.
reading = Leitura
the-true-motion-at-that-frequency-is-computed = Calcula-se o movimento verdadeiro nessa frequência.
vibrometer-or-seismometer-displacement = Vibrômetro ou sismômetro: deslocamento
used-above-its-natural-frequency-where-the-seismic-mass-remains-at-rest = Usado acima da sua frequência natural, onde a massa sísmica permanece em repouso.
accelerometer = Acelerômetro
used-below-its-natural-frequency-where-the-seismic-mass-follows-the-base = Usado abaixo da sua frequência natural, onde a massa sísmica acompanha a base.
from-the-frequency-of-the-damped-free-vibration = Pela frequência da vibração livre amortecida
the-relative-motion-of-the-seismic-mass-as-a-vibrometer-shows-it = O movimento relativo da massa sísmica, como o mostra um vibrômetro.
amplitude-reading = Amplitude lida
zero-to-peak-write-mm-pp-for-a-peak-to-peak-reading = De zero a pico; escreva mm pp para uma leitura de pico a pico.
as-indicated-by-an-accelerometer = Como indicada por um acelerômetro.
acceleration-reading = Aceleração lida
vibrometer-and-accelerometer = Vibrômetro e acelerômetro
the-error-of-the-reading-at-that-frequency-equals-the-allowed-error = o erro da leitura nessa frequência é igual ao erro admissível
the-error-from-the-forces-of-inertia-spring-and-damper-for-a-unit-reading = o erro pelas forças de inércia, da mola e do amortecedor para uma leitura unitária
maximum-reading-zero-slope-of-the-reading-with-respect-to-frequency = leitura máxima: inclinação nula da leitura em relação à frequência
equation-of-the-relative-motion-under-the-true-displacement = equação do movimento relativo sob o deslocamento verdadeiro
equation-of-the-relative-motion-under-the-true-acceleration = equação do movimento relativo sob a aceleração verdadeira
equation-of-relative-motion-with-this-delay-component-in-phase-with-the-motion-of-the-case = equação do movimento relativo com esse atraso: componente em fase com o movimento da caixa
equation-of-relative-motion-with-this-delay-quadrature-component-90-ahead = equação do movimento relativo com esse atraso: componente em quadratura (90° à frente)
an-instrument-with-the-required-natural-frequency-reads-this-frequency-with-the-allowed-error = um instrumento com a frequência natural requerida lê esta frequência com o erro admissível
usable-frequencies-of-a-seismic-instrument-for-an-allowed-error-its-amplitude-and-phase-error-at-a = Frequências úteis de um instrumento sísmico para um erro admissível, o seu erro de amplitude e de fase numa frequência, e o movimento verdadeiro para uma leitura dada.
no-result-is-requested-write-an-allowed-error-the-frequency-of-the-motion-or-its-tones = nenhum resultado é pedido: escreva um erro admissível, a frequência do movimento ou os seus tons
harmonic-components-of-a-motion = Componentes harmônicas de um movimento
how-each-tone-is-recorded-and-whether-the-record-preserves-the-waveform = Como cada tom é registrado e se o registro preserva a forma de onda.
in-any-one-unit-only-the-shape-matters = Em uma unidade qualquer: só a forma importa.
write-at-least-one-tone-and-at-most-most = escreva ao menos um tom e no máximo { $most }
a-tone-of-the-motion-from-the-table = Um tom do movimento, da tabela
ratio-of-reading-to-true-value-of-this-tone = Razão entre leitura e valor verdadeiro deste tom
phase-lag-of-this-tone = Ângulo de fase (atraso) deste tom
phase-lag-of-this-tone-in-the-inverted-record-as-a-vibrometer-shows-it = Ângulo de fase (atraso) deste tom no registro invertido, como o mostra um vibrômetro
delay-of-this-tone = Atraso deste tom
ratio-of-reading-to-true-value-of-tone = Razão entre leitura e valor verdadeiro do tom
delay-of-tone = Atraso do tom
tone-n-equation-of-relative-motion-with-this-delay-in-phase-component = tom { $n }: equação do movimento relativo com esse atraso, componente em fase
tone-n-equation-of-relative-motion-with-this-delay-quadrature-component-90-ahead = tom { $n }: equação do movimento relativo com esse atraso, componente em quadratura (90° à frente)
phase-distortion-difference-between-the-delays = Distorção de fase: diferença entre os atrasos
phase-distortion = Distorção de fase
harmonic-components-of-the-motion-and-of-the-record = Componentes harmônicas do movimento e do registro
true = verdadeiro
recorded = registrado
delay = atraso
motion-and-record = Movimento e registro
in-the-unit-of-the-table = na unidade da tabela
true-motion = movimento verdadeiro
recorded-motion = movimento registrado
the-true-motion-behind-a-reading-needs-the-frequency-of-the-motion = o movimento verdadeiro por trás de uma leitura precisa da frequência do movimento
the-damped-natural-frequency-never-exceeds-the-natural-frequency-write-the-larger-frequency-as-the = a frequência natural amortecida nunca excede a frequência natural: escreva a maior frequência como a natural
damping-ratio-from-d-1 = Fator de amortecimento, de ω_d = ωₙ√(1 − ζ²)
the-damping-ratio-reproduces-the-damped-frequency = o fator de amortecimento reproduz a frequência amortecida
without-damping-the-reading-at-the-natural-frequency-grows-without-bound-there-is-no-steady-state = sem amortecimento, a leitura na frequência natural cresce sem limite: não há regime permanente
ratio-of-reading-to-true-displacement = Razão entre leitura e deslocamento verdadeiro
ratio-of-reading-to-true-acceleration = Razão entre leitura e aceleração verdadeira
the-same-from-the-square-of-the-frequency-ratio = o mesmo pelo quadrado da razão de frequências
error-of-the-amplitude-where-it-is-positive-the-reading-is-too-high = Erro da amplitude; onde é positivo, a leitura é alta demais
the-relative-motion-lags-the-motion-by = Ângulo de fase (atraso) do movimento relativo em relação ao movimento
time-delay-of-the-record-without-distortion-it-would-be-the-same-at-every-frequency = Atraso do registro; sem distorção, seria o mesmo em toda frequência
reading-over-true-value = Leitura sobre valor verdadeiro
ratio-of-reading-to-true-value = Razão entre leitura e valor verdadeiro
error-of-the-amplitude = Erro da amplitude
delay-of-the-record = Atraso do registro
true-amplitude-for-the-given-reading = Amplitude verdadeira para a leitura dada
its-acceleration = A sua aceleração
true-amplitude = Amplitude verdadeira
true-acceleration = Aceleração verdadeira
true-acceleration-for-the-given-reading = Aceleração verdadeira para a leitura dada
amplitude-of-the-motion-with-this-acceleration = Amplitude do movimento com essa aceleração
a-vibrometer-reads-a-displacement-write-the-reading-as-a-displacement = um vibrômetro lê um deslocamento: escreva a leitura como deslocamento
an-accelerometer-reads-an-acceleration-write-the-reading-as-an-acceleration = um acelerômetro lê uma aceleração: escreva a leitura como aceleração
these-numbers-lead-to-values-outside-the-representable-range = estes números levam a valores fora da faixa representável
frequency-ratio-at-which-the-allowed-error-is-reached-a-root-of-the-quadratic-equation-in-r-of-the = Razão de frequências em que o erro admissível é atingido: uma raiz da equação do segundo grau em r² do erro
the-error-of-the-reading-at-that-ratio-equals-the-allowed-error = o erro da leitura nessa razão é igual ao erro admissível
lowest-usable-frequency = Frequência útil mínima
lowest-frequency-above-which-the-error-stays-within-the-limit = Frequência mínima acima da qual o erro fica dentro do admissível
highest-usable-frequency = Frequência útil máxima
highest-frequency-below-which-the-error-stays-within-the-limit = Frequência máxima abaixo da qual o erro fica dentro do admissível
natural-frequency-of-an-instrument-of-this-damping-that-reads-this-frequency-exactly-at-the-error = Frequência natural de um instrumento com este amortecimento que lê esta frequência exatamente no limite de erro
natural-frequency-needed-at-this-frequency = Frequência natural necessária nesta frequência
damping-ratio-for-the-widest-band-the-peak-just-reaches-the-allowed-error = Fator de amortecimento para a faixa mais larga: o pico atinge exatamente o erro admissível
its-peak-is-the-allowed-error = o seu pico é o erro admissível
damping-ratio-for-the-widest-band = Fator de amortecimento para a faixa mais larga
the-reading-exceeds-the-true-value-by-the-allowed-error = a leitura é maior que a verdadeira pelo erro admissível
the-reading-is-below-the-true-value-by-the-allowed-error = a leitura é menor que a verdadeira pelo erro admissível
frequencies-within-the-allowed-error = Frequências dentro do erro admissível
frequency-of-maximum-reading = Frequência da leitura máxima
maximum-ratio-of-reading-to-true-value = Razão máxima entre leitura e valor verdadeiro
maximum-reading-at-its-frequency = leitura máxima na sua frequência
ratio-of-reading-to-true-value-against-frequency = Razão entre leitura e valor verdadeiro em função da frequência
this-instrument = este instrumento
usable = útil
the-seismic-mass-in-its-case = A massa sísmica na sua caixa
# vibration-isolation
worst-case-speed-within-the-range = Rotação mais desfavorável, dentro da faixa
frequency-ratio-at-maximum-force-the-slope-of-r-tr-is-zero-there = Razão de frequências na força máxima: nela a inclinação de r² TR é nula
the-slope-of-the-force-is-zero-at-that-speed = nessa rotação a inclinação da força é nula
frequency-ratio-at-maximum-amplitude = Razão de frequências na amplitude máxima
machine = Máquina
mass-of-the-inertia-block = Massa do bloco de inércia
an-inertia-block-under-the-machine-moves-with-it-less-motion-and-the-same-force-on-the-floor-for-the = Um bloco de inércia sob a máquina move-se com ela: menos movimento, e a mesma força no piso com a mesma deflexão estática.
number-of-mounts = Número de coxins
all-equal-each-carrying-its-share-of-the-weight = Todos iguais, cada um com a sua parte do peso.
mounts-for-a-required-isolation = Coxins para um isolamento exigido
required = Exigido
speeds = Rotações
disturbance = Perturbação
isolation-of-given-mounts = Isolamento de coxins dados
mounts = Coxins
total-of-all-mounts = Total de todos os coxins.
the-lowest-speed-at-which-these-mounts-reach-it-is-computed = Calcula-se a menor rotação em que estes coxins o alcançam.
mounts-for-a-shock = Coxins para um choque
arrival = Chegada
maximum-acceleration = Aceleração máxima
permitted-for-the-machine = Admissível para a máquina.
maximum-travel = Curso máximo
available-space-for-the-mounts = Espaço disponível para os coxins.
minimum-isolation = Isolamento mínimo
isolation = Isolamento
the-fraction-of-the-force-or-motion-that-is-not-transmitted-85-for-a-transmissibility-of-0-15 = A fração da força, ou do movimento, que não é transmitida: 85 % para uma transmissibilidade de 0,15.
for-a-machine-that-runs-at-more-than-one = Quando a máquina trabalha em mais de uma.
force-of-constant-amplitude = Força de amplitude constante
piston = Pistão
reciprocating-mass = Massa alternativa
stroke = Curso
twice-the-radius-of-the-crank = O dobro do raio da manivela.
vibration-and-shock-isolation = Isolamento de vibração e choque
stiffness-and-static-deflection-of-mounts-for-a-required-isolation-over-a-speed-range-the-isolation = Rigidez e deflexão estática de coxins para um isolamento exigido numa faixa de rotações, o isolamento de coxins dados, e coxins para um choque.
mass-on-the-mounts-machine-and-block = Massa sobre os coxins: máquina e bloco
highest-natural-frequency-the-lowest-speed-is-the-worst-case-since-the-transmissibility-falls-above = Maior frequência natural: a menor rotação é o pior caso, pois acima dela a transmissibilidade cai
maximum-total-stiffness-of-the-mounts = Rigidez total máxima dos coxins
total-damping-coefficient-of-the-mounts = Coeficiente de amortecimento total dos coxins
required-frequency-ratio = Razão de frequências necessária
minimum-speed-at-which-the-mounts-provide-the-required-isolation = Rotação mínima em que os coxins dão o isolamento exigido
minimum-speed-with-the-required-isolation = Rotação mínima com o isolamento exigido
static-deflection-under-the-weight-k-st-m-g = Deflexão estática sob o peso, k δ_st = m g
the-mounts-carry-the-weight = os coxins suportam o peso
mass-on-the-mounts = Massa sobre os coxins
total-stiffness-of-the-mounts = Rigidez total dos coxins
stiffness-of-each-mount-the-load-is-shared-equally = Rigidez de cada coxim: a carga se divide por igual
stiffness-of-each-mount = Rigidez de cada coxim
without-damping-the-motion-grows-without-bound-at-the-natural-frequency-which-lies-within-the-speed = sem amortecimento, o movimento cresce sem limite na frequência natural, que está dentro da faixa de rotações: escreva algum amortecimento, ou coxins mais macios
maximum-transmissibility-within-the-speed-range = Transmissibilidade máxima na faixa de rotações
these-mounts-do-not-provide-the-required-isolation-within-this-speed-range = estes coxins não dão o isolamento exigido nesta faixa de rotações
isolation-the-part-not-transmitted = Isolamento: a parcela não transmitida
the-mounts-amplify-within-this-speed-range-they-isolate-only-above-2-times-the-natural-frequency = os coxins amplificam nesta faixa de rotações: só isolam acima de √2 vezes a frequência natural
frequency-ratio-at-the-worst-case-speed = Razão de frequências na pior rotação
unbalance-of-the-piston-its-mass-times-half-the-stroke = Desbalanceamento do pistão: a sua massa vezes metade do curso
maximum-force-on-the-floor = Força máxima no piso
force-on-the-floor = Força no piso
maximum-amplitude-of-the-machine = Amplitude máxima da máquina
amplitude-of-the-machine = Amplitude da máquina
maximum-transmissibility-the-part-that-may-be-transmitted = Transmissibilidade máxima: a parcela que pode ser transmitida
required-frequency-ratio-from-t-1-r-1 = Razão de frequências necessária, de T = 1/(r² − 1)
the-transmissibility-is-t-where-r-2b-r-1-t-1 = A transmissibilidade vale T onde r⁴ − 2b r² = 1/T² − 1
required-frequency-ratio-the-positive-root = Razão de frequências necessária: a raiz positiva
the-transmissibility-at-that-ratio-is-the-required-one = a transmissibilidade nessa razão é a exigida
these-mounts = estes coxins
transmissibility-against-speed = Transmissibilidade em função da rotação
speeds-of-the-machine = rotações da máquina
the-machine-on-its-mounts = A máquina sobre os seus coxins
with-an-initial-velocity = Com velocidade inicial
from-a-height = De uma altura
velocity = Velocidade
height-of-the-fall = Altura da queda
final-velocity-of-the-fall = Velocidade final da queda
highest-natural-frequency-a-free-vibration-that-begins-with-v-has-the-acceleration-v = Maior frequência natural: uma vibração livre que começa com v₀ tem a aceleração v₀ωₙ
maximum-stiffness-from-the-acceleration = Rigidez máxima, pela aceleração
deflection-of-these-mounts-v-the-minimum-possible = Deflexão destes coxins, v₀/ωₙ: a mínima possível
the-kinetic-energy-on-arrival-is-stored-in-the-springs-at-the-end-of-the-travel = a energia cinética na chegada é armazenada nas molas no fim do curso
arrival-velocity = Velocidade de chegada
highest-natural-frequency = Maior frequência natural
deflection-of-the-stiffest-mounts = Deflexão dos coxins mais rígidos
minimum-stiffness-from-the-travel-k-d-m-v = Rigidez mínima, pelo curso: ½ k d² = ½ m v₀²
minimum-total-stiffness-of-the-mounts = Rigidez total mínima dos coxins
travel-limit = limite de curso
acceleration-limit = limite de aceleração
permitted-total-stiffness-of-the-mounts = Rigidez total permitida dos coxins
no-stiffness-satisfies-both-limits-the-travel-must-be-at-least-travel-with-this-acceleration = nenhuma rigidez respeita os dois limites: o curso deve ser de pelo menos { $travel } com essa aceleração
acceleration-against-stiffness = Aceleração em função da rigidez
acceleration = aceleração

# coulomb-damping
amplitude-of-the-first-half-cycle-about-that-position = Amplitude do primeiro meio ciclo em torno dessa posição
target-amplitude-of-the-decay = Amplitude final do decaimento
asked-amplitude = amplitude pedida
requested-amplitude = amplitude pedida
at-rest-static-friction-holds-the-mass-up-to-this-displacement = Em repouso, o atrito estático retém a massa até este deslocamento
at-the-requested-time = no instante pedido
with-viscous-damping-present-two-amplitudes-do-not-determine-the-friction-use-the-identification-from = com amortecimento viscoso presente, duas amplitudes não determinam o atrito: use a identificação por um registro de decaimento, ou escreva a força de atrito
from-the-overdamped-motion-about-the-shifted-equilibrium-position = Pelo movimento superamortecido em torno da posição de equilíbrio deslocada
coefficient-of-friction = Coeficiente de atrito
coefficient-of-friction-and-normal-force = Coeficiente de atrito e força normal
coefficient-of-friction-on-a-horizontal-surface = Coeficiente de atrito sobre superfície horizontal
sine-coefficient-in-that-half-cycle = Coeficiente do seno nesse meio ciclo
cycles = ciclos
cycles-for-the-amplitude-to-decay-to-the-requested-value = Ciclos para a amplitude cair até o valor pedido
cycles-of-that-decay = Ciclos desse decaimento
cycles-of-that-decay-as-a-fraction = Ciclos desse decaimento, em fração
cycles-of-that-decay-whole-half-cycles = Ciclos desse decaimento, em meios ciclos inteiros
cycles-to-rest = Ciclos até o repouso
cycles-two-half-cycles-each = Ciclos: dois meios ciclos cada
viscous-damping-ratio = Fator de amortecimento viscoso
decay = Decaimento
displacement-against-time = Deslocamento em função do tempo
displacement-at-that-time-free-vibration-about-the-shifted-equilibrium-position = Deslocamento nesse instante: vibração livre em torno da posição de equilíbrio deslocada
displacement-at-the-first-turning-point = Deslocamento no primeiro ponto de retorno
displacement-at-the-first-turning-point-by-step-by-step-integration = deslocamento no primeiro ponto de retorno por integração passo a passo
displacement-by-step-by-step-integration-of-the-equation-of-motion = deslocamento por integração passo a passo da equação de movimento
displacement-at-that-instant = Deslocamento nesse instante
energy-at-the-start = Energia inicial
initial-energy-energy-at-rest-friction-force-distance-travelled = energia inicial = energia em repouso + força de atrito × distância percorrida
equivalent-viscous-damping = Amortecimento viscoso equivalente
equivalent-viscous-damping-at-the-first-amplitude = Amortecimento viscoso equivalente na primeira amplitude
first-amplitude = Primeira amplitude
first-turning-point = primeiro ponto de retorno
first-turning-point-after-the-start = Primeiro ponto de retorno após o início
first-turning-point-after-the-start-zero-of-the-velocity-in-the-first-half-cycle = Primeiro ponto de retorno após o início: zero da velocidade no primeiro meio ciclo
for-the-coefficient-of-friction-on-a-horizontal-surface = Para o coeficiente de atrito sobre superfície horizontal.
free-vibration = Vibração livre
free-vibration-with-dry-friction = Vibração livre com atrito seco
frequency-of-the-half-cycles = Frequência dos meios ciclos
friction = Atrito
friction-force = Força de atrito
friction-force-given = Força de atrito dada
limit-of-the-sticking-zone = limite da zona de aderência
friction-stops-the-mass-before-it-decays-to-the-required-amplitude-write-one-above-the-half-width-of = o atrito detém a massa antes que ela decaia à amplitude pedida: escreva uma acima da meia largura da zona de aderência
friction-shifts-the-equilibrium-position-to-either-side-by-f-k = O atrito desloca a posição de equilíbrio de F/k para um lado ou para o outro
from-the-decrease-of-the-amplitude = Pela diminuição da amplitude
from-the-position-in-which-the-spring-is-unloaded = A partir da posição em que a mola está descarregada.
half-width-of-the-sticking-zone = Meia largura da zona de aderência
it-is-at-rest = Está em repouso
already-at-rest-at-its-rest-position = Já está em repouso, na sua posição de repouso
last-amplitude = Última amplitude
amplitude-decrease-per-cycle = Redução de amplitude por ciclo
amplitude-decrease-per-cycle-4f-k-the-same-in-each = Redução de amplitude por ciclo, 4F/k: a mesma em todos
amplitude-decrease-per-cycle-the-same-in-each = Redução de amplitude por ciclo: a mesma em todos
amplitude-decrease-number-of-cycles-stopping-time-and-position-and-exact-motion-of-a-mass-with-dry = Redução de amplitude, número de ciclos, instante e posição de parada e movimento exato de uma massa com atrito seco; atrito por um decaimento.
mass-or-weight = Massa ou peso
natural-frequency-friction-does-not-change-it = Frequência natural: o atrito não a altera
zero-velocity-at-the-first-turning-point = velocidade nula no primeiro ponto de retorno
normal-force = Força normal
phase-plane = Plano de fase
phase-plane-half-turns-about-the-two-shifted-equilibrium-positions = Plano de fase: meias voltas em torno das duas posições de equilíbrio deslocadas
rest-position = Posição de repouso
rest-position-by-step-by-step-integration-of-the-equation-of-motion = posição de repouso por integração passo a passo da equação de movimento
equilibrium-position-shifted-by-friction-against-the-motion = Posição de equilíbrio, deslocada pelo atrito contra o movimento
rest-position-friction-holds-the-mass-at-the-first-turning-point = Posição de repouso: o atrito segura a massa no primeiro ponto de retorno
position-approached-asymptotically-equilibrium-shifted-by-friction = Posição de aproximação assintótica: o equilíbrio deslocado pelo atrito
released-from-rest-the-start-is-a-turning-point = Solta do repouso: o início é um ponto de retorno
rest = repouso
amplitude-ratio-per-half-cycle-due-to-viscous-damping = Razão de amplitudes por meio ciclo devida ao amortecimento viscoso
start = início
initial-conditions = Condições iniciais
start-of-the-first-half-cycle-from-its-shifted-equilibrium-position-positive-forwards = Início do primeiro meio ciclo, a partir da sua posição de equilíbrio deslocada, positivo para a frente
start-of-the-half-cycle-from-the-shifted-equilibrium-position = Início do meio ciclo, a partir da posição de equilíbrio deslocada
start-of-the-half-cycle-that-contains-the-requested-time = Início do meio ciclo que contém o instante pedido
static-friction-over-kinetic-friction = Atrito estático sobre atrito cinético
half-cycles-after-the-first-turning-point = Meios ciclos após o primeiro ponto de retorno
half-cycles-to-rest-that-number-rounded-up = Meios ciclos até o repouso: esse número arredondado para cima
half-cycles-until-a-turning-point-is-no-farther-out-twice-that-number-rounded-up = Meios ciclos até que um ponto de retorno não esteja mais afastado: o dobro desse número, arredondado para cima
half-cycles-until-the-turning-point-would-reach-the-edge-of-the-sticking-zone = Meios ciclos até que o ponto de retorno atingisse a borda da zona de aderência
system = Sistema
the-target-amplitude-of-the-decay-is-not-below-the-first-one-write-a-smaller-one = a amplitude-alvo do decaimento não está abaixo da primeira: escreva uma menor
the-energy-difference-between-the-two-amplitudes-is-the-friction-work-over-the-path = a diferença de energia entre as duas amplitudes é o trabalho do atrito no percurso
the-last-amplitude-is-not-below-the-first-one-exchange-them = a última amplitude não está abaixo da primeira: troque-as
amplitude-decrease-per-cycle-4f-k = Redução de amplitude por ciclo: 4F/k
the-mass-on-its-spring-with-friction = A massa sobre a mola, com atrito
the-spring-does-not-overcome-the-friction-at-the-start-the-mass-remains-at-rest-write-a-larger = a mola não vence o atrito no início: a massa permanece em repouso; escreva um deslocamento maior, ou uma velocidade
the-turning-point-is-the-first-one-within-the-required-amplitude = o ponto de retorno é o primeiro dentro da amplitude pedida
the-viscous-damping-is-critical-or-higher-the-mass-does-not-oscillate-and-only-approaches-the-edge-of = o amortecimento viscoso é crítico ou maior: a massa não oscila, e apenas se aproxima da borda da zona de aderência
time-at-which-the-motion-is-required = Instante em que se pede o movimento
duration-of-a-half-cycle-from-one-turning-point-to-the-next = Duração de um meio ciclo, de um ponto de retorno ao seguinte
duration-of-that-decay = Duração desse decaimento
time-of-that-turning-point = Instante desse ponto de retorno
time-since-the-start-of-the-half-cycle = Tempo desde o início do meio ciclo
time-to-rest = Tempo até o repouso
time-to-rest-end-of-the-first-half-cycle = Tempo até o repouso: fim do primeiro meio ciclo
turning-points = Pontos de retorno
turning-points-satisfy-x-q-x-f-1-q-x-c-then-decreases-by-the-factor-q-in-each-half-cycle = Os pontos de retorno satisfazem Xₙ₊₁ = q Xₙ − f (1 + q); X + C então diminui pelo fator q em cada meio ciclo
velocity-at-that-time = Velocidade nesse instante
velocity-at-that-time-its-derivative = Velocidade nesse instante: sua derivada
velocity-by-step-by-step-integration-of-the-equation-of-motion = velocidade por integração passo a passo da equação de movimento
viscous = viscoso
viscous-damping-in-addition-to-friction = Amortecimento viscoso além do atrito
per-half-cycle-viscous-damping-reduces-the-distance-from-the-shifted-equilibrium-position-to-this = Por meio ciclo, o amortecimento viscoso reduz a esta fração a distância à posição de equilíbrio deslocada
viscous-damping-with-the-same-energy-loss-per-cycle-at-that-amplitude-it-increases-as-the-amplitude = Amortecimento viscoso com a mesma perda de energia por ciclo nessa amplitude; aumenta conforme a amplitude diminui
whole-half-cycles-in-cycles = Meios ciclos inteiros, em ciclos

# torsional-friction
amplitude-decrease-per-cycle-4-t-f-k-t-the-same-in-each = Redução da amplitude por ciclo, 4 T_f/k_t: a mesma em cada um
amplitude-decrease-per-cycle-4-t-f-k-t = Redução da amplitude por ciclo: 4 T_f/k_t
amplitude-decrease-number-of-cycles-stopping-time-and-angle-and-exact-motion-of-a-body-on-a-torsional = Redução da amplitude, número de ciclos, tempo e ângulo de parada, e movimento exato de um corpo numa mola de torção ou num eixo com um torque de atrito; torque de atrito a partir de um decaimento.
angle-at-that-instant = Ângulo nesse instante
angle-at-that-time-free-vibration-about-the-shifted-equilibrium-position = Ângulo nesse instante: vibração livre em torno da posição de equilíbrio deslocada
angle-at-the-first-turning-point = Ângulo no primeiro ponto de retorno
angular-velocity-at-that-time = Velocidade angular nesse instante
angular-velocity-at-that-time-its-derivative = Velocidade angular nesse instante: a sua derivada
at-rest-static-friction-holds-the-body-up-to-this-angle = Em repouso, o atrito estático retém o corpo até este ângulo
coefficient-of-friction-normal-force-and-radius = Coeficiente de atrito, força normal e raio
free-torsional-vibration-with-dry-friction = Vibração torcional livre com atrito seco
friction-shifts-the-equilibrium-position-to-either-side-by-t-f-k-t = O atrito desloca a posição de equilíbrio para um e outro lado de T_f/k_t
friction-torque = Torque de atrito
friction-torque-given = Torque de atrito dado
friction-torque-friction-force-times-its-radius = Torque de atrito: força de atrito vezes o seu raio
half-cycles-to-rest-before-rounding-up = Meios ciclos até o repouso, antes de arredondar para cima
inertia-of-the-body = Inércia do corpo
initial-angular-velocity = Velocidade angular inicial
radius-at-which-it-rubs = Raio em que atrita
the-disc-on-its-torsional-spring-with-friction = O disco na sua mola de torção, com atrito
torsional-spring-or-shaft = Mola de torção ou eixo
angle-at-the-first-turning-point-by-step-by-step-integration = ângulo no primeiro ponto de retorno por integração passo a passo
angle-by-step-by-step-integration-of-the-equation-of-motion = ângulo por integração passo a passo da equação do movimento
angular-velocity = Velocidade angular
angular-velocity-by-step-by-step-integration-of-the-equation-of-motion = velocidade angular por integração passo a passo da equação do movimento
friction-stops-the-body-before-it-decays-to-the-required-amplitude-write-one-above-the-half-width-of = o atrito para o corpo antes que ele decaia até a amplitude pedida: escreva uma acima da meia largura da zona de aderência
initial-energy-energy-at-rest-friction-torque-angle-travelled = energia inicial = energia em repouso + torque de atrito × ângulo percorrido
the-edge-of-the-sticking-zone-c-results-from-the-first-amplitude-c-after-those-half-cycles = a borda da zona de aderência + C resulta da primeira amplitude + C após esses meios ciclos
the-energy-difference-between-the-two-amplitudes-is-the-friction-work-over-the-angle-travelled = a diferença de energia entre as duas amplitudes é o trabalho do atrito ao longo do ângulo percorrido
the-energy-difference-down-to-the-edge-of-the-sticking-zone-is-the-friction-work-over-the-path-of = a diferença de energia até a borda da zona de aderência é o trabalho do atrito ao longo do percurso desses meios ciclos
the-torsional-spring-does-not-overcome-the-friction-at-the-start-the-body-remains-at-rest-write-a = a mola de torção não vence o atrito no início: o corpo permanece em repouso; escreva um ângulo maior, ou uma velocidade angular
the-viscous-damping-is-critical-or-higher-the-body-does-not-oscillate-and-only-approaches-the-edge-of = o amortecimento viscoso é crítico ou maior: o corpo não oscila, e apenas tende à borda da zona de aderência
with-viscous-damping-present-two-amplitudes-do-not-determine-the-friction-write-the-friction-torque = com amortecimento viscoso presente, duas amplitudes não determinam o atrito: escreva o torque de atrito
work-of-that-damper-in-a-cycle-summed-over-equal-steps-friction-torque-times-the-angle-4 = trabalho desse amortecedor em um ciclo, somado em passos iguais = torque de atrito vezes o ângulo 4Θ

# decay-identification
amplitudes-and-the-three-fits = Amplitudes e os três ajustes
exponential-linear-and-combined-fits-to-a-decay-record-viscous-damping-coulomb-friction-and-which-of = Ajustes exponencial, linear e combinado a um registro de decaimento: amortecimento viscoso, atrito de Coulomb e qual deles está presente.
at-least-four-a-trough-is-half-a-cycle-from-its-peak = Pelo menos quatro; um vale está a meio ciclo do seu pico.
both = ambos
combined-damping-ratio = Combinado: fator de amortecimento
combined-viscous-decrement = Combinado: decremento viscoso
combined-f-k = Combinado: F/k
both-scatter = Ambos: dispersão
combined-fit-residual = Combinado: resíduo do ajuste
combined-fit-viscous-decrement = Ajuste combinado: decremento viscoso
combined-fit-f-k-which-reduces-the-amplitude-by-f-1-q-per-half-cycle = Ajuste combinado: F/k, que reduz a amplitude de f (1 + q) por meio ciclo
combined-fit-amplitude-decrease-per-cycle-with-friction-alone = Ajuste combinado: redução de amplitude por ciclo só com atrito
combined-fit-by-least-squares-x-x-e-n-d-1-e-n-rms-residual = Ajuste combinado por mínimos quadrados: X = X₀ e^(−δn) − d (1 − e^(−δn))/δ; resíduo eficaz (rms)
coefficient-of-friction-on-a-horizontal-surface-f-mg-and-f-k-f = Coeficiente de atrito sobre superfície horizontal: F = µmg e F/k = f
cycles-since-the-first-amplitude = Ciclos desde a primeira amplitude
damped-natural-frequency = Frequência natural amortecida
damping-coefficient-c-2-k = Coeficiente de amortecimento: c = 2ζk/ωₙ
viscous-damping-ratio-from-the-combined-fit-below = Fator de amortecimento viscoso, do ajuste combinado abaixo
decrement = decremento
for-the-coefficient-of-friction-of-a-mass-on-a-horizontal-surface = Para o coeficiente de atrito de uma massa sobre superfície horizontal.
for-the-coefficient-of-friction-taken-from-the-record-where-that-has-times = Para o coeficiente de atrito; obtida do registro quando este tem tempos.
for-the-friction-force-and-the-damping-coefficient = Para a força de atrito e o coeficiente de amortecimento.
frequency-of-the-decaying-motion = Frequência do movimento que decai
friction-alone-f-k = Só atrito: F/k
friction-alone-amplitude-decrease-per-cycle = Só atrito: redução de amplitude por ciclo
friction-alone-fit-residual = Só atrito: resíduo do ajuste
friction-alone-x-x-x-n-by-least-squares-its-amplitude-decrease-per-cycle = Só atrito: X = X₀ − ΔX n por mínimos quadrados; sua redução de amplitude por ciclo
in-time-order-at-least-ten-per-cycle = Em ordem de tempo, pelo menos dez por ciclo.
its-rms-deviation-from-the-amplitudes = Seu desvio quadrático médio em relação às amplitudes
friction-loss-per-cycle = perda por atrito em um ciclo
mean-time-from-one-turning-point-of-the-record-to-the-next = Tempo médio de um ponto de retorno do registro ao seguinte
natural-frequency-without-damping-above-that-of-the-decay = Frequência natural sem amortecimento, acima da do decaimento
record = Registro
record-and-its-turning-points = Registro e seus pontos de retorno
samples = Amostras
samples-of-the-motion = Amostras do movimento
scatter = dispersão
residual-ratio-best-single-fit-over-combined = Razão de resíduos, melhor ajuste sobre o combinado
fit-residual-of-the-better-single-model-over-that-of-the-combined-model-well-above-1-only-the = Resíduo do melhor dos dois ajustes sobre o do ajuste combinado: muito acima de 1, só o combinado explica o registro
fit-residual-of-the-exponential-over-that-of-the-straight-line-below-1-indicates-viscous-damping = Resíduo do ajuste exponencial sobre o da reta: abaixo de 1 indica amortecimento viscoso, acima de 1, atrito; um resíduo abaixo de um milionésimo da amplitude é substituído por esse valor
residual-ratio-viscous-over-friction = Razão de resíduos, viscoso sobre atrito
fraction-of-the-range-below-which-an-extremum-counts-as-noise = Fração da faixa abaixo da qual um extremo conta como ruído
table-of-amplitudes = Tabela de amplitudes
the-amplitudes-do-not-fall-with-the-cycles = as amplitudes não caem com os ciclos
the-amplitudes-do-not-belong-to-different-cycles = as amplitudes não pertencem a ciclos diferentes
amplitude-decrease-per-cycle-4f-k-f-k = Redução de amplitude por ciclo: 4F/k; F/k
the-record-does-not-distinguish-viscous-damping-from-friction-both-fit-it-almost-equally-well-record = o registro não distingue amortecimento viscoso de atrito: os dois se ajustam a ele quase igualmente bem; registre mais ciclos, até amplitudes menores
the-record-has-fewer-than-five-turning-points-record-more-cycles-or-more-samples-per-cycle = o registro tem menos de cinco pontos de retorno: registre mais ciclos, ou mais amostras por ciclo
the-times-of-the-samples-do-not-increase-from-row-to-row-sort-the-rows-by-time = os tempos das amostras não crescem de linha a linha: ordene as linhas pelo tempo
there-are-fewer-than-four-amplitudes-record-more-cycles-or-use-the-logarithmic-decrement = há menos de quatro amplitudes: registre mais ciclos, ou use o decremento logarítmico
selected = selecionado
three-fits-of-the-decay = Três ajustes do decaimento
verdict = veredicto
viscous-only-damping-ratio = Só viscoso: fator de amortecimento
viscous-only-decrement = Só viscoso: decremento
viscous-only-fit-residual = Só viscoso: resíduo do ajuste
viscous-damping-only-x-x-e-n-by-least-squares-on-the-amplitudes-its-decrement = Só amortecimento viscoso: X = X₀ e^(−δn) por mínimos quadrados das amplitudes; seu decremento
viscous-damping-or-friction-from-a-free-decay = Amortecimento viscoso ou atrito por um decaimento livre
the-friction-losses-of-two-successive-strokes-add-up-to-the-loss-per-cycle = as perdas por atrito de dois cursos sucessivos somam a perda por ciclo
amplitude-ratio-after-one-cycle-of-a-release-from-rest-with-this-damping-ratio-by-integration-of-the = razão de amplitudes após um ciclo de uma soltura do repouso com este fator de amortecimento, por integração da equação de movimento
viscous-damping-alone-rms-value-of-the-residuals = só amortecimento viscoso: valor eficaz dos resíduos
viscous-damping-alone-the-residuals-are-orthogonal-to-the-change-of-the-exponential-with-its = só amortecimento viscoso: os resíduos são ortogonais à variação da exponencial com o seu decremento
the-natural-frequency-is-the-distance-of-the-complex-root-from-the-origin = a frequência natural é a distância da raiz complexa à origem
half-cycle-the-energy-released-by-the-spring-is-the-work-of-friction-and-damper-by-quadrature = meio ciclo: a energia liberada pela mola é o trabalho de atrito e amortecedor, por quadratura
half-cycle-of-a-mass-on-a-level-surface-its-energy-is-the-work-of-friction-and-damper = meio ciclo de uma massa sobre uma superfície horizontal: a sua energia é o trabalho de atrito e amortecedor
from-the-first-to-the-last-turning-point-every-stroke-is-half-a-cycle-of-the-damped-motion = do primeiro ao último ponto de retorno, cada curso é meio ciclo do movimento amortecido
friction-alone-rms-value-of-the-residuals = só atrito: valor eficaz dos resíduos
friction-alone-the-residuals-are-orthogonal-to-the-cycles = só atrito: os resíduos são ortogonais aos ciclos
both-together-rms-value-of-the-residuals = ambos juntos: valor eficaz dos resíduos
both-together-the-residuals-are-orthogonal-to-the-changes-with-decrement-and-friction = ambos juntos: os resíduos são ortogonais às variações com o decremento e o atrito
amplitude-ratio-per-half-cycle-due-to-viscous-damping-alone = Razão de amplitudes por meio ciclo só pelo amortecimento viscoso

# equivalent-damping
amplitude-against-frequency = Amplitude em função da frequência
amplitude-at-this-frequency = Amplitude nesta frequência
amplitude-at-which-it-was-measured = Amplitude em que foi medida
at-resonance-it-is-twice-the-damping-ratio-zero-without-damping = Na ressonância é o dobro do fator de amortecimento; zero sem amortecimento.
drag-over-the-square-of-the-velocity = Arrasto sobre o quadrado da velocidade
drag-proportional-to-the-square-of-the-velocity = Arrasto proporcional ao quadrado da velocidade
energy-lost-per-cycle-the-area-of-the-loop = Energia dissipada por ciclo: a área do laço
equivalent-damping = amortecimento equivalente
equivalent-damping-ratio = Fator de amortecimento equivalente
equivalent-damping-ratio-for-hysteretic-damping-at-resonance-2 = Fator de amortecimento equivalente; para amortecimento histerético na ressonância, η/2
equivalent-viscous-damping-8a-x-3 = Amortecimento viscoso equivalente, 8aωX/(3π)
equivalent-viscous-damping-at-this-frequency = Amortecimento viscoso equivalente nesta frequência
hysteretic-and-other-equivalent-damping = Amortecimento histerético e outros equivalentes
the-loss-factor-at-this-frequency-is-2-r = o fator de perda nesta frequência é 2ζr
maximum-amplitude-from-the-dynamic-stiffness-at-the-natural-frequency = amplitude máxima pela rigidez dinâmica na frequência natural
amplitude-from-the-frequency-ratio-and-the-loss-factor-1-r = amplitude pela razão de frequências e pelo fator de perda, δ/√((1 − r²)² + η²)
hysteretic-loop-area-given = Histerético: área do laço dada
maximum-amplitude-exactly-at-the-natural-frequency-unlike-that-of-viscous-damping = Amplitude máxima, exatamente na frequência natural, ao contrário do amortecimento viscoso
force-displacement-loop-over-one-cycle = Laço força–deslocamento em um ciclo
loss-factor-at-this-frequency-and-amplitude = Fator de perda nesta frequência e amplitude
loss-factor-at-this-frequency-the-damping-force-kx-over-the-elastic-one = Fator de perda nesta frequência: a força de amortecimento βωkX sobre a elástica
loss-factor-the-area-of-the-loop-is-kx = Fator de perda: a área do laço é πηkX²
multiplier-of-the-stiffness = Multiplicador da rigidez
proportional-to-the-stiffness-by-a-multiplier = Proporcional à rigidez, por um multiplicador
specific-damping-capacity = Capacidade específica de amortecimento
specific-damping-capacity-that-energy-over-the-largest-elastic-energy-kx-2 = Capacidade específica de amortecimento: essa energia sobre a maior energia elástica kX²/2
spring-alone = só a mola
spring-and-damping = mola e amortecimento
steady-state-amplitude-k-x-a-x-f-a-quadratic-equation-in-x = Amplitude em regime permanente: (K X)² + (A X²)² = F₀², equação do segundo grau em X²
steady-state-amplitude-spring-and-inertia-on-one-side-damping-on-the-other = Amplitude em regime permanente: mola e inércia de um lado, amortecimento do outro
the-amplitude-of-a-viscous-oscillator-with-the-equivalent-damping = a amplitude de um oscilador viscoso com o amortecimento equivalente
the-area-of-the-force-displacement-loop = A área do laço força–deslocamento.
area-of-the-hysteresis-loop-by-summation = área do laço de histerese, por soma
the-damping-force-is-a-fixed-fraction-of-the-elastic-force-at-any-frequency-k-1-i = A força de amortecimento é uma fração fixa da força elástica em qualquer frequência: k(1 + iη).
the-damping-matrix-of-finite-elements-c-k-the-loss-factor-applies-at-this-frequency = A matriz de amortecimento dos elementos finitos, c = βk; o fator de perda vale nesta frequência.
the-drag-a-v-v-is-equivalent-to-a-viscous-damping-8a-x-3-which-dissipates-the-same-energy-per-cycle = O arrasto a v|v| equivale a um amortecimento viscoso 8aωX/(3π), que dissipa a mesma energia por ciclo
the-force-supplies-the-same-energy-f-x-sin = a força fornece a mesma energia, πF₀X sen φ
this-damping = este amortecimento
viscous-with-the-same-loss-here = viscoso, com a mesma perda aqui
force-of-spring-and-inertia-per-metre-of-amplitude = Força de mola e inércia por metro de amplitude

# forced-coulomb
one-cycle-of-the-exact-motion = Um ciclo do movimento exato
amplitude-by-equivalent-damping = Amplitude pelo amortecimento equivalente
amplitude-by-equivalent-viscous-damping = Amplitude pelo amortecimento viscoso equivalente
amplitude-exact = Amplitude exata
amplitude-given-force-unknown = Amplitude dada, força desconhecida
at-the-natural-frequency-this-force-supplies-more-energy-per-cycle-than-friction-dissipates-since-4f = na frequência natural esta força fornece por ciclo mais energia do que o atrito dissipa, pois 4F/π está abaixo de F₀: a amplitude cresce com o tempo sem limite
by-equivalent-damping-there-is-no-steady-state-motion-with-this-force-4f-is-not-below-f-only-the = pelo amortecimento equivalente não há movimento em regime permanente com esta força: 4F/π não está abaixo de F₀; só se calcula o movimento exato, com suas paradas
damping-function = Função de amortecimento
damping-function-of-the-exact-motion-without-stops = Função de amortecimento do movimento exato sem paradas
static-deflection-of-the-spring-under-the-force = Deflexão estática da mola sob a força
deflection-of-the-spring-under-the-friction-force = Deflexão da mola sob a força de atrito
error-of-equivalent-damping = Erro do amortecimento equivalente
exact-amplitude-the-mass-does-not-stop-within-a-half-cycle = Amplitude exata: a massa não para dentro de um meio ciclo
exact-amplitude-the-mass-stops-within-each-half-cycle-so-the-motion-is-solved-slip-phase-by-slip = Amplitude exata: a massa para dentro de cada meio ciclo, por isso o movimento é resolvido fase a fase de deslizamento até se tornar periódico; metade da faixa do movimento
exact-force-x-f-v-k-fu-solved-for-f = Força exata: X² = (F₀V/k)² − (fU)² resolvida para F₀
exact-motion-without-stops-response-function = Movimento exato sem paradas: função de resposta
exact-without-stops = exato, sem paradas
force-by-equivalent-damping = Força pelo amortecimento equivalente
force-exact = Força exata
force-given-amplitude-unknown = Força dada, amplitude desconhecida
force-of-spring-and-friction-over-one-cycle-the-area-of-the-loop-is-4fx = Força da mola e do atrito em um ciclo: a área do laço é 4FX
force-on-a-viscous-oscillator-with-that-damping = força sobre um oscilador viscoso com esse amortecimento
force-over-stiffness = força sobre rigidez
force-includes-the-component-4f-balanced-by-the-equivalent-damping-a-quarter-cycle-ahead = Força: inclui a componente 4F/π equilibrada pelo amortecimento equivalente, um quarto de ciclo adiantada
harmonic-force-with-dry-friction = Força harmônica com atrito seco
exact-motion-work-of-the-force-in-a-cycle-with-that-phase-lag-equals-the-friction-work = movimento exato: o trabalho da força em um ciclo, com essa defasagem, é igual ao do atrito
exact-motion-spring-and-inertia-forces-of-its-first-harmonic-are-balanced-by-the-force-component-in = movimento exato: as forças da mola e de inércia do seu primeiro harmônico são equilibradas pela componente da força em fase com os seus extremos
equivalent-damping-energy-input-equals-friction-loss-per-cycle-f-x-sin-4fx = amortecimento equivalente: a energia fornecida é igual à perda por atrito em um ciclo, πF₀X sen φ = 4FX
equivalent-damping-spring-and-inertia-forces-are-balanced-by-the-force-component-in-phase-with-the = amortecimento equivalente: as forças da mola e de inércia são equilibradas pela componente da força em fase com o movimento
error-of-the-equivalent-damping = Erro do amortecimento equivalente
lag-of-its-extremes-behind-those-of-the-force = Atraso dos seus extremos em relação aos da força
lag-of-the-motion-behind-the-force-above-90-beyond-resonance = Atraso do movimento em relação à força, acima de 90° além da ressonância
part-of-the-force-that-balances-spring-and-inertia = Parte da força que equilibra mola e inércia
phase-lag-by-equivalent-damping = Ângulo de fase (atraso) pelo amortecimento equivalente
phase-lag-exact = Ângulo de fase (atraso) exato
spring-and-friction = mola e atrito
steady-state-amplitude-of-a-mass-with-friction-by-equivalent-viscous-damping-and-exactly-including = Amplitude em regime permanente de uma massa com atrito, por amortecimento viscoso equivalente e exata, incluídas as paradas; ou a força para uma amplitude.
stops-per-cycle = Paradas por ciclo
that-force-reproduces-the-amplitude = essa força reproduz a amplitude
damping-balances-the-part-4f-of-the-force-sine-of-the-phase-angle = O amortecimento equilibra a parte 4F/π da força: seno do ângulo de fase
the-equivalent-damping-is-in-error-by-off-the-friction-is-too-large-relative-to-the-force = o amortecimento equivalente erra { $off }: o atrito é grande demais em relação à força
the-exact-motion-has-too-many-stops-to-be-computed-and-there-is-no-equivalent-one = o movimento exato tem paradas demais para ser calculado, e não há equivalente
the-force-does-not-overcome-the-friction-the-mass-does-not-move-write-a-larger-force = a força não vence o atrito: a massa não se move; escreva uma força maior
the-force-is-so-slow-relative-to-the-natural-frequency-that-the-exact-motion-has-too-many-stops-to-be = a força é tão lenta em relação à frequência natural que o movimento exato tem paradas demais para ser calculado: só se dá o resultado do amortecimento equivalente
the-work-of-the-force-in-a-cycle-is-the-friction-force-times-the-distance-travelled = o trabalho da força em um ciclo é a força de atrito vezes a distância percorrida
the-work-of-the-force-in-a-cycle-summed-over-the-exact-motion-equals-the-friction-work-4fx = o trabalho da força em um ciclo, somado ao longo do movimento exato, é igual ao do atrito, 4FX
viscous-damping-with-the-same-energy-loss-per-cycle-c-x-4fx = Amortecimento viscoso com a mesma perda de energia por ciclo, πcωX² = 4FX
with-this-amplitude-the-mass-would-stop-within-each-half-cycle-where-the-exact-force-has-no-closed = com esta amplitude a massa pararia dentro de cada meio ciclo, onde a força exata não tem forma fechada: só se dá a equivalente

# free-vibration
a-negative-one-feeds-energy-into-the-motion = Um valor negativo introduz energia no movimento.
acceleration-at-that-time = Aceleração nesse instante
acceleration-at-that-time-from-the-equation-of-motion = Aceleração nesse instante, pela equação de movimento
amplitude-constant = Amplitude: constante
initial-angle = Ângulo inicial
angular-velocity-at-the-start = Velocidade angular inicial
constant-of-the-motion-c-e-t-c-e-t-from-the-initial-displacement-and-velocity = Constante do movimento C₁ e^(λ₁t) + C₂ e^(λ₂t), pelo deslocamento e pela velocidade iniciais
sine-coefficient-from-the-initial-displacement-and-velocity = Coeficiente do seno, pelo deslocamento e pela velocidade iniciais
sine-coefficient-from-the-initial-velocity = Coeficiente do seno, pela velocidade inicial
critical = Crítico
critical-damping = Amortecimento crítico
critical-damping-the-minimum-damping-for-which-the-motion-does-not-oscillate = Amortecimento crítico: o menor amortecimento com que o movimento não oscila
critically-damped-1-a-double-root-and-the-motion-is-a-b-t-e-t-with-a-the-initial-displacement = Criticamente amortecido, ζ = 1: raiz dupla −ζωₙ, e o movimento é (A + B t) e^(−ζωₙt), sendo A o deslocamento inicial
displacement-at-that-turning-point = Deslocamento nesse ponto de retorno
displacement-at-the-requested-time = Deslocamento no instante pedido
displacement-by-integration-of-the-equation-of-motion = deslocamento por integração da equação de movimento
energy-dissipated-up-to-that-time = Energia dissipada até esse instante
energy-dissipated-by-the-damper-up-to-that-time = Energia dissipada pelo amortecedor até esse instante
envelope-at-that-time = Envoltória nesse instante
envelope-at-the-requested-time = Envoltória no instante pedido
initial-amplitude-of-the-envelope = Amplitude inicial da envoltória
faster-root = Raiz mais rápida
first-displacement-to-the-opposite-side-as-a-fraction-of-the-release-displacement = Primeiro deslocamento para o outro lado, como fração do deslocamento na soltura.
first-passage-through-the-equilibrium-position = Primeira passagem pela posição de equilíbrio
first-instant-at-which-the-velocity-is-zero = Primeiro instante em que a velocidade é nula
from-the-overshoot-after-release-from-rest = Pelo sobressinal após uma soltura do repouso
from-the-settling-time-of-the-envelope = Pelo tempo de acomodação da envoltória
half-a-cycle-reduces-the-amplitude-from-1-to-the-overshoot-half-the-logarithmic-decrement = Meio ciclo reduz a amplitude de 1 ao sobressinal: metade do decremento logarítmico
imaginary-part = Parte imaginária
inertia-torsion-spring-and-damper = Inércia, mola de torção e amortecedor
the-mass-starts-at-rest-in-its-equilibrium-position-and-does-not-move-write-an-initial-displacement = a massa parte do repouso na posição de equilíbrio e não se move: escreva um deslocamento ou uma velocidade inicial para o movimento no tempo
maximum-displacement-at-the-first-turning-point = Deslocamento máximo, no primeiro ponto de retorno
maximum-displacement-at-the-start = Deslocamento máximo, no início
mass-of-that-weight = Massa desse peso
mass-spring-and-damper = Massa, mola e amortecedor
moment-of-inertia = Momento de inércia
motion-of-one-degree-of-freedom-from-its-initial-conditions-regime-frequencies-displacement-at-any = Movimento de um grau de liberdade a partir das condições iniciais: regime, frequências, deslocamento em qualquer instante, envoltória, sobressinal, acomodação.
natural-frequency-and-damping-ratio-given = Frequência natural e fator de amortecimento dados
negative-damping-1-0-complex-roots-i-d-a-growing-oscillation-of-frequency = Amortecimento negativo, −1 < ζ < 0: raízes complexas −ζωₙ ± i ω_d, oscilação crescente de frequência
oscillator = Oscilador
overdamped-1-two-real-roots-here-the-larger-in-magnitude = Superamortecido, ζ > 1: duas raízes reais, aqui a de maior módulo
overshoot = Sobressinal
overshoot-of-a-release-from-rest = Sobressinal na liberação a partir do repouso
envelope-displacement-and-velocity-without-the-decay-term-d-as-legs-of-a-right-triangle = envoltória: deslocamento e (velocidade sem o termo do decaimento)/ω_d como catetos
acceleration-as-the-second-derivative-of-the-displacement = aceleração como derivada segunda do deslocamento
a-release-from-rest-the-displacement-half-a-cycle-later-by-integration-of-the-equation-of-motion = soltura do repouso: o deslocamento meio ciclo depois, por integração da equação de movimento
a-release-from-rest-the-energy-a-cycle-later-by-integration-of-the-equation-of-motion = soltura do repouso: a energia um ciclo depois, por integração da equação de movimento
envelope-at-the-start-from-the-motion-a-little-later-by-integration-of-its-equation = envoltória no início: pelo movimento um pouco depois, integrando a sua equação
displacement-at-the-first-turning-point-by-integration-of-the-equation-of-motion = deslocamento no primeiro ponto de retorno, por integração da equação de movimento
envelope-at-its-settling-time-by-integration-of-the-equation-of-motion = envoltória no seu tempo de acomodação, por integração da equação de movimento
energy-dissipated-work-of-the-damper-cv-dt-by-quadrature = energia dissipada = trabalho do amortecedor, ∫cv²dt por quadratura
neighbouring-motions-cover-four-times-the-phase-plane-area-at-the-doubling-time = movimentos vizinhos cobrem quatro vezes a área do plano de fase no tempo de duplicação
overshoot-of-a-release-from-rest-fraction-of-the-amplitude-left-after-half-a-cycle = Sobressinal na liberação a partir do repouso: fração da amplitude que resta após meio ciclo
period = Período
period-of-the-damped-motion = Período do movimento amortecido
real-part = Parte real
roots-of-the-characteristic-equation-as-the-damping-grows-from-zero = Raízes da equação característica conforme o amortecimento cresce a partir de zero
settling-time = Tempo de acomodação
settling-time-from-the-envelope = Tempo de acomodação pela envoltória
settling-time-exact-last-instant-at-which-the-displacement-equals-the-fraction-p-of-the-maximum = Tempo de acomodação exato: último instante em que o deslocamento é igual à fração p do máximo
fraction-of-the-energy-lost-per-cycle-the-energy-is-proportional-to-the-square-of-the-amplitude = Fração da energia perdida por ciclo: a energia é proporcional ao quadrado da amplitude
settling-band = Faixa de acomodação
fraction-of-the-maximum-displacement-within-which-the-envelope-counts-as-settled = Fração do deslocamento máximo dentro da qual a envoltória é considerada acomodada.
slower-root = Raiz mais lenta
strongly-negative-damping-1-two-real-roots-both-positive-here-the-larger = Amortecimento fortemente negativo, ζ < −1: duas raízes reais, ambas positivas; aqui a maior
the-damping-is-critical = O amortecimento é crítico
the-damping-is-negative-it-feeds-energy-into-the-motion-which-grows-until-something-not-in-this-model = o amortecimento é negativo: introduz energia no movimento, que cresce até que algo fora deste modelo o detenha; a posição de repouso é instável
the-decrement-is-t-d = o decremento é ζ ωₙ T_d
the-displacement-at-the-settling-time-by-integration-of-the-equation-of-motion = o deslocamento no tempo de acomodação, por integração da equação de movimento
the-envelope-e-t-has-decayed-to-the-settling-band = A envoltória e^(−ζωₙt) decaiu até a faixa de acomodação
the-first-passage-through-rest-found-from-the-motion-itself = a primeira passagem pelo repouso obtida do próprio movimento
the-first-turning-point-found-from-the-motion-itself = o primeiro ponto de retorno obtido do próprio movimento
the-other-constant = A outra constante
the-product-of-the-roots-is = O produto das raízes é ωₙ²
the-square-of-the-damping-is-4-k-m = o quadrado do amortecimento é 4 ζ² k m
the-sum-of-the-roots-is-2 = a soma das raízes é −2ζωₙ
the-velocity-written-in-the-same-form-its-phase = A velocidade escrita na mesma forma; sua fase
time-for-the-envelope-to-decay-to-the-fraction-p-of-the-maximum-displacement = Tempo em que a envoltória decai à fração p do deslocamento máximo
time-for-the-envelope-to-decay-to-the-settling-band = Tempo em que a envoltória decai à faixa de acomodação
time-for-the-envelope-of-the-motion-to-double = Tempo em que a envoltória do movimento dobra
time-of-maximum-displacement = Instante do deslocamento máximo
time-to-double = Tempo para dobrar
torsional-damping-coefficient = Coeficiente de amortecimento torcional
torsional-stiffness = Rigidez torcional
ratio-of-the-amplitudes-doubled = Razão das amplitudes: o dobro
underdamped-1-complex-roots-i-d-a-decaying-oscillation-with-frequency = Subamortecido, ζ < 1: raízes complexas −ζωₙ ± i ω_d, oscilação decrescente com frequência
velocity-by-integration-of-the-equation-of-motion = velocidade por integração da equação de movimento
without-damping-the-motion-is-harmonic-its-period = Sem amortecimento o movimento é harmônico; seu período
written-as-r-sin-t-it-is-zero-where-t-is-a-multiple-of-here = Escrito como R sen(ωt + φ), é nulo onde ωt + φ é múltiplo de π; aqui φ
zero-for-no-damping-a-negative-one-feeds-energy-into-the-motion = Zero para nenhum amortecimento; um valor negativo introduz energia no movimento.

# friction-damper
continuous-sticking = aderência permanente
amplitude-at-the-requested-frequency-where-amplitude-and-dynamic-stiffness-balance-the-force = Amplitude na frequência pedida, em que amplitude e rigidez dinâmica equilibram a força
amplitude-at-the-peak = Amplitude no pico
amplitude-at-that-frequency = Amplitude nessa frequência
amplitude-times-dynamic-stiffness-equals-the-force = amplitude vezes rigidez dinâmica é igual à força
at-this-frequency-the-force-exceeds-the-slip-force-and-the-damping-there-is-no-steady-state-amplitude = nesta frequência a força supera o deslizamento e o amortecimento: não há amplitude em regime permanente
combined-stiffness = Rigidez combinada
displacement-at-which-slip-begins = Deslocamento em que começa o deslizamento
displacement-at-which-the-element-begins-to-slip = Deslocamento em que o elemento começa a deslizar
elastic-dry-friction-damper = Amortecedor elástico de atrito seco
energy-dissipated-by-the-element-per-cycle-area-of-its-loop = Energia dissipada pelo elemento por ciclo: área do seu laço
equivalent-stiffness-by-integration-around-the-hysteresis-loop = rigidez equivalente por integração ao longo do laço de histerese
equivalent-stiffness-of-the-element-first-harmonic-of-its-force-in-phase-with-the-motion = Rigidez equivalente do elemento: primeiro harmônico da sua força em fase com o movimento
first-harmonic-in-phase-with-the-velocity-per-unit-amplitude = Primeiro harmônico em fase com a velocidade, por unidade de amplitude
force-at-which-slip-begins = Força em que começa o deslizamento
force-of-the-element = força do elemento
frequency-at-which-the-amplitude-is-requested = Frequência em que se pede a amplitude
hysteresis-loop-of-the-element-at-the-peak = Laço de histerese do elemento no pico
natural-frequency-far-beyond-the-slip-limit-the-element-only-slides = Frequência natural muito além do limite de deslizamento: o elemento só desliza
natural-frequency-slipping = Frequência natural, deslizando
natural-frequency-sticking = Frequência natural, aderido
natural-frequency-while-the-element-sticks-both-springs-act = Frequência natural enquanto o elemento adere: as duas molas atuam
of-the-spring-in-series-with-its-slider = Da mola em série com o seu deslizador.
sticking-part-of-each-half-cycle-as-an-angle = Parte de cada meio ciclo em que o elemento adere, como ângulo
peak-of-the-response-and-amplitude-at-a-frequency-of-an-oscillator-with-a-spring-and-slider-damper-by = Pico da resposta e amplitude em uma frequência de um oscilador com amortecedor de mola e deslizador, por um harmônico.
peak-of-the-response-by-one-harmonic-the-frequency-at-which-that-amplitude-requires-the-least-force = Pico da resposta por um harmônico: a frequência em que essa amplitude exige a menor força
onset-of-slip = início do deslizamento
stiffness-in-parallel-with-the-damper = Rigidez em paralelo com o amortecedor
stiffness-of-the-friction-element = Rigidez do elemento de atrito
the-element-sticks-at-this-amplitude-both-springs-act-and-no-energy-is-dissipated = O elemento permanece em aderência nesta amplitude: as duas molas atuam e não há dissipação de energia
the-force-supplies-more-energy-per-cycle-than-the-slipping-element-can-dissipate-since-4f-d-is-below = a força fornece por ciclo mais energia do que o elemento que desliza pode dissipar, pois 4F_d/π está abaixo de F₀, e não há outro amortecimento: a ressonância cresce com o tempo sem limite
the-minimum-force-has-zero-slope-with-respect-to-frequency = a força mínima tem inclinação nula em relação à frequência
the-oscillator-and-its-friction-element = O oscilador e o seu elemento de atrito
component-in-phase-with-the-velocity-by-integration-around-the-hysteresis-loop = componente em fase com a velocidade, por integração ao longo do laço de histerese
there-is-more-than-one-amplitude-at-this-frequency-the-largest-is-given = há mais de uma amplitude nesta frequência; dá-se a maior
additional-viscous-damping = Amortecimento viscoso adicional
with-the-element = com o elemento
without-the-element = sem o elemento

# gun-recoil
critical-damping-the-fastest-return-without-oscillation = Amortecimento crítico: o retorno mais rápido sem oscilação
displacement-up-to-which-the-return-is-timed = Deslocamento até o qual se conta o tempo de retorno
recoil-distance = Distância de recuo
with-critical-damping-both-roots-equal-c-2m = com amortecimento crítico as duas raízes valem −c/2m = −ωₙ
displacement-at-the-end-of-recoil-and-return-by-integration-of-the-return-after-a-quarter-period = deslocamento no fim do recuo e do retorno, por integração do retorno depois de um quarto do período
end-of-the-recoil = fim do recuo
end-of-the-timed-return = fim do retorno cronometrado
mass-or-weight-of-the-recoiling-parts = Massa ou peso das partes que recuam
recoil = Recuo
recoil-and-critically-damped-return = Recuo e retorno criticamente amortecido
recoil-and-return = Recuo e retorno
recoil-and-return-together = Recuo e retorno juntos
speed-at-the-start-of-the-recoil = Velocidade no início do recuo
speed-or-distance-of-a-recoil-on-a-spring-the-dashpot-that-returns-it-without-oscillation-and-the = Velocidade ou distância de um recuo sobre mola, o amortecedor que o faz retornar sem oscilação e a duração de ambos.
stiffness-of-the-recoil-spring = Rigidez da mola de recuo
the-dashpot-does-not-act-in-recoil-the-amplitude-of-the-harmonic-motion-is-v = O amortecedor não atua no recuo: a amplitude do movimento harmônico é v₀/ωₙ
the-displacement-at-which-the-return-time-is-taken-is-not-below-the-recoil-write-a-smaller-one = o deslocamento até o qual o retorno é cronometrado não está abaixo do recuo: escreva um menor
the-kinetic-energy-at-the-start-is-the-energy-of-the-spring-at-the-end-of-the-recoil = a energia cinética no início é a energia da mola no fim do recuo
the-motion-is-at-x-at-that-time = o movimento está em x₁ nesse instante
the-return-to-the-exact-equilibrium-position-takes-an-infinite-time = O retorno à posição exata de equilíbrio leva um tempo infinito.
the-same-by-integration-of-the-equation-of-motion = o mesmo por integração da equação de movimento
recoil-time = Tempo do recuo
recoil-time-a-quarter-of-the-period = Tempo do recuo: um quarto do período
return-time = Tempo de retorno
return-time-by-solving-x-r-1-t-e-t-with-critical-damping-from-rest = Tempo de retorno, resolvendo x₁ = R (1 + ωₙt) e^(−ωₙt): com amortecimento crítico, a partir do repouso

# logarithmic-decrement
all-amplitudes-are-at-the-same-cycle-number-them-0-1-2 = todas as amplitudes estão no mesmo ciclo: numere-as 0, 1, 2, …
at-least-three-some-cycles-may-be-skipped-and-a-trough-is-half-a-cycle-from-its-peak = Pelo menos três; alguns ciclos podem ser omitidos, e um vale está a meio ciclo do seu pico.
cycles-for-the-amplitude-to-decay-by-that-ratio = Ciclos para a amplitude cair nessa razão
cycles-to-half-amplitude = Ciclos até a metade da amplitude
damping-ratio-from-damping-stiffness-and-mass = fator de amortecimento por amortecimento, rigidez e massa
damping-ratio-light-damping-formula = Fator de amortecimento, fórmula de amortecimento fraco
decay-over-the-cycles = Decaimento ao longo dos ciclos
decrement-by-least-squares-the-slope-of-the-straight-line-ln-x-ln-x-n = Decremento por mínimos quadrados: a inclinação da reta ln X = ln X₀ − δ n
decrement-damping-ratio-and-damping-of-a-decay-from-its-amplitudes-and-the-cycles-and-time-to-decay = Decremento, fator de amortecimento e amortecimento de um decaimento por suas amplitudes, e os ciclos e o tempo até uma dada amplitude.
error-of-that-formula = Erro dessa fórmula
for-light-damping-2-since-1-is-nearly-1 = Para amortecimento fraco: δ = 2πζ, pois √(1 − ζ²) é quase 1
half-the-amplitude-the-ratio-of-the-amplitudes-is-2 = Metade da amplitude: a razão das amplitudes é 2
relative-error-of-that-formula = Erro relativo dessa fórmula
deviation-of-the-measured-period-from-that-of-mass-and-stiffness = Desvio do período medido em relação ao de massa e rigidez
in-any-unit-the-same-for-all-without-sign = Em qualquer unidade, a mesma para todas, sem sinal.
inertia-and-torsional-stiffness = Inércia e rigidez torcional
inertia-on-a-round-shaft = Inércia em um eixo redondo
logarithmic-decrement-given = Decremento logarítmico dado
mass-and-stiffness = Massa e rigidez
deviation-of-the-measured-frequency = Desvio da frequência medida
measured-period-for-comparison = Período medido, para comparação
natural-frequency-from-the-measured-period = Frequência natural pelo período medido
nothing-more = Nada mais
no-further-data = Sem outros dados
period-of-the-decaying-motion = Período do movimento que decai
amplitude-ratio-for-which-cycles-and-time-are-computed = Razão de amplitudes para o cálculo dos ciclos e do tempo
ratio-of-successive-amplitudes = Razão de amplitudes sucessivas
root-mean-square-of-the-relative-differences-between-the-amplitudes-and-the-fitted-decay = Média quadrática das diferenças relativas entre as amplitudes e o decaimento ajustado
fit-residual-of-the-amplitudes = Resíduo do ajuste das amplitudes
standard-deviation-of-the-decrement = Desvio padrão do decremento
stiffness-and-period = Rigidez e período
sum-of-n-n-ln-x-mean-of-ln-x-over-the-table = Soma de (n − n̄)(ln X − média de ln X) na tabela
sum-of-n-n-over-the-table = Soma de (n − n̄)² na tabela
the-amplitudes-do-not-fall-with-the-cycles-are-the-rows-in-the-order-of-time = as amplitudes não caem com os ciclos: as linhas estão em ordem de tempo?
the-amplitudes-scatter-by-more-than-5-about-an-exponential-decay-noise-or-friction-in-addition-to = as amplitudes se dispersam mais de 5 % em torno de um decaimento exponencial: ruído, ou atrito além do amortecimento viscoso
the-decrement-reproduces-the-damping-ratio = o decremento reproduz o fator de amortecimento
the-larger-amplitude-over-the-smaller-one = A amplitude maior sobre a menor.
the-light-damping-formula-2-is-in-error-by-error-here-use-the-exact-one = a fórmula de amortecimento fraco ζ = δ/2π erra { $error } aqui: use a exata
the-measured-period-differs-from-that-of-mass-and-stiffness-by-off-is-the-whole-mass-included = o período medido difere { $off } do de massa e rigidez: toda a massa foi incluída?
the-motion-does-not-decay-there-is-no-damping-and-no-smaller-amplitude-is-ever-reached = o movimento não decai: não há amortecimento, e nenhuma amplitude menor é jamais alcançada
the-same-slope-by-orthogonal-decomposition = a mesma inclinação por decomposição ortogonal
the-same-time-from-the-envelope-e-t = o mesmo tempo pela envoltória e^(−ζωₙt)
the-table-has-fewer-than-three-amplitudes-measure-more-or-write-their-ratio-as-two-amplitudes = a tabela tem menos de três amplitudes: meça mais, ou escreva a razão delas como duas amplitudes
duration-of-these-cycles = Duração desses ciclos
torsional-stiffness-of-the-shaft = Rigidez torcional do eixo
two-amplitudes = Duas amplitudes
two-beams-in-parallel-both-loaded-off-their-midpoints = Duas vigas em paralelo, ambas carregadas fora do meio do vão
with-a-damping-ratio-of-1-or-more-the-motion-does-not-oscillate-and-has-no-decrement-write-a-ratio = com fator de amortecimento 1 ou maior o movimento não oscila e não tem decremento: escreva um fator abaixo de 1
# spring
area-given = Área dada
torsion-constant-given = Constante de torção dada
for-a-circular-section-its-polar-second-moment-of-area-for-other-sections-it-is-smaller = Para uma seção circular é o seu momento polar de inércia; para outras seções é menor.
torsion-constant = Constante de torção
area-of-a-circular-section = Área de uma seção circular
area-of-a-tube = Área de um tubo
area-of-a-rectangle = Área de um retângulo
polar-second-moment-of-area-of-a-tube = Momento polar de inércia de um tubo
a-stepped-bar-is-a-series-combination-of-its-segments = Uma barra escalonada é a associação em série dos seus trechos.
tapered-round-bar-in-tension = Barra circular cônica tracionada ao longo do seu eixo
diameter-at-one-end = Diâmetro numa extremidade
diameter-at-the-other-end = Diâmetro na outra extremidade
torsion-bar-with-a-lever = Barra de torção com alavanca
leaf-spring = Feixe de molas
semi-elliptic-with-leaves-cut-from-a-plate-of-uniform-strength-interleaf-friction-neglected = Semielíptico, de lâminas cortadas de uma chapa de resistência uniforme; desprezado o atrito entre as lâminas.
leaves = Lâminas
width-of-a-leaf = Largura de uma lâmina
thickness-of-a-leaf = Espessura de uma lâmina
rubber-pad-in-shear = Coxim de borracha em cisalhamento
bonded-area = Área colada
thickness = Espessura
air-spring = Mola a ar
polytropic-exponent = Expoente politrópico
n-1-4-for-air-and-quick-motions-1-for-slow-ones = 1,4 para ar e movimentos rápidos, 1 para lentos.
absolute-pressure = Pressão absoluta
area-of-the-piston = Área do pistão
volume-of-the-gas = Volume do gás
taut-string-or-cable-under-a-transverse-load = Corda ou cabo esticado sob carga transversal
tension = Tração
from-the-load-to-one-end = Da carga a uma extremidade
from-the-load-to-the-other-end = Da carga à outra extremidade
pendulum-gravitational-stiffness = Pêndulo: rigidez gravitacional
suspended-mass = Massa suspensa
floating-body = Corpo flutuante
density-of-the-liquid = Massa específica do líquido
area-of-the-waterline = Área da linha d'água
liquid-in-a-u-tube = Líquido num tubo em U
internal-area-of-the-tube = Área interna do tubo
reflected-through-a-lever = Refletida através de uma alavanca
the-members-stand-side-by-side-on-the-lever-small-angles = Os membros ficam lado a lado na alavanca; ângulos pequenos.
arm-of-the-springs = Braço das molas
from-the-pivot = A partir da articulação.
arm-of-the-load = Braço da carga
inclined-to-the-motion = Inclinada em relação ao movimento
the-members-stand-side-by-side-small-motions-no-load-at-rest = Os membros ficam lado a lado; movimentos pequenos, sem carga em repouso.
angle-between-springs-and-motion = Ângulo entre as molas e o movimento
displacement-of-the-lever-at-the-springs-per-displacement-at-the-load = Deslocamento da alavanca nas molas por deslocamento na carga
part-of-the-motion-that-the-springs-follow = Parte do movimento que as molas acompanham
tapered-bar = barra cônica
rubber-pad = coxim de borracha
taut-string = corda esticada
pendulum = Pêndulo
buoyancy = empuxo
liquid-column = coluna de líquido
through-a-lever = por alavanca
inclined = inclinada
axial-stiffness-of-a-tapered-round-bar = Rigidez axial de uma barra circular cônica
stiffness-of-a-semi-elliptic-leaf-spring-of-uniform-strength = Rigidez de um feixe de molas semielíptico de resistência uniforme
stiffness-of-a-pad-in-shear = Rigidez de um coxim em cisalhamento
stiffness-of-a-gas-behind-a-piston = Rigidez de um gás atrás de um pistão
stiffness-of-a-taut-string-at-the-load = Rigidez de uma corda esticada no ponto da carga
the-weight-is-the-restoring-force-of-a-pendulum = O peso é a força restauradora do pêndulo
buoyancy-is-the-restoring-force-of-a-floating-body = O empuxo é a força restauradora do corpo flutuante
the-weight-of-the-higher-column-restores-the-liquid-level = O peso da coluna mais alta restaura o nível do líquido
torsional-springs-in-series-the-angles-of-twist-add-up = Molas de torção em série: os ângulos de torção somam-se
torsional-springs-in-parallel-the-torques-add-up = Molas de torção em paralelo: os torques somam-se
both-store-the-same-energy-so-the-stiffness-varies-as-the-square-of-the-ratio = As duas armazenam a mesma energia, de modo que a rigidez varia com o quadrado da razão
spiral-spring = Mola espiral
springs-on-an-arm = molas num braço
wire-suspension = suspensão por fios
through-gears = por engrenagens
deflection-beyond-the-lever-over-that-of-the-load = Deflexão além da alavanca, sobre a da carga
force-beyond-the-lever-over-that-of-the-load = Força além da alavanca, sobre a da carga
fraction-of-the-twist-in-series-the-torque-is-the-same = Fração da torção: em série o torque é o mesmo
fraction-of-the-torque-in-parallel-the-twist-is-the-same = Fração do torque: em paralelo a torção é a mesma
angle-beyond-the-gears-over-that-of-the-body = Ângulo além das engrenagens, sobre o do corpo
torque-behind-the-gears-over-that-on-the-body = Torque após as engrenagens, sobre o torque no corpo
the-twists-of-the-members-in-series-add-up = as torções dos membros em série somam-se
the-torques-of-the-members-in-parallel-add-up = os torques dos membros em paralelo somam-se
share-of-the-torque = parcela do torque
share-of-the-twist = parcela da torção
amplitude-of-the-torque = amplitude do torque
amplitude-of-the-twist = amplitude da torção
torque = torque
twist = torção
shaft-in-torsion = Eixo em torção
a-stepped-shaft-is-a-series-combination-of-its-segments-two-shafts-from-one-disc-to-two-walls-are-in = Um eixo escalonado é a associação em série dos seus trechos; dois eixos de um disco a duas paredes estão em paralelo.
tapered-round-shaft-in-torsion = Eixo circular cônico em torção
helical-spring-twisted-about-its-axis = Mola helicoidal torcida em torno do seu eixo
length-of-the-strip = Comprimento da fita
cantilever-moment-at-its-tip = Viga em balanço com momento na ponta
simply-supported-beam-moment-at-one-end = Viga biapoiada com momento numa extremidade
beam-clamped-at-one-end-moment-at-its-pinned-end = Viga engastada numa extremidade, com momento na extremidade apoiada
linear-springs-at-an-arm = Molas lineares num braço
side-by-side-perpendicular-to-the-arm-small-angles = Lado a lado, perpendiculares ao braço; ângulos pequenos.
arm = Braço
any-body-that-hangs-from-a-pivot-small-angles = Qualquer corpo pendurado numa articulação; ângulos pequenos.
from-the-pivot-down-to-the-centre-of-mass = Da articulação até o centro de massa
suspended-on-parallel-wires = Suspenso por fios paralelos
two-three-or-more-wires-at-the-same-radius-about-the-centre-of-mass-small-angles = Dois, três ou mais fios num mesmo raio em torno do centro de massa; ângulos pequenos.
from-the-axis-to-the-wires = Do eixo aos fios
length-of-the-wires = Comprimento dos fios
reflected-through-gears = Refletida através de engrenagens
the-members-stand-side-by-side-on-the-other-shaft = Os membros ficam lado a lado no outro eixo.
speed-of-the-other-shaft-over-that-of-this-one = Rotação do outro eixo sobre a deste
every-member-carries-the-whole-torque = Cada membro leva todo o torque.
all-members-have-the-same-twist = Todos os membros têm a mesma torção.
rotation-of-the-other-shaft-per-rotation-of-this-one = Rotação do outro eixo por rotação deste
torsional-stiffness-of-a-shaft = Rigidez torcional de um eixo
torsional-stiffness-of-a-tapered-round-shaft = Rigidez torcional de um eixo circular cônico
twisting-a-helical-spring-about-its-axis-bends-the-wire = Torcer uma mola helicoidal em torno do seu eixo flexiona o arame
stiffness-of-a-spiral-spring = Rigidez de uma mola espiral
a-couple-at-the-tip-of-a-cantilever-rotates-the-tip-by-m-l-e-i = Um binário na ponta de uma viga em balanço gira a ponta de M L/(E I)
a-couple-at-the-end-of-a-simply-supported-beam-rotates-that-end-by-m-l-3-e-i = Um binário na extremidade de uma viga biapoiada gira essa extremidade de M L/(3 E I)
a-couple-at-the-pinned-end-of-a-beam-clamped-at-the-other-end-rotates-the-pinned-end-by-m-l-4-e-i = Um binário na extremidade apoiada de uma viga engastada na outra gira a extremidade apoiada de M L/(4 E I)
a-rotation-deflects-the-springs-by-r-and-their-force-has-the-arm-r = Uma rotação θ deflete as molas de r θ, e a sua força tem o braço r
the-weight-exerts-the-restoring-moment-of-a-pendulum = O peso exerce o momento restaurador do pêndulo
the-wires-lean-by-r-l-and-their-tension-in-total-the-weight-restores-the-body = Os fios inclinam-se de r θ/l e a sua tração, no total igual ao peso, restaura o corpo
torsional-spring = mola de torção
tapered-shaft = eixo cônico
# spring-network
nodes = Nós
points-that-move-along-one-line-the-ground-is-already-included = Pontos que se movem ao longo de uma reta; a base já está incluída.
elements = Elementos
loaded-node = Nó carregado
force-on-it = Força nele
omit-for-a-constant-force = Omitida para uma força constante.
omit-for-a-joint = Omitida para uma junção.
from-node = Do nó
to-node = Ao nó
omit-for-ground = Omitido para a base.
ground = Base
node = Nó
damper = Amortecedor
spring-and-damper-in-parallel = Mola e amortecedor em paralelo
network-of-springs-and-dampers = Rede de molas e amortecedores
stiffness-at-a-node-of-any-network-of-springs-and-dampers-at-rest-or-under-harmonic-forces-what-each = Rigidez em um nó de qualquer rede de molas e amortecedores, em repouso ou sob forças harmônicas, o que cada elemento transmite, e como vibram massas nela.
there-are-more-than-50-nodes-join-some-of-them = há mais de 50 nós: una alguns deles
element-element-begins-and-ends-at-node-write-two-different-nodes = o elemento { $element } começa e termina em { $node }: escreva dois nós diferentes
element = elemento
no-spring-restrains-node-a-constant-force-moves-it-without-bound-so-there-is-no-static-stiffness = nenhuma mola restringe { $node }: uma força constante move-o sem limite, portanto não há rigidez estática
static-displacement-under-the-force-at-each-node-the-spring-forces-balance-the-load = Deslocamento estático sob a força: em cada nó as forças das molas equilibram a carga
equivalent-stiffness-at-the-loaded-node-force-over-displacement = Rigidez equivalente no nó carregado: força sobre deslocamento
force-in-the-spring-positive-from-its-first-node-on = Força na mola, positiva a partir do seu primeiro nó
stiffness-by-eliminating-the-other-nodes-one-by-one-star-and-mesh = rigidez eliminando os outros nós um a um (estrela e malha)
the-forces-at-every-node-add-up-to-zero = as forças em cada nó somam zero
displacement-of-node = Deslocamento do nó
force-in-element = Força no elemento
the-motion-at-this-frequency-grows-without-bound-and-has-no-steady-state-add-damping-or-change-the = nesta frequência o movimento cresce sem limite e não há regime permanente; acrescente amortecimento ou mude a frequência
complex-amplitude-of-the-loaded-node-from-the-equilibrium-of-every-node-with-k-i-c-for-each-element = Amplitude complexa do nó carregado, pelo equilíbrio de cada nó com k + iωc para cada elemento e −mω² para cada massa
its-imaginary-part = A sua parte imaginária
amplitude-of-the-loaded-node = Amplitude do nó carregado
real-part-of-the-dynamic-stiffness-f-x-masses-included = Parte real da rigidez dinâmica F/X, com as massas
imaginary-part-of-the-dynamic-stiffness-contribution-of-the-dampers = Parte imaginária da rigidez dinâmica: contribuição dos amortecedores
magnitude-of-the-dynamic-stiffness = Módulo da rigidez dinâmica
the-power-of-the-force-equals-the-power-dissipated-by-the-dampers = a potência da força é igual à potência dissipada pelos amortecedores
dynamic-stiffness-by-eliminating-the-other-nodes-one-by-one-star-and-mesh = rigidez dinâmica eliminando os outros nós um a um (estrela e malha)
dynamic-stiffness = Rigidez dinâmica
real-part-of-the-dynamic-stiffness = Parte real da rigidez dinâmica
imaginary-part-of-the-dynamic-stiffness = Parte imaginária da rigidez dinâmica
exact-frequency-of-the-motion-e-st-that-meets-the-equations-of-all-nodes = Exata: frequência do movimento e^(st) que satisfaz as equações de todos os nós
exact-frequency-of-free-vibration = Frequência exata da vibração livre
its-rate-of-decay = A sua taxa de decaimento
damping-ratio-of-this-root = Fator de amortecimento dessa raiz
exact-damping-ratio = Fator de amortecimento exato
at-the-root-the-dynamic-stiffness-of-the-network-balances-the-inertia-of-the-mass = na raiz, a rigidez dinâmica da rede equilibra a inércia da massa
the-sum-of-the-roots-is-c-m = a soma das raízes é −Σ c/m
the-dampers-are-so-strong-that-nothing-oscillates-every-motion-returns-without-oscillating = os amortecedores são tão fortes que nada oscila: todo movimento retorna sem oscilar
node-is-unrestrained-join-it-to-ground-directly-or-through-other-elements = { $node } não tem restrição: ligue-o à base, diretamente ou por outros elementos
the-stiffnesses-dampings-and-masses-differ-so-much-that-no-significant-digits-remain-omit-the-nearly = as rigidezes, os amortecimentos e as massas diferem tanto que não restam algarismos significativos: omita os elementos quase rígidos e una os seus nós
from = de
to = a
elastic-energy = energia elástica
force-in-each-element-under-the-harmonic-force = Força em cada elemento sob a força harmônica
receptance-at-the-loaded-node = Receptância no nó carregado
the-springs-combined-at-the-mass-as-if-there-were-no-dampers = As molas associadas na posição da massa, como se não houvesse amortecedores
the-displacement-under-a-unit-force-is-1-k = o deslocamento sob uma força unitária é 1/k
the-dampers-combined-in-the-same-way-as-if-there-were-no-springs = Os amortecedores associados do mesmo modo, como se não houvesse molas
damping-dampers-combined-separately-from-the-springs = Amortecimento, amortecedores associados em separado das molas
damping-ratio-springs-and-dampers-combined-separately = Fator de amortecimento, molas e amortecedores associados em separado
damped-frequency-springs-and-dampers-combined-separately = Frequência amortecida, molas e amortecedores associados em separado
springs-and-dampers-combined-separately-are-exact-only-if-c-k-is-the-same-in-every-element-the-exact = molas e amortecedores associados separadamente só são exatos se c/k é o mesmo em todos os elementos; as raízes exatas também são dadas
exact-roots-s-of-the-free-vibration = Raízes exatas s da vibração livre
the-network = A rede
# torsional-train
discs = Discos
discs-between-the-bearings-and-on-the-overhang = Discos entre os mancais e no balanço
flywheels-rotors-gears-cranks-all-are-referred-to-the-speed-of-the-first-one = Volantes, rotores, engrenagens, manivelas. Todos são referidos à rotação do primeiro.
shafts = Eixos
without-loops-several-may-start-at-one-disc = Sem malhas fechadas; vários podem partir de um disco.
gears = Engrenagens
trial-frequency = Frequência de tentativa
for-the-holzer-table-if-omitted-the-first-natural-frequency-is-used = Para a tabela de Holzer; se omitida, usa-se a primeira frequência natural.
harmonic-torques = Torques harmônicos
light-a-gear-or-a-joint-of-shafts-without-inertia = Leve: uma engrenagem ou junção de eixos sem inércia
fixed-a-wall-in-which-a-shaft-is-clamped = Fixo: uma parede em que um eixo está engastado
a-stepped-shaft-is-a-series-combination-of-its-segments-from-the-first-disc-to-the-second = Um eixo escalonado é a associação em série dos seus trechos, do primeiro disco ao segundo.
driving-gear = Engrenagem motora
driven-gear = Engrenagem movida
speed-of-the-driving-gear-over-that-of-the-driven-one = Rotação da engrenagem motora sobre a da movida
each-shaft-line-is-positive-in-its-own-direction-of-rotation = Cada linha de eixo é positiva no seu próprio sentido de rotação.
torques = Torques
disc = Disco
torsional-train = Trem torcional
natural-frequencies-shapes-and-nodes-of-discs-on-shafts-geared-or-branched-the-holzer-table-and-the = Frequências naturais, formas modais e nós de discos sobre eixos, com engrenagens ou ramos, a tabela de Holzer, e o movimento sob torques harmônicos.
only-one-disc-has-inertia-and-it-is-unrestrained-it-rotates-freely-and-does-not-vibrate = só um disco tem inércia e não tem restrição: ele gira livremente e não vibra
the-train-is-unrestrained-it-can-rotate-as-a-rigid-body-with-zero-frequency-and-no-twist = O trem está livre: pode girar como corpo rígido, com frequência zero e sem torção
mode = Modo
amplitudes-of-mode = Amplitudes do modo
two-discs-on-a-shaft-rotate-in-opposite-directions = Dois discos sobre um eixo giram em sentidos opostos
the-frequency-equation-of-three-discs-is-b-c-0 = A equação das frequências de três discos é ω⁴ − b ω² + c = 0
its-constant-term = O seu termo constante
the-larger-root-in = A raiz maior em ω²
one-node-the-product-of-the-roots-is-c = Um nó: o produto das raízes é c
two-nodes = Dois nós
by-holzer-s-method-at-this-trial-frequency-the-residual-torque-at-the-last-disc-is-zero = Pelo método de Holzer: nesta frequência de tentativa o torque residual no último disco é nulo
shafts-in-series-without-inertia-between-them = Eixos em série, sem inércia entre eles
residual-torque-at-the-last-disc-at-the-trial-frequency-with-unit-rotation-1-rad-of-the-first-disc = Torque residual no último disco na frequência de tentativa, com rotação unitária (1 rad) do primeiro disco
the-inertia-torques-of-the-holzer-table-add-up-to-the-residual = os torques de inércia da tabela de Holzer somam o resíduo
residual-torque-at-the-trial-frequency = Torque residual na frequência de tentativa
elastic-energy-over-kinetic-energy-of-the-mode-shape-is = a energia elástica sobre a cinética da forma modal é ω²
the-holzer-residual-vanishes-at-the-natural-frequency = o resíduo de Holzer anula-se na frequência natural
node-of-the-shaft-from-its-first-end-the-amplitude-falls-from-one-end-to-the-other-as-the-compliance = Nó do eixo, a partir da sua primeira extremidade: a amplitude cai de uma extremidade à outra conforme a flexibilidade se acumula
both-sides-of-the-node-are-twisted-by-the-same-torque = os dois lados do nó são torcidos pelo mesmo torque
node-from-the-first-end-of-its-shaft-mode-node = Nó a partir da primeira extremidade do seu eixo; modo, nó
no-disc-has-a-moment-of-inertia-write-at-least-one-that-has = nenhum disco tem momento de inércia: escreva ao menos um que tenha
there-are-more-than-200-discs-join-some-of-them = há mais de 200 discos: una alguns deles
the-frequency-of-the-torques-equals-a-natural-frequency-of-the-train-without-damping-the-motion-grows = a frequência dos torques é igual a uma frequência natural do trem: sem amortecimento o movimento cresce sem limite e não há regime permanente
the-moments-of-inertia-and-stiffnesses-lead-to-numbers-that-cannot-be-represented-write-realistic = os momentos de inércia e as rigidezes levam a números que não podem ser representados: escreva valores realistas
the-train = O trem
mode-mode-angle-of-twist-along-the-shafts = Modo { $mode }: ângulo de torção ao longo dos eixos
speed-of-the-geared-shaft-over-that-of-the-first-disc = Rotação do eixo engrenado sobre a do primeiro disco
reduced-to-the-speed-of-the-first-disc-the-kinetic-energy-is-the-same = Reduzido à rotação do primeiro disco: a energia cinética é a mesma
meshing-gears-rotate-together-their-reduced-moments-of-inertia-add-up = Engrenagens engrenadas giram juntas: os seus momentos de inércia reduzidos se somam
reduced-to-the-speed-of-the-first-disc-the-elastic-energy-is-the-same = Reduzida à rotação do primeiro disco: a energia elástica é a mesma
a-shaft-joins-disc-to-itself-write-two-different-discs = um eixo liga { $disc } a si mesmo: escreva dois discos diferentes
first-and-second-are-both-fixed-omit-the-shaft-between-them = { $first } e { $second } estão ambos fixos: omita o eixo entre eles
disc-is-fixed-so-it-cannot-be-geared-to-another-let-it-rotate-or-omit-the-gears = { $disc } está fixo, portanto não pode engrenar com outro: deixe-o girar ou omita as engrenagens
disc-is-geared-to-itself-write-two-different-discs = { $disc } engrena consigo mesmo: escreva dois discos diferentes
all-discs-are-fixed-let-at-least-one-rotate = todos os discos estão fixos: deixe ao menos um girar
shafts-and-gears-form-a-closed-loop-at-disc-which-is-not-allowed-in-a-train-join-parallel-shafts-into = eixos e engrenagens formam uma malha fechada em { $disc }, o que não se admite em um trem; una eixos paralelos num só
disc-is-not-joined-to-first-by-shafts-or-gears-that-can-rotate-join-it-or-analyse-it-separately = { $disc } não está ligado a { $first } por eixos ou engrenagens que possam girar: ligue-o ou analise-o separadamente
some-frequencies-are-equal-any-linear-combination-of-their-mode-shapes-is-also-a-mode-shape-of-that = algumas frequências são iguais: qualquer combinação linear das suas formas modais é também uma forma modal dessa frequência
similarly = Do mesmo modo
rigid-body-rotation = rotação de corpo rígido
natural-frequencies-and-amplitudes-of-the-discs = Frequências naturais e amplitudes dos discos
holzer-table-at-frequency-all-reduced-to-the-speed-of-the-first-disc = Tabela de Holzer em { $frequency }, tudo reduzido à rotação do primeiro disco
nodes-of-the-shafts = Nós dos eixos
shaft-from = eixo de
distance-of-the-node = distância do nó
part-of-the-compliance = parte da flexibilidade
holzer-residual-torque-against-trial-frequency = Torque residual de Holzer em função da frequência de tentativa
residual-torque-sum-of-all-inertia-torques = torque residual / soma de todos os torques de inércia
residual = resíduo
natural-frequencies = frequências naturais
zero-residual = resíduo nulo
a-torque-acts-on-a-fixed-disc-so-it-excites-nothing-write-a-disc-that-can-rotate = um torque atua num disco fixo, portanto nada excita: escreva um disco que possa girar
steady-state-amplitude-equilibrium-of-each-disc-under-its-shaft-torques-its-inertia-torque-and-the = Amplitude em regime permanente: equilíbrio de cada disco sob os torques dos eixos, o torque de inércia e o torque aplicado; negativa onde se move contra os torques
amplitude-of-disc = Amplitude do disco
amplitudes-under-the-torques = Amplitudes sob os torques
torques-inertia-torques-and-wall-torques-sum-to-zero = torques, torques de inércia e torques nas paredes somam zero
the-sum-over-all-modes-gives-the-same-amplitudes = a soma sobre todos os modos dá as mesmas amplitudes
# vibration/frequency-response-identification, shaft-clearance, whirling-shaft
n-1-stands-for-the-critical-speed-itself = 1 indica a própria velocidade crítica.
a-force-of-constant-amplitude = Uma força de amplitude constante
a-quarter-of-the-circle-after-it-upper-half-power-point = Um quarto de círculo depois dela: ponto de meia potência superior
a-rotating-unbalance = Um desbalanceamento em rotação
stiffness-to-be-checked = Rigidez a verificar
above-the-critical-speed-undamped-the-centre-of-mass-lies-on-the-inside-opposite-to-the-deflection = Acima da velocidade crítica, sem amortecimento: o centro de massa fica para dentro, oposto à deflexão
accelerance-amplitude-and-phase = Acelerância, amplitude e fase
accelerance-real-and-imaginary-part = Acelerância, partes real e imaginária
all-shaft-diameters-or-stiffnesses-eccentricities-or-speeds-for-which-an-unbalanced-rotor-does-not = Todos os diâmetros ou rigidezes do eixo, excentricidades ou rotações com que um rotor desbalanceado não toca o estator.
amplitude-against-frequency-ratio = Amplitude em função da razão de frequências
amplitude-as-a-multiple-of-m-e-m = Amplitude como múltiplo de m₀e/m
amplitude-at-resonance = Amplitude na ressonância
amplitude-at-resonance-over-that-at-another-frequency = Amplitude na ressonância sobre a amplitude em outra frequência
amplitude-at-the-first-speed = Amplitude na primeira rotação
amplitude-at-the-natural-frequency-over-the-other-amplitude = Amplitude na frequência natural sobre a outra amplitude
amplitude-at-the-natural-frequency-under-this-force = Amplitude na frequência natural sob esta força
amplitude-at-the-second-speed = Amplitude na segunda rotação
amplitude-far-above-the-resonance = Amplitude muito acima da ressonância
amplitude-of-the-receptance = Amplitude da receptância
as-the-maximum-of-all-amplitudes = Como a máxima de todas as amplitudes
at-the-natural-frequency = Na frequência natural
at-the-natural-frequency-the-amplitude-is-m-e-2-m-far-above-it-m-e-m = Na frequência natural a amplitude é m₀e/(2ζm); muito acima dela, m₀e/m
shaft-orientation = Orientação do eixo
the-shaft-and-its-section-not-to-scale-bearing-centre-o-shaft-centre-w-centre-of-mass-g = O eixo e a sua seção (fora de escala): centro dos mancais O, centro do eixo W, centro de massa G
lower-limit-of-the-forbidden-range = Limite inferior da faixa proibida
lower-limit-of-the-forbidden-range-the-whirl-amplitude-reaches-the-permitted-value = Limite inferior da faixa proibida: a amplitude de precessão atinge o valor admissível
below-the-critical-speed-undamped-the-centre-of-mass-lies-on-the-outside-in-line-with-the-deflection = Abaixo da velocidade crítica, sem amortecimento: o centro de massa fica para fora, alinhado com a deflexão
bending-moment-at-the-permitted-stress = Momento fletor na tensão permitida
critical-speed-of-the-shaft-to-be-checked = Velocidade crítica do eixo a verificar
critical-speed-whirl-amplitude-and-phase-bearing-force-and-bending-stress-of-an-unbalanced-rotor-and = Velocidade crítica, amplitude e fase da precessão, força nos mancais e tensão de flexão de um rotor desbalanceado, e as velocidades a evitar.
critical-speed-the-natural-frequency-of-the-rotor-on-its-shaft = Velocidade crítica: a frequência natural do rotor sobre o seu eixo
damping-ratio-by-the-same-least-squares = Fator de amortecimento pelos mesmos mínimos quadrados
damping-ratio-from-the-half-power-frequencies-exact-for-one-mode-with-viscous-damping = Fator de amortecimento pelas frequências de meia potência, exato para um modo com amortecimento viscoso
damping-ratio-from-the-half-power-points-exact-for-the-mobility = Fator de amortecimento pelos pontos de meia potência, exato para a mobilidade
damping-ratio-circle-fit = Fator de amortecimento, ajuste de círculo
damping-ratio-from-q-1-r-2-r-2 = Fator de amortecimento, de q² = ((1 − r²)² + (2ζr)²)/(2ζ)²
damping-ratio-from-q-1-r-2-r-2-r = Fator de amortecimento, de q² = ((1 − r²)² + (2ζr)²)/(2ζr²)²
damping-ratio-the-same-equation-at-the-first-speed = Fator de amortecimento: a mesma equação na primeira rotação
damping-ratio-d-1-and-1-2-so-that-d-1-2-1 = Fator de amortecimento: ω_d = ωₙ√(1 − ζ²) e ωₚ = ωₙ√(1 − 2ζ²), de modo que (ωₚ/ω_d)² = (1 − 2ζ²)/(1 − ζ²)
diameter-of-the-nyquist-circle = Diâmetro do círculo de Nyquist
diameter-of-the-circle-through-the-mobilities-from-a-least-squares-fit-of-x-y-ax-by-c = Diâmetro do círculo pelas mobilidades, por mínimos quadrados de x² + y² + ax + by + c
diameter-of-the-circle-through-the-receptances-from-a-least-squares-fit-of-x-y-ax-by-c = Diâmetro do círculo pelas receptâncias, por mínimos quadrados de x² + y² + ax + by + c
diameter-of-the-shaft = Diâmetro do eixo
distance-of-the-centre-of-mass-of-the-rotor-from-the-shaft-axis = Distância do centro de massa do rotor à linha de centro do eixo.
eccentricity = Excentricidade
eccentricity-as-a-fraction-of-the-permitted-amplitude = Excentricidade como fração da amplitude admissível
eccentricity-given = Excentricidade dada
eccentricity-of-the-rotor = Excentricidade do rotor
eccentricity-for-which-the-whirl-amplitude-at-that-speed-equals-the-clearance = Excentricidade para a qual a amplitude de precessão nessa rotação é igual à folga
upper-limit-of-the-forbidden-range = Limite superior da faixa proibida
upper-limit-of-the-forbidden-range-the-whirl-amplitude-returns-to-the-permitted-value = Limite superior da faixa proibida: a amplitude de precessão volta ao valor admissível
first-speed = Primeira rotação
total-bearing-force-due-to-the-shaft-deflection = Força total nos mancais devida à deflexão do eixo
force-of-the-deflected-shaft-which-rotates-with-it = Força do eixo fletido, que gira com ele
force-on-the-rotor-that-produces-this-moment = Força no rotor que produz esse momento
frequencies-of-free-vibration-and-of-the-forced-peak = Frequências da vibração livre e do pico forçado
frequency-a-quarter-of-the-circle-before-it-lower-half-power-point = Frequência um quarto de círculo antes dela: ponto de meia potência inferior
frequency-of-the-free-damped-vibration = Frequência da vibração livre amortecida
frequency-of-maximum-amplitude-under-a-force = Frequência da amplitude máxima sob uma força
frequency-of-the-other-amplitude-over-the-natural-frequency = Frequência da outra amplitude sobre a frequência natural
frequency-ratio-at-this-speed = Razão de frequências nesta rotação
frequency-response = Resposta em frequência
from-the-maximum-whirl-amplitude-at-any-speed = Pela amplitude máxima de precessão em qualquer rotação
height-of-the-measured-peak-vertex-of-the-parabola-of-1-h-against-through-the-highest-point-and-its = Altura do pico medido: vértice da parábola de 1/H² em função de ω² pelo ponto mais alto e seus vizinhos
highest-frequency-used = Frequência máxima usada
horizontal-the-weight-bends-the-shaft = Horizontal, o peso flete o eixo
difference-between-the-methods-in-the-damping-ratio = Diferença entre os métodos no fator de amortecimento
difference-between-the-methods-in-the-natural-frequency = Diferença entre os métodos na frequência natural
hysteretic-the-circle-is-that-of-the-receptance = Histerético: o círculo é o da receptância
rotor-unbalance = Desbalanceamento do rotor
kind-of-damping = Tipo de amortecimento
lag-of-the-deflection-against-speed = Atraso da deflexão em função da velocidade
lag-of-the-deflection-behind-the-centre-of-mass = Atraso da deflexão em relação ao centro de massa
maximum-amplitude-as-a-multiple-of-that-far-above-the-resonance = Amplitude máxima como múltiplo daquela muito acima da ressonância
maximum-amplitude-in-the-range-of-speeds-against-eccentricity = Amplitude máxima na faixa de rotações em função da excentricidade
maximum-amplitude-in-the-range-of-speeds-against-stiffness = Amplitude máxima na faixa de rotações em função da rigidez
maximum-amplitude-of-the-shaft-to-be-checked = Amplitude máxima do eixo a verificar
maximum-bending-moment = Momento fletor máximo
maximum-bending-stress = Tensão de flexão máxima
maximum-bending-stress-of-the-shaft = Tensão de flexão máxima do eixo
maximum-bending-stress-32m-d = Tensão de flexão máxima, 32M/(πd³)
maximum-force-of-the-whirl-on-the-bearings = Força máxima da precessão do eixo nos mancais
maximum-force-on-one-bearing = Força máxima em um mancal
maximum-total-force-on-the-bearings-weight-included = Força total máxima nos mancais, peso incluído
maximum-force-once-per-revolution-the-whirl-points-down-with-the-weight = Força máxima: uma vez por volta a precessão do eixo aponta para baixo, com o peso
maximum-permitted-eccentricity = Excentricidade máxima permitida
maximum-permitted-force = Força máxima permitida
maximum-permitted-stress = Tensão máxima permitida
maximum-permitted-unbalance = Desbalanceamento máximo permitido
maximum-permitted-whirl-amplitude = Amplitude máxima de precessão permitida
maximum-steady-state-whirl-at-any-speed = Precessão máxima em regime permanente em qualquer rotação
maximum-available-stiffness = Rigidez máxima disponível
maximum-whirl-amplitude = Amplitude máxima de precessão
maximum-whirl-amplitude-as-a-multiple-of-the-eccentricity = Amplitude máxima de precessão como múltiplo da excentricidade
maximum-whirl-amplitude-at-any-speed = Amplitude máxima de precessão em qualquer rotação
limit = Limite
loss-factor-by-the-same-least-squares = Fator de perda pelos mesmos mínimos quadrados
loss-factor-from-the-half-power-points-exact-for-the-receptance = Fator de perda pelos pontos de meia potência, exato para a receptância
lower-half-power-frequency-circle-fit = Frequência de meia potência inferior, ajuste de círculo
lowest-frequency-used = Frequência mínima usada
mass-residual = Resíduo de massa
mass-residual-for-the-modes-below = Resíduo de massa, pelos modos abaixo
mobility-amplitude-and-phase = Mobilidade, amplitude e fase
mobility-real-and-imaginary-part = Mobilidade, partes real e imaginária
modal-constant = Constante modal
modal-constant-by-the-same-least-squares = Constante modal pelos mesmos mínimos quadrados
modal-constant-the-diameter-is-a-2 = Constante modal: o diâmetro é A/(2ζωₙ)
modal-constant-the-diameter-is-a = Constante modal: o diâmetro é A/(ηωₙ²)
modal-constant-the-peak-is-a-2-1 = Constante modal: o pico é A/(2ζωₙ²√(1 − ζ²))
modal-mass-one-over-the-modal-constant-where-the-motion-is-that-of-the-point-of-the-force = Massa modal: o inverso da constante modal, quando o movimento é o do ponto da força
modes-above-and-below-a-constant-receptance-and-a-mass-line = Modos acima e abaixo: uma receptância constante e uma linha de massa
modes-above-a-constant-receptance = Modos acima: uma receptância constante
multiple-of-the-critical-speed = Múltiplo da velocidade crítica
natural-frequency-by-least-squares-of-the-complex-differences-from-a-2i-r-s = Frequência natural por mínimos quadrados das diferenças complexas para A/(ωₙ² − ω² + 2iζωₙω) + R − S/ω²
natural-frequency-by-least-squares-of-the-complex-differences-from-a-i-r-s = Frequência natural por mínimos quadrados das diferenças complexas para A/(ωₙ² − ω² + iηωₙ²) + R − S/ω²
natural-frequency-circle-fit = Frequência natural, ajuste de círculo
natural-frequency-at-each-speed-2-4-1-1-subtracting-the-two-leaves-only = Frequência natural: em cada rotação ωₙ⁴ − 2ωₙ²ω² + 4ζ²ωₙ²ω² = ω⁴(1/Λ² − 1); a diferença das duas deixa só ωₙ⁴
natural-frequency-the-peak-lies-at-1-2 = Frequência natural: o pico fica em ωₙ√(1 − 2ζ²)
natural-frequency-where-the-points-go-round-the-circle-fastest-by-least-squares-of-their-angles = Frequência natural: onde os pontos percorrem o círculo mais depressa, por mínimos quadrados dos seus ângulos
negative-if-the-motion-lags-the-force = Negativa quando o movimento está atrasado em relação à força.
nyquist-plot-of-the-mobility = Diagrama de Nyquist da mobilidade
nyquist-plot-of-the-receptance = Diagrama de Nyquist da receptância
of-the-resistance-of-the-surroundings-at-the-rotor = Da resistência do meio no rotor.
on-all-bearings-together-without-the-weight = No conjunto dos mancais, sem o peso.
single-mode = Um único modo
other-modes = Outros modos
permitted-eccentricities = Excentricidades permitidas
permitted-speeds = Rotações permitidas
permitted-stiffnesses = Rigidezes permitidas
permitted-whirl-amplitude = Amplitude de precessão permitida
permitted-whirl-amplitude-the-force-of-the-bent-shaft-is-k-a = Amplitude de precessão permitida: a força do eixo fletido é k A
phase-of-the-receptance = Fase da receptância
points-above-it-are-ignored = Pontos acima dela são ignorados.
points-below-it-are-ignored = Pontos abaixo dela são ignorados.
quality-factor = Fator de qualidade
from-a-circle-fit-and-complex-least-squares-compared-with-estimates-from-the-amplitude-alone = Lida por ajuste de círculo e por mínimos quadrados complexos, em comparação com as leituras só da amplitude.
receptance-of-the-mode-at-its-natural-frequency-a-2 = Receptância do modo na sua frequência natural, A/(2ζωₙ²)
receptance-amplitude-and-phase = Receptância, amplitude e fase
receptance-real-and-imaginary-part = Receptância, partes real e imaginária
root-mean-square-of-the-differences-between-fitted-and-measured-response-over-the-largest-measured = Média quadrática das diferenças entre a resposta ajustada e a medida, sobre a maior medida
root-mean-square-of-the-distances-of-the-points-from-the-circle-over-its-radius = Média quadrática das distâncias dos pontos ao círculo, sobre o seu raio
fit-residual-of-the-points-about-the-circle = Resíduo do ajuste dos pontos ao círculo
second-moment-of-area-of-the-shaft = Momento de inércia de área do eixo
second-speed = Segunda velocidade
secondary-critical-speed-of-a-horizontal-shaft-with-the-weight-the-unbalance-produces-two-pulses-per = Velocidade crítica secundária de um eixo horizontal: com o peso, o desbalanceamento produz dois pulsos por volta
secondary-critical-speed-gravity-2 = Velocidade crítica secundária (2×), pelo peso
load-on-the-more-heavily-loaded-bearing = Carga no mancal mais carregado
minimum-available-stiffness = Rigidez mínima disponível
solid-circular-shaft = Eixo circular maciço
speed-given = Velocidade dada
speed-of-maximum-steady-state-whirl-amplitude = Rotação de máxima precessão em regime permanente
speed-of-maximum-whirl-amplitude = Rotação de máxima precessão
speed-of-the-rotor = Rotação do rotor
speed-of-the-shaft = Rotação do eixo
speed-over-critical-speed = Velocidade sobre velocidade crítica
spread-of-the-natural-frequency = Dispersão da frequência natural
static-deflection-due-to-the-weight = Deflexão estática devida ao peso
stiffness-of-the-shaft-at-the-rotor = Rigidez do eixo no rotor
stiffness-residual = Termo residual de rigidez
stiffness-residual-for-the-higher-modes = Termo residual de rigidez, dos modos superiores
stiffness-that-gives-the-natural-frequency = Rigidez que dá a frequência natural
stiffness-mass-and-damping-of-one-degree-of-freedom-from-a-measured-frequency-response-real-or = Rigidez, massa e amortecimento de um sistema de um grau de liberdade a partir de uma resposta em frequência medida, real ou complexa, ou de poucos pontos dela.
table-of-the-complex-frequency-response = Tabela da resposta em frequência complexa
including-that-due-to-the-weight = Inclui a devida ao peso.
the-amplitude-at-resonance-was-read = A amplitude na ressonância foi lida
the-deflection-lags-the-direction-of-the-centre-of-mass-by = Ângulo de fase (atraso) da deflexão em relação à direção do centro de massa
comparison-of-the-methods = Comparação dos métodos
the-peak-is-e-2-1-a-quadratic-equation-in-its-smaller-root = O pico é e/(2ζ√(1 − ζ²)), uma equação do segundo grau em ζ²; a sua raiz menor
the-corresponding-unbalance = O desbalanceamento correspondente
the-same-for-every-shaft-so-that-the-coefficient-varies-with-the-stiffness = A mesma para todos os eixos, de modo que o coeficiente varia com a rigidez.
the-same-for-every-shaft = O mesmo para todos os eixos.
there-it-is-m-e-m-whatever-the-damping = Ali ela é m₀e/m, qualquer que seja o amortecimento.
three-at-least-in-any-order-about-one-resonance = Pelo menos três, em qualquer ordem, em torno de uma ressonância.
unbalance-given = Desbalanceamento dado
unbalance-amplitudes-at-resonance-and-far-above-it = Desbalanceamento: amplitudes na ressonância e muito acima dela
unbalance-amplitudes-at-two-speeds = Desbalanceamento: amplitudes em duas rotações
upper-half-power-frequency-circle-fit = Frequência de meia potência superior, ajuste de círculo
vertical-or-weight-neglected = Vertical, ou peso desprezado
viscous-damping-ratio-with-the-same-loss-at-the-natural-frequency = Fator de amortecimento viscoso com a mesma perda na frequência natural
viscous-damping-with-the-same-loss-at-the-natural-frequency-k = Amortecimento viscoso com a mesma perda na frequência natural, ηk/ωₙ
viscous-mobility-circle = Viscoso: círculo da mobilidade
weight-of-the-rotor = Peso do rotor
part-available-for-the-whirl-after-the-weight = Parte disponível para a precessão, descontado o peso
if-given-the-speeds-that-satisfy-it-are-also-computed = Se for dado, as rotações que o respeitam também são calculadas.
whirl-amplitude = Amplitude de precessão
whirl-amplitude-against-speed = Amplitude de precessão em função da rotação
whirl-amplitude-the-deflection-of-the-shaft-at-the-rotor = Amplitude de precessão: a deflexão do eixo no rotor
whirl-of-a-rotor-on-a-flexible-shaft = Precessão de um rotor em eixo flexível
worst-speed = Pior velocidade
worst-case-speed = Rotação mais desfavorável
worst-case-speed-of-the-shaft-to-be-checked = Rotação mais desfavorável do eixo a verificar
worst-case-speed-the-highest-below-the-resonance = Rotação mais desfavorável: a maior, abaixo da ressonância
worst-case-speed-the-lowest-above-the-resonance = Rotação mais desfavorável: a menor, acima da ressonância
worst-case-speed-the-peak-of-the-response-within-the-range = Rotação mais desfavorável: o pico da resposta, dentro da faixa
the-frequency-frequency-appears-twice-in-the-table-keep-one-point-or-the-mean-for-each-frequency = a frequência { $frequency } aparece duas vezes na tabela: fique com um ponto, ou com a média, para cada frequência
a-stress-limit-needs-the-dimensions-of-the-shaft-describe-the-shaft-or-give-a-limit-of-amplitude-or = um limite de tensão precisa das dimensões do eixo: descreva o eixo, ou dê um limite de amplitude ou de força
a-slow-run-up-reaches-largest-at-speed-a-fast-one-reaches-less = uma partida lenta atinge { $largest } em { $speed }; uma rápida atinge menos
above-the-forbidden-range-the-rotor-has-passed-its-critical-speed-run-through-the-range-quickly = acima da faixa proibida o rotor já passou pela velocidade crítica: atravesse a faixa depressa
amplitude-over-m-e-m = amplitude sobre m₀e/m
amplitude-over-static-deflection = amplitude sobre deflexão estática
at-the-natural-frequency-the-damper-alone-balances-the-force-1-c = na frequência natural só o amortecedor equilibra a força: 1/(c ωₙ)
bending-stress-from-the-deflection-alone = tensão de flexão só pela deflexão
both-amplitudes-are-those-at-the-natural-frequency-measure-one-at-another-frequency = as duas amplitudes são as da frequência natural: meça uma em outra frequência
circle-fit = ajuste de círculo
complex-least-squares = mínimos quadrados complexos
critical-speed-and-mass-reproduce-the-stiffness = velocidade crítica e massa reproduzem a rigidez
critical-speed-from-the-static-deflection-g = velocidade crítica pela deflexão estática, √(g/δ)
fitted = ajustada
fitted-circle = círculo ajustado
forces-perpendicular-to-the-deflection-damping-force-m-e-sin = forças perpendiculares à deflexão: força de amortecimento = m e ω² sen φ
forces-along-the-deflection-spring-force-minus-inertia-force-m-e-cos = forças ao longo da deflexão: força da mola menos força de inércia = m e ω² cos φ
lag = atraso
largest = maior
lower-half-power-point = ponto de meia potência inferior
modal-constant-from-the-half-power-frequencies-alone = constante modal só pelas frequências de meia potência
natural-frequency-from-the-forced-peak = frequência natural pelo pico forçado
natural-frequency-from-the-half-power-points = frequência natural pelos pontos de meia potência
no-available-stiffness-keeps-the-rotor-clear-change-clearance-unbalance-damping-or-speeds = nenhuma rigidez disponível evita o contato: mude folga, desbalanceamento, amortecimento ou rotações
no-damped-mode-fits-these-points-choose-a-range-of-frequencies-about-one-resonance-only-and-check = nenhum modo amortecido se ajusta a estes pontos: escolha uma faixa de frequências em torno de uma só ressonância e verifique se ali a parte imaginária da receptância é negativa
no-damping-gives-an-amplitude-ratio-as-small-as-this-it-must-be-above-least = nenhum amortecimento dá uma razão de amplitudes tão pequena: ela deve estar acima de { $least }
no-natural-frequency-gives-these-amplitudes-at-these-speeds-do-amplitudes-speeds-and-m-e-m-belong-to = nenhuma frequência natural dá estas amplitudes nestas velocidades: amplitudes, velocidades e m₀e/m são de uma só massa sobre uma só mola?
pairs-of-points-below-and-above-the-natural-frequency-give-damping-values-that-differ-by-spread-noise = pares de pontos abaixo e acima da frequência natural dão amortecimentos que diferem em { $spread }: ruído, amortecimento de outro tipo, ou outro modo próximo
stress-from-the-deflection-under-that-force = tensão pela deflexão sob essa força
the-amplitude-at-resonance-does-not-exceed-that-far-above-it-so-there-is-no-resonance-write-the = a amplitude na ressonância não supera a que ocorre muito acima dela, portanto não há ressonância: escreva a maior amplitude como a da ressonância
the-amplitude-at-the-first-speed = a amplitude na primeira velocidade
the-amplitude-at-the-second-speed = a amplitude na segunda velocidade
the-angles-round-the-circle-satisfy-their-normal-equations = os ângulos em torno do círculo satisfazem as suas equações normais
the-critical-speed-speed-lies-within-the-range-and-there-is-no-damping-the-amplitude-grows-there = a velocidade crítica, { $speed }, está dentro da faixa e não há amortecimento: ali a amplitude cresce sem limite para qualquer excentricidade não nula
the-damping-ratio-reproduces-the-amplitude-at-the-natural-frequency = o fator de amortecimento reproduz a amplitude na frequência natural
the-damping-ratio-reproduces-the-amplitude-ratio = o fator de amortecimento reproduz a razão das amplitudes
the-damping-ratio-is-above-0-1-the-half-power-points-are-far-from-the-peak-and-other-modes-contribute = o fator de amortecimento está acima de 0,1: os pontos de meia potência estão longe do pico, e outros modos contribuem para a faixa entre eles
the-damping-ratio-is-above-0-1-readings-that-take-the-peak-frequency-as-the-natural-frequency-are-in = o fator de amortecimento está acima de 0,1: leituras que tomam a frequência do pico como a natural erram mais de 1 %
end-of-the-band-from-its-other-formula = fim da faixa pela sua outra fórmula
the-frequencies-of-the-table-are-not-in-ascending-order-they-were-sorted = as frequências da tabela não estão em ordem crescente: foram ordenadas
the-largest-amplitude-is-the-first-or-the-last-of-the-range-so-the-peak-was-not-measured-the-peak-and = a maior amplitude é a primeira ou a última da faixa, portanto o pico não foi medido: o pico e os pontos de meia potência não podem ser avaliados, e as outras leituras extrapolam além da faixa medida
the-largest-whirl-amplitude-is-not-above-the-eccentricity-so-no-damping-gives-a-peak-at-a-finite = a maior amplitude de precessão não está acima da excentricidade, portanto nenhum amortecimento dá um pico em velocidade finita: escreva uma amplitude maior
the-maximum-whirl-from-the-whirl-amplitude-at-its-speed = a precessão máxima do eixo pela amplitude de precessão na sua velocidade
at-every-stiffness-the-rotor-stays-clear-of-the-stator-with-this-damping-the-clearance-is-not-a = com qualquer rigidez o rotor não toca o estator com este amortecimento: a folga não é restritiva
the-limit-is-not-a-constraint-with-this-damping-the-whirl-stays-within-it-at-every-speed = o limite não é restritivo: com este amortecimento a precessão do eixo fica dentro dele em qualquer velocidade
the-limit-is-reached-below-the-critical-speed-speed = o limite é atingido abaixo da velocidade crítica, { $speed }
the-limit-leads-to-values-outside-the-representable-range = o limite leva a valores fora da faixa representável
the-lowest-frequency-of-the-reading-range-is-not-below-the-highest-one-exchange-them = a menor frequência da faixa lida não está abaixo da maior: troque-as
the-modal-constant-is-negative-force-and-motion-are-not-at-the-same-point-and-no-mass-can-be = a constante modal é negativa: força e movimento não são de um mesmo ponto, e dela não se identifica massa
the-peak-under-a-force-lies-above-the-frequency-of-the-free-vibration-which-is-impossible-with-any = o pico sob uma força está acima da frequência da vibração livre, o que é impossível com qualquer amortecimento: troque as duas frequências, ou interprete o pico como o de um desbalanceamento
the-point-at-frequency-zero-is-omitted-phase-and-circle-begin-above-it = o ponto na frequência zero é omitido: fase e círculo começam acima dela
the-points-do-not-lie-on-a-circle-in-the-nyquist-plane-check-that-real-and-imaginary-part-or = os pontos não estão sobre um círculo no plano de Nyquist: verifique se as partes real e imaginária, ou amplitude e fase, estão nas suas colunas
the-points-scatter-by-more-than-5-of-the-peak-about-the-fit-noise-or-more-than-one-mode-in-this-range = os pontos se dispersam mais de 5 % do pico em torno do ajuste: ruído, ou mais de um modo nesta faixa
the-amplitude-does-not-return-within-the-limit-above-the-critical-speed-there-it-decreases-towards = a amplitude não volta ao limite acima da velocidade crítica: ali ela cai em direção à excentricidade, que não está abaixo do limite
the-shaft-passes-its-critical-speed-before-reaching-its-running-speed-and-without-damping-the = o eixo passa pela velocidade crítica antes de atingir a rotação de operação, e sem amortecimento a amplitude ali cresce sem limite, proporcional ao tempo: atravesse-a depressa
the-shaft-to-be-judged-has-its-critical-speed-speed-within-the-range-without-damping-the-amplitude = o eixo a julgar tem a sua velocidade crítica, { $speed }, dentro da faixa: sem amortecimento a amplitude ali cresce sem limite
the-shaft-to-be-judged-leads-to-values-outside-the-representable-range = o eixo a julgar leva a valores fora da faixa representável
with-the-shaft-to-be-judged-the-rotor-touches-the-stator-amplitude-at-speed = com o eixo a julgar o rotor toca o estator: { $amplitude } em { $speed }
the-shaft-turns-within-5-of-its-critical-speed-with-little-damping-small-errors-of-mass-stiffness-or = o eixo gira a menos de 5 % da velocidade crítica com pouco amortecimento: pequenos erros de massa, rigidez ou velocidade mudam muito a amplitude
the-two-frequencies-are-the-same-there-is-no-damping-or-it-is-too-light-to-be-read-from-them = as duas frequências são iguais: não há amortecimento, ou ele é leve demais para ser lido delas
the-two-frequencies-differ-by-less-than-0-5-the-damping-ratio-follows-from-their-difference-so-that-a = as duas frequências diferem em menos de 0,5 %: o fator de amortecimento vem da diferença, de modo que um pequeno erro em uma delas o muda muito
the-two-speeds-are-the-same-measure-at-another-one = as duas velocidades são iguais: meça em outra
the-weight-of-the-rotor-alone-bends-the-shaft-beyond-the-permitted-stress-give-a-higher-stress-a = só o peso do rotor já flete o eixo além da tensão permitida: dê uma tensão maior, um eixo mais grosso ou um rotor mais leve
the-whirl-amplitude-exceeds-a-tenth-of-the-shaft-length-the-deflections-are-not-small-and-no-shaft = a amplitude de precessão passa de um décimo do comprimento do eixo: as deflexões não são pequenas, e nenhum eixo resiste a isso
the-whirl-amplitude-at-that-speed-equals-the-permitted-value = a amplitude de precessão nessa velocidade é igual à permitida
above-the-critical-speed-speed-the-whirl-is-within-the-limit-again = acima da velocidade crítica, { $speed }, a precessão do eixo volta ao limite
the-worst-case-speed-from-a-comparison-of-range-ends-and-peak = a pior rotação pela comparação dos extremos da faixa com o pico
there-are-fewer-than-three-frequencies-above-zero-in-the-reading-range-measure-more-or-widen-it = há menos de três frequências acima de zero na faixa lida: meça mais, ou alargue a faixa
there-are-too-few-frequencies-above-zero-need-at-least-are-needed = há poucas frequências acima de zero: são necessárias pelo menos { $need }
these-amplitudes-are-larger-than-any-damping-allows-do-amplitudes-speeds-and-m-e-m-belong-to-one-mass = estas amplitudes são maiores do que qualquer amortecimento permite: amplitudes, velocidades e m₀e/m são de uma só massa sobre uma só mola?
upper-half-power-point = ponto de meia potência superior
with-that-eccentricity-the-dynamic-stiffness-gives-the-clearance = com essa excentricidade a rigidez dinâmica dá a folga
without-damping-the-whirl-at-the-critical-speed-grows-without-bound-in-proportion-to-the-time-there = sem amortecimento, a precessão do eixo na velocidade crítica cresce sem limite, proporcional ao tempo: não há regime permanente
count-points-are-too-few-the-circle-and-the-fit-pass-through-them-whatever-their-errors-measure-more = { $count } pontos são insuficientes: o círculo e o ajuste passam por eles quaisquer que sejam os seus erros; meça mais frequências em torno da ressonância
count-points-are-repeated-in-the-table-with-the-same-values-each-is-used-once = { $count } pontos se repetem na tabela com os mesmos valores: cada um é usado uma vez

# vibration/duffing-oscillator
duffing-oscillator = Oscilador de Duffing
work-of-the-force-in-a-cycle-work-of-the-damper-fa-sin-c-a = trabalho da força em um ciclo = trabalho do amortecedor, πFA sen φ = πcωA²
virtual-work-of-spring-and-inertia-over-a-cycle-of-the-cosine-by-summation = trabalho virtual de mola e inércia em um ciclo do cosseno, por soma
third-harmonic-inertia-spring-and-damper-forces-balance-that-of-the-cubic-term-by-products-of-the = terceiro harmônico: as forças de inércia, da mola e do amortecedor equilibram a do termo cúbico, por produtos dos harmônicos
at-that-amplitude-the-spring-force-is-zero = nessa amplitude a força da mola é zero
spring-and-inertia-forces-are-balanced-by-the-force-component-in-phase-with-the-motion = as forças da mola e de inércia são equilibradas pela componente da força em fase com o movimento
period-at-small-amplitudes-by-quadrature-of-dt-dx-v-from-the-energy = período em pequenas amplitudes pela quadratura de dt = dx/v, da energia
maximum-displacement-where-the-total-velocity-of-both-harmonics-is-zero = deslocamento máximo: onde a velocidade total dos dois harmônicos é zero
at-the-jump-the-spring-inertia-and-damping-forces-balance-the-applied-force = no salto, as forças de mola, de inércia e de amortecimento equilibram a força aplicada
at-the-jump-a-small-change-of-the-amplitude-needs-no-change-of-the-force = no salto uma pequena variação da amplitude não exige variação da força
exact-free-period-or-forced-amplitudes-with-backbone-curve-jumps-and-stability-of-a-mass-on-a-spring = Período livre exato, ou amplitudes forçadas com curva dorsal, saltos e estabilidade, de uma massa sobre uma mola com termo cúbico.
stiffness-at-small-displacements = Rigidez para pequenos deslocamentos
cubic-stiffness-coefficient = Coeficiente de rigidez cúbica
the-force-of-the-spring-is-k-x-h-x-positive-for-a-hardening-spring-negative-for-a-softening-one = A força da mola é k x + h x³: positivo para mola que endurece, negativo para mola que amolece.
free-released-from-rest = Livre, solta do repouso
forced-vibration-under-a-harmonic-force-with-viscous-damping = Vibração forçada por uma força harmônica, com amortecimento viscoso
natural-frequency-at-small-amplitudes = Frequência natural para pequenas amplitudes
stability-limit-of-a-softening-spring-beyond-it-the-mass-does-not-return = Limite de estabilidade da mola que amolece: além dele a massa não retorna
amplitude-of-zero-restoring-force = Amplitude de força restauradora nula
at-this-amplitude-the-softening-spring-exerts-no-restoring-force-choose-an-amplitude-below-k-h = nesta amplitude a mola que amolece não exerce força restauradora: escolha uma amplitude abaixo de √(k/|h|)
frequency-of-the-elliptic-cosine-that-satisfies-the-equation = Frequência do cosseno elíptico que satisfaz a equação
n-1-h-a-2-k-h-a-arithmetic-geometric-mean-of-1-and-this = √(1 − κ²), κ² = h A²/(2(k + h A²)); média aritmético-geométrica de 1 e deste valor
arithmetic-mean = Média aritmética
geometric-mean = Média geométrica
exact-period-four-quarter-periods-k = Período exato: quatro quartos de período K(κ)/Ω
exact-frequency = Frequência exata
period-by-quadrature-of-dt-dx-v-from-the-energy = período pela quadratura de dt = dx/v, da energia
harmonic-balance-with-one-term-x-a-cos-t = Balanço harmônico com um termo: x³ ≈ ¾ A³ cos ωt
period-by-harmonic-balance = Período pelo balanço harmônico
relative-error-of-harmonic-balance = Erro relativo do balanço harmônico
error-of-harmonic-balance = Erro do balanço harmônico
no-steady-state-vibration-was-found-these-values-differ-too-much-in-magnitude-check-the-units-of-h = nenhuma vibração em regime permanente foi encontrada: estes valores são díspares demais; confira as unidades de h e F
root-of-the-balance-of-the-first-harmonic-stable-a-larger-amplitude-requires-a-larger-force = Raiz do balanço do primeiro harmônico; estável: amplitude maior exige força maior
root-of-the-balance-of-the-first-harmonic-unstable-a-larger-amplitude-requires-a-smaller-force-so-it = Raiz do balanço do primeiro harmônico; instável: amplitude maior exige força menor, e por isso ela salta
spring-inertia-and-damper-balance-the-force = mola, inércia e amortecedor equilibram a força
amplitude-of-the-first-harmonic = Amplitude do primeiro harmônico
maximum-displacement-with-the-third-harmonic-also-balanced-by-newton-s-method = Deslocamento máximo com o terceiro harmônico também equilibrado, pelo método de Newton
maximum-displacement-with-the-third-harmonic = Deslocamento máximo com o terceiro harmônico
amplitude-of-the-third-harmonic = Amplitude do terceiro harmônico
three-steady-state-vibrations-are-possible-at-this-frequency-which-of-the-two-stable-ones-occurs = três vibrações em regime permanente são possíveis nesta frequência: qual das duas estáveis ocorre depende de como se chegou a ela
maximum-amplitude-at-any-frequency-where-both-frequencies-of-an-amplitude-meet-ha-k-c-4m-a-f-m-c = Amplitude máxima em qualquer frequência, onde as duas frequências de uma amplitude se encontram: ¾hA⁴ + (k − c²/4m)A² = F²m/c²
its-frequency-close-to-the-backbone-curve = A sua frequência, perto da curva dorsal
the-largest-amplitude-satisfies-the-balance-of-forces = a maior amplitude satisfaz o equilíbrio das forças
frequency-of-maximum-amplitude = Frequência da amplitude máxima
the-response-has-no-maximum-amplitude-at-a-frequency-above-zero-the-softening-spring-loses-its = a resposta não tem amplitude máxima em frequência acima de zero: a mola que amolece perde a força restauradora, ou o amortecimento é forte demais
vertical-tangent-of-the-response-curve-jump-of-the-amplitude = Tangente vertical da curva de resposta: salto da amplitude
frequency-of-a-jump = Frequência de um salto
amplitude-at-which-the-jump-occurs = Amplitude em que ocorre o salto
amplitude-before-the-jump = Amplitude antes do salto
displacement-over-one-period = Deslocamento em um período
cosine-of-the-same-period = cosseno de mesmo período
backbone-frequency-of-the-free-vibration-against-its-amplitude = Curva dorsal: frequência da vibração livre em função da amplitude
harmonic-balance = balanço harmônico
at-this-amplitude = nesta amplitude
below-the-backbone = abaixo da curva dorsal
above-the-backbone = acima da curva dorsal
backbone = curva dorsal
jump = salto
stable = estável
unstable = instável
stability = estabilidade
steady-state-vibrations-at-this-frequency = Vibrações em regime permanente nesta frequência
# vibration/large-pendulum
pendulum-of-large-amplitude = Pêndulo de grande amplitude
exact-period-and-motion-of-a-pendulum-at-any-amplitude-compared-with-the-small-angle-value-and-the = Período e movimento exatos de um pêndulo em qualquer amplitude, comparados com o valor para pequenos ângulos e com a série.
from-the-pivot-to-the-mass-for-a-rigid-body-j-m-s-its-equivalent-length = Da articulação à massa; para um corpo rígido J/(m s), o seu comprimento equivalente.
release-angle = Ângulo de soltura
from-the-lowest-position-at-180-it-would-remain-at-rest = A partir da posição mais baixa; a 180° ficaria em repouso.
instant = Instante
if-given-the-angle-and-the-angular-velocity-at-this-time-after-release-are-also-computed = Se for dado, calculam-se também o ângulo e a velocidade angular neste tempo após a soltura.
angular-frequency-of-small-oscillations = Frequência angular das pequenas oscilações
period-of-small-oscillations-independent-of-the-amplitude = Período das pequenas oscilações, independente da amplitude
modulus-of-the-elliptic-integral-of-the-quarter-period = Módulo da integral elíptica do quarto de período
arithmetic-geometric-mean-of-1-and-cos-2 = Média aritmético-geométrica de 1 e cos(θ₀/2)
period-that-of-small-oscillations-over-the-mean = Período: o das pequenas oscilações dividido pela média
deficit-of-the-small-angle-value = Déficit do valor para pequenos ângulos
first-terms-of-the-series-in-the-amplitude = Primeiros termos da série na amplitude
angular-velocity-at-the-lowest-position-from-l-g-l-1-cos = Velocidade angular na posição mais baixa, de ½ L² Ω² = g L (1 − cos θ₀)
period-by-quadrature-of-dt-d-with-sin-2-sin-and-tan-sinh-u = período pela quadratura de dt = dθ/θ′, com sen(θ/2) = κ sen φ e tg φ = senh u
angular-velocity-at-the-lowest-position-from-the-loss-of-height = velocidade angular na posição mais baixa pela perda de altura
period-of-small-oscillations = Período das pequenas oscilações
deficit-of-the-small-angle-period = Déficit do período para pequenos ângulos
period-by-the-series = Período pela série
largest-angular-velocity = Maior velocidade angular
maximum-angular-velocity = Velocidade angular máxima
sin-2-sn-k-t-with-jacobi-s-function-sn = sen(θ/2) = κ sn(K(κ) + ω₀ t), com a função sn de Jacobi
energy-at-the-instant-is-that-at-the-start = a energia no instante é a do início
elapsed-periods = Períodos decorridos
angle-at-the-instant = Ângulo no instante
angular-velocity-at-the-instant = Velocidade angular no instante
periods-until-the-instant = Períodos até o instante
angle-against-time = Ângulo em função do tempo
as-for-small-angles = como para pequenos ângulos
period-against-amplitude = Período em função da amplitude
small-oscillations = pequenas oscilações
the-oscillation = A oscilação
# vibration/piecewise-spring
piecewise-linear-spring = Mola linear por partes
exact-free-vibration-of-a-mass-on-a-spring-with-a-gap-a-stop-or-a-force-limit-maximum-displacement = Vibração livre exata de uma massa sobre mola com folga, batente ou limite de força: deslocamento máximo e período.
spring-characteristic = Característica da mola
saturating-linear-then-a-constant-force = Com saturação: linear, depois força constante
bilinear-softer-or-stiffer-beyond-the-breakpoint = Bilinear: mais flexível ou mais rígida além do ponto de quebra
gap-no-force-until-contact-with-the-spring = Folga: força nula até o contato com a mola
stiffness-up-to-the-breakpoint = Rigidez até o ponto de quebra
displacement-at-the-breakpoint = Deslocamento no ponto de quebra
stiffness-beyond-the-breakpoint = Rigidez além do ponto de quebra
free-travel-to-each-side = Curso livre para cada lado
stiffness-of-the-spring-beyond-the-gap = Rigidez da mola além da folga
the-mass-starts-at-rest-where-no-force-acts-on-it-give-it-a-displacement-or-a-velocity = a massa parte do repouso onde nenhuma força atua: dê-lhe um deslocamento ou uma velocidade
the-mass-starts-at-rest-inside-the-gap-where-no-force-acts-on-it-give-it-a-velocity-or-a-displacement = a massa parte do repouso dentro da folga, onde nenhuma força atua: dê-lhe uma velocidade, ou um deslocamento além da folga
energy-stored-in-the-spring-at-the-breakpoint = Energia armazenada na mola no ponto de quebra
initial-energy-which-is-conserved = Energia inicial, que se conserva
maximum-displacement-the-corner-is-not-reached-the-vibration-is-that-of-a-linear-spring = Deslocamento máximo: o canto não é alcançado, a vibração é a de uma mola linear
energy-remaining-at-the-breakpoint = Energia restante no ponto de quebra
displacement-beyond-the-breakpoint-that-stores-this-energy = Deslocamento além do ponto de quebra que armazena essa energia
four-quarters-each-with-one-part-up-to-the-breakpoint-and-one-part-beyond-it = Quatro quartos, cada um com um trecho até o ponto de quebra e um trecho além dele
maximum-velocity-at-the-centre-position = Velocidade máxima, na posição central
frequency-at-this-amplitude = Frequência nesta amplitude
energy-stored-at-the-largest-displacement = energia armazenada no maior deslocamento
period-by-quadrature-of-dt-dx-v = período pela quadratura de dt = dx/v
largest-speed = Maior velocidade
maximum-velocity = Velocidade máxima
spring-force-at-that-displacement-from-the-spring-characteristic = Força da mola nesse deslocamento, pela sua característica
maximum-force-of-the-spring = Força máxima da mola
corner = canto
corner-below = canto inferior
frequency-against-amplitude = Frequência em função da amplitude
the-motion-of-the-mass = O movimento da massa
# vibration/rayleigh-damping
rayleigh-damping = Amortecimento de Rayleigh
coefficients-of-proportional-rayleigh-damping-from-the-damping-ratios-of-two-modes-and-the-damping = Coeficientes do amortecimento proporcional (de Rayleigh) a partir dos fatores de amortecimento de dois modos, e o fator de amortecimento em qualquer frequência.
first-mode = Primeiro modo
second-mode = Segundo modo
frequency-at-which-the-damping-ratio-is-requested = Frequência em que se pede o fator de amortecimento
both-modes-have-the-same-frequency-two-different-frequencies-are-needed-to-separate-mass-from = os dois modos têm a mesma frequência: são necessárias duas frequências diferentes para separar massa de rigidez
both-modes-satisfy-2-2-the-coefficient-of-the-mass = Ambos os modos satisfazem ζ = α/(2ω) + βω/2: o coeficiente proporcional à massa
the-stiffness-coefficient = O coeficiente da rigidez
the-coefficients-reproduce-the-damping-ratio-of-the-first-mode = os coeficientes reproduzem o fator de amortecimento do primeiro modo
the-coefficients-reproduce-the-damping-ratio-of-the-second-mode = os coeficientes reproduzem o fator de amortecimento do segundo modo
mass-proportional-damping-coefficient = Coeficiente de amortecimento proporcional à massa
stiffness-proportional-damping-coefficient = Coeficiente de amortecimento proporcional à rigidez
frequency-of-minimum-damping-ratio = Frequência do fator de amortecimento mínimo
the-minimum-damping-ratio-where-both-terms-are-equal = O fator de amortecimento mínimo, onde os dois termos são iguais
minimum-damping-ratio-from-the-sum-of-both-terms = fator de amortecimento mínimo pela soma dos dois termos
the-damping-ratio-is-the-same-an-octave-above-and-an-octave-below-its-minimum = o fator de amortecimento é o mesmo uma oitava acima e uma oitava abaixo do seu mínimo
frequency-of-minimum-damping = Frequência do amortecimento mínimo
damping-ratio-from-the-line-of-2-over-through-both-modes = fator de amortecimento pela reta de 2ζω em função de ω² pelos dois modos
a-coefficient-is-negative-at-very-low-or-very-high-frequencies-the-damping-ratio-would-be-negative = um coeficiente é negativo: em frequências muito baixas ou muito altas o fator de amortecimento seria negativo e tais modos seriam instáveis
damping-ratio-at-the-requested-frequency = Fator de amortecimento na frequência pedida
damping-ratio-at-the-frequency = Fator de amortecimento na frequência
at-the-requested-frequency-the-damping-ratio-is-negative-such-a-mode-is-unstable = na frequência pedida o fator de amortecimento é negativo: tal modo é instável
damping-ratio-against-frequency = Fator de amortecimento em função da frequência
of-the-mass = da massa
of-the-stiffness = da rigidez
# vibration/drop-impact
body-dropped-on-a-spring = Corpo solto sobre uma mola
maximum-deflection-force-and-deceleration-of-a-body-that-falls-on-a-spring-mounted-pan-or-on-a = Deflexão, força e desaceleração máximas de um corpo que cai sobre um prato com mola ou sobre uma embalagem.
falling-body = Corpo em queda
pan = Prato
rests-on-the-spring-the-body-stays-on-it-if-omitted-a-massless-cushion = Repousa sobre a mola, e o corpo fica sobre ele. Se omitido, uma embalagem sem massa.
drop = Queda
from-rest-to-the-pan-or-cushion = Do repouso até o prato ou a embalagem.
speed-at-contact = Velocidade no contato
times-after-the-release = Tempos a partir da soltura
the-distance-fallen-is-computed-at-each-of-them = A distância percorrida é calculada em cada um deles.
free-fall-speed-at-contact = Velocidade de queda livre no contato
free-fall-time = Duração da queda livre
time-of-the-free-fall-from-its-height = duração da queda livre pela sua altura
instant-of-contact = Instante do contato
body-and-pan-move-together = Corpo e prato movem-se juntos
the-body-sticks-to-the-pan-momentum-is-conserved = O corpo fica preso ao prato: a quantidade de movimento se conserva
speed-of-body-and-pan-after-impact = Velocidade do corpo e do prato após o impacto
natural-frequency-on-the-spring = Frequência natural sobre a mola
additional-static-compression-of-the-spring-under-the-weight-of-the-body = Compressão estática adicional da mola sob o peso do corpo
initial-compression-of-the-spring-under-the-weight-of-the-pan = Compressão inicial da mola sob o peso do prato
time-from-contact-to-maximum-deflection-the-first-zero-of-the-velocity = Tempo do contato à deflexão máxima: o primeiro zero da velocidade
maximum-deflection-from-the-static-position-of-pan-or-cushion-a-step-of-the-weight-and-the-velocity = Deflexão máxima a partir da posição estática do prato ou da embalagem: um degrau do peso e a velocidade no contato
maximum-deflection-from-the-static-position-of-the-pan-or-cushion = Deflexão máxima a partir da posição estática do prato ou da embalagem
the-velocity-is-zero-at-the-maximum-deflection = a velocidade é nula na deflexão máxima
maximum-deflection-by-energy-v = deflexão máxima pela energia, δ + √(δ² + (v₀/ωₙ)²)
maximum-deflection-by-the-exact-recurrence = deflexão máxima pela recorrência exata
time-of-maximum-deflection-from-the-release = Instante da deflexão máxima, a partir da soltura
total-displacement-of-the-body-from-release-to-maximum-deflection = Deslocamento total do corpo, da soltura à deflexão máxima
total-displacement-of-the-body = Deslocamento total do corpo
maximum-value-of-y-2-the-force-of-spring-and-damper-over-the-stiffness = Valor máximo de y + 2ζẏ/ωₙ, a força da mola e do amortecedor dividida pela rigidez
maximum-force-of-spring-and-damper-on-the-ground = Força máxima da mola e do amortecedor no solo
maximum-force-on-the-ground = Força máxima no solo
maximum-deceleration-the-force-beyond-the-weight-over-the-mass = Desaceleração máxima: a força além do peso, dividida pela massa
maximum-deceleration-of-the-body = Desaceleração máxima do corpo
energy-lost-in-the-impact = Energia perdida no choque
time-from-contact-until-the-body-leaves-the-pan-the-force-between-them-is-zero = Tempo do contato até o corpo deixar o prato: a força entre eles é nula
the-force-is-zero-then = a força é nula nesse instante
contact-duration = Duração do contato
still-in-free-fall = Ainda em queda livre
displacement-of-the-body-at-time = Deslocamento do corpo no instante
time-since-the-contact = Tempo desde o contato
the-body-has-already-left-the-pan-or-cushion-duration-after-the-contact-choose-an-earlier-time = o corpo já deixou o prato ou a embalagem { $duration } depois do contato: escolha um instante anterior
displacement-of-the-body-the-fall-plus-the-deflection = Deslocamento do corpo: a queda mais a deflexão
deflection-since-the-contact = Deflexão desde o contato
deflection-after-the-contact = Deflexão depois do contato
static-equilibrium-position = posição de equilíbrio estático
the-body-above-its-spring = O corpo acima da sua mola
these-numbers-are-too-large-or-too-small-for-the-motion-to-be-computed-check-their-units = estes números são grandes ou pequenos demais para que o movimento seja calculado: confira as unidades

# vibration/random-chain
chain-of-masses-under-random-base-excitation = Cadeia de massas sob excitação aleatória pela base
root-mean-square-of-displacement-and-acceleration-of-each-mass-of-a-chain-whose-base-moves-with-a = Valor eficaz do deslocamento e da aceleração de cada massa de uma cadeia cuja base se move com uma densidade espectral, com amortecimento modal.
masses-and-springs = Massas e molas
starting-from-the-base = A partir da base.
stiffness-of-its-spring = Rigidez da sua mola
towards-the-previous-mass-or-the-base = Em direção à massa anterior, ou à base.
damping-ratio-of-every-mode = Fator de amortecimento de todos os modos
power-spectral-density-of-the-base-acceleration = Densidade espectral de potência da aceleração da base
a-chain-of-more-than-twelve-masses-is-not-written-out-here-join-some-of-them = uma cadeia de mais de doze massas não é desenvolvida aqui: junte algumas delas
the-modes-of-these-masses-and-springs-were-not-found-check-their-units = os modos destas massas e molas não foram encontrados: confira as unidades
natural-frequency-of-this-mode-an-eigenvalue-of-the-stiffness-and-mass-matrices-of-the-chain = Frequência natural deste modo: um autovalor das matrizes de rigidez e de massa da cadeia
the-base-is-at-rest-when-holzer-s-table-is-evaluated-along-the-chain-at-this-frequency = a base fica em repouso quando a tabela de Holzer é calculada ao longo da cadeia nesta frequência
modal-contribution-to-the-motion-of-this-mass-under-base-excitation-with-m-m = Contribuição do modo ao movimento desta massa sob excitação pela base: Γφ, com Γ = Σmφ/Σmφ²
the-contributions-of-all-modes-to-the-motion-of-a-mass-sum-to-one = as contribuições de todos os modos ao movimento de uma massa somam um
the-same-in-hz = A mesma em Hz
effective-mass-of-the-mode-over-the-whole-mass-how-much-of-it-moves-with-the-base = Massa efetiva do modo dividida pela massa total: quanto dela se move com a base
effective-mass-of-the-mode = Massa efetiva do modo
displacement-of-this-mass-relative-to-the-base-the-frequency-responses-of-all-modes-are-summed = Deslocamento desta massa em relação à base: as respostas em frequência de todos os modos são somadas, elevadas ao quadrado e integradas com a densidade espectral na faixa
acceleration-of-this-mass-relative-to-the-base-by-the-same-integral-with = Aceleração desta massa em relação à base, pela mesma integral com ω⁴
absolute-acceleration-of-this-mass-the-base-acceleration-is-added-before-squaring = Aceleração absoluta desta massa: a aceleração da base é somada antes de elevar ao quadrado
mean-square-by-partial-fractions-mode-by-mode-with-their-cross-terms = média quadrática por frações parciais, modo a modo com os termos cruzados
under-white-noise-base-acceleration-the-relative-acceleration-has-no-finite-mean-square-it-contains = sob aceleração da base com ruído branco, a aceleração relativa não tem média quadrática finita: ela contém a própria aceleração da base
root-mean-square-of-the-relative-displacement-of-mass = Valor eficaz do deslocamento relativo da massa
root-mean-square-of-the-relative-acceleration-of-mass = Valor eficaz da aceleração relativa da massa
root-mean-square-of-the-absolute-acceleration-of-mass = Valor eficaz da aceleração absoluta da massa
power-spectral-density-of-the-absolute-acceleration = Densidade espectral de potência da aceleração absoluta
mass-place = massa { $place }

# vibration/random-response
random-response = Resposta aleatória
the-square-of-the-zero-crossing-rate-is-the-second-spectral-moment-of-the-response-over-that-of-order = o quadrado da taxa de cruzamentos por zero é o segundo momento espectral da resposta sobre o de ordem zero
root-mean-square-of-the-force-k-ic-of-spring-and-damper-on-the-displacement = valor eficaz da força k + icω de mola e amortecedor sobre o deslocamento
force-of-the-spring-over-the-mass-under-white-noise-by-integration-over-all-frequencies = força da mola sobre a massa sob ruído branco, por integração em todas as frequências
root-mean-square-of-displacement-and-acceleration-crossing-rate-and-three-sigma-values-of-one-degree = Valor eficaz do deslocamento e da aceleração, taxa de cruzamentos e valores de três sigmas de um grau de liberdade sob uma densidade espectral.
stationary-gaussian-zero-mean = Estacionária, gaussiana, de média nula.
spectral-density = Densidade espectral
power-spectral-density = Densidade espectral de potência
power-spectral-density-of-the-acceleration = Densidade espectral de potência da aceleração
power-spectral-density-of-the-force = Densidade espectral de potência da força
white-the-same-at-every-frequency = Branca: a mesma em toda frequência
level = Nível
one-sided = Unilateral.
the-density-per-rad-s-1-hz-is-2-rad-s = A densidade por rad/s: 1 Hz são 2π rad/s
level-over-a-band = Nível numa faixa
zero-outside-it = Zero fora dela.
between-the-points = Entre os pontos
straight-lines-in-a-log-log-diagram-as-in-test-specifications = Retas num diagrama log-log, como nas especificações de ensaio
straight-lines = Retas
the-band-ends-before-it-begins-write-its-lower-frequency-first = a faixa termina antes de começar: escreva primeiro a frequência inferior
the-table-of-the-density-needs-at-least-two-points = a tabela da densidade precisa de pelo menos dois pontos
a-log-log-line-cannot-pass-through-zero-write-frequencies-and-densities-above-zero-or-choose-straight = uma reta log-log não pode passar por zero: escreva frequências e densidades acima de zero, ou escolha retas
the-integral-over-the-frequency-was-not-found-the-damping-is-too-small-or-the-numbers-are-too-large = a integral na frequência não foi encontrada: o amortecimento é pequeno demais, ou os números são grandes demais
without-damping-a-random-excitation-makes-the-motion-grow-without-bound-as-t-give-a-damping-ratio = sem amortecimento, uma excitação aleatória faz o movimento crescer sem limite, como √t: dê um fator de amortecimento
the-natural-frequency-is-outside-the-band-of-the-excitation-no-resonance-is-excited = a frequência natural está fora da faixa da excitação: nenhuma ressonância é excitada
root-mean-square-of-the-displacement-relative-to-the-base = Valor eficaz do deslocamento em relação à base
root-mean-square-of-the-velocity-relative-to-the-base = Valor eficaz da velocidade em relação à base
root-mean-square-of-the-absolute-acceleration = Valor eficaz da aceleração absoluta
root-mean-square-of-the-relative-displacement = Valor eficaz do deslocamento relativo
root-mean-square-of-the-relative-velocity = Valor eficaz da velocidade relativa
root-mean-square-of-the-velocity = Valor eficaz da velocidade
root-mean-square-of-the-acceleration = Valor eficaz da aceleração
root-mean-square-of-the-force-of-spring-and-damper-over-the-mass = Valor eficaz da força da mola e do amortecedor, dividida pela massa
root-mean-square-of-the-force-on-the-support = Valor eficaz da força no apoio
power-spectral-density-of-the-acceleration-at-the-natural-frequency = Densidade espectral de potência da aceleração na frequência natural
miles-value-which-treats-the-density-at-the-natural-frequency-as-white-noise-and-neglects-4 = Valor de Miles, que trata a densidade na frequência natural como ruído branco e despreza 4ζ²
error-of-miles-value = Erro do valor de Miles
acceleration-by-miles-formula = Aceleração pela fórmula de Miles
error-of-miles-formula = Erro da fórmula de Miles
three-standard-deviations-reached-or-passed-0-27-of-the-time = Três desvios padrão: alcançados ou ultrapassados em 0,27 % do tempo
n-3-relative-displacement = Deslocamento relativo 3σ
n-3-absolute-acceleration = Aceleração absoluta 3σ
three-sigma-displacement = Deslocamento de três sigmas
n-3-displacement = Deslocamento 3σ
under-a-white-noise-force-the-acceleration-of-the-mass-has-no-finite-mean-square-it-grows-with-the = sob uma força com ruído branco, a aceleração da massa não tem média quadrática finita: ela cresce com a largura da faixa
mean-rate-of-upward-zero-crossings-by-rice-the-apparent-frequency-of-the-motion = Taxa média de cruzamentos ascendentes do zero, por Rice: a frequência aparente do movimento
mean-rate-of-upward-zero-crossings = Taxa média de cruzamentos ascendentes do zero
root-mean-square-by-integration-over-all-frequencies = valor eficaz por integração em todas as frequências
what-the-integral-of-h-s-over-the-frequency-by-adaptive-quadrature = { $what }: a integral de |H|²S na frequência, por quadratura adaptativa
mean-square-by-partial-fractions-over-the-band = média quadrática por frações parciais na faixa
root-mean-square-by-a-rule-of-fixed-panels = valor eficaz por uma regra de painéis fixos
absolute-acceleration-of-the-mass = aceleração absoluta da massa
force-over-mass = força dividida pela massa
force-on-the-support-over-mass = força no apoio dividida pela massa

# vibration/response-spectrum
maximum-deflection-of-each-mode = Deflexão máxima de cada modo
along-the-beam = ao longo da viga
count-half-waves = { $count } meias ondas
maximum-displacement-of-each-mode = Deslocamento máximo de cada modo
maximum-displacement-of-the-last-mass-in-each-mode = Deslocamento máximo da última massa em cada modo
response-spectrum-analysis = Análise por espectro de resposta
maximum-displacement-acceleration-or-stress-of-a-chain-of-given-modes-or-of-a-beam-under-base = Deslocamento, aceleração ou tensão máximos de uma cadeia, de modos dados ou de uma viga sob excitação pela base, por ABS, SRSS e CQC.
structure = Estrutura
required-only-for-the-complete-quadratic-combination-the-spectrum-is-that-of-this-damping = Necessária só para a combinação quadrática completa; o espectro é o deste amortecimento.
response-spectrum-of-the-motion-of-the-base = Espectro de resposta do movimento da base
chain-of-masses = Cadeia de massas
modes-given = Modos dados
simply-supported-beam-both-supports-with-the-same-motion = Viga biapoiada, com o mesmo movimento nos dois apoios
from-the-neutral-axis = A partir da linha neutra.
number-of-modes = Número de modos
only-the-symmetric-ones-1-3-5-respond-when-both-supports-have-the-same-motion = Só os simétricos, 1, 3, 5 …, respondem quando os dois apoios têm o mesmo movimento.
modal-contribution-at-the-observation-point = Contribuição do modo no ponto observado
participation-factor-times-mode-shape-the-shares-of-all-modes-make-one = Fator de participação vezes a forma modal, Γφ: as parcelas de todos os modos somam um.
the-same-displacement-at-every-frequency = O mesmo deslocamento em toda frequência
spectral-displacement = Deslocamento espectral
the-same-pseudo-velocity-at-every-frequency = A mesma pseudovelocidade em toda frequência
spectral-pseudo-velocity = Pseudovelocidade espectral
the-same-pseudo-acceleration-at-every-frequency = A mesma pseudoaceleração em toda frequência
spectral-pseudo-acceleration = Pseudoaceleração espectral
table-of-pseudo-acceleration = Tabela de pseudoaceleração
spectral-displacement-of-this-mode-from-the-pseudo-velocity = Deslocamento espectral deste modo, pela pseudovelocidade
spectral-displacement-of-this-mode-from-the-pseudo-acceleration = Deslocamento espectral deste modo, pela pseudoaceleração
the-table-of-the-spectrum-does-not-reach-frequency-add-points-for-every-mode = a tabela do espectro não alcança { $frequency }: acrescente pontos para todos os modos
the-table-of-the-spectrum-needs-at-least-two-points-with-frequencies-that-ascend-and-values-above = a tabela do espectro precisa de pelo menos dois pontos, com frequências crescentes e valores acima de zero
maximum-displacement-of-this-mass-in-this-mode-s-d = Deslocamento máximo desta massa neste modo, Γφ S_d
maximum-displacement-of-the-point-in-this-mode-s-d = Deslocamento máximo do ponto neste modo, Γφ S_d
displacement-sum-of-absolute-values-mass = Deslocamento, soma dos valores absolutos, massa
displacement-root-of-the-sum-of-squares-mass = Deslocamento, raiz da soma dos quadrados, massa
displacement-complete-quadratic-combination-mass = Deslocamento, combinação quadrática completa, massa
displacement-sum-of-absolute-values = Deslocamento, soma dos valores absolutos
displacement-root-of-the-sum-of-squares = Deslocamento, raiz da soma dos quadrados
displacement-complete-quadratic-combination = Deslocamento, combinação quadrática completa
effective-mass-of-this-mode-m = Massa efetiva deste modo, Γ²Σmφ²
maximum-force-on-the-base-in-this-mode-its-effective-mass-times-its-pseudo-acceleration = Força máxima na base neste modo: a sua massa efetiva vezes a sua pseudoaceleração
force-on-the-base-sum-of-absolute-values = Força na base, soma dos valores absolutos
force-on-the-base-root-of-the-sum-of-squares = Força na base, raiz da soma dos quadrados
force-on-the-base-complete-quadratic-combination = Força na base, combinação quadrática completa
force-on-the-base-of-a-mode-as-the-force-of-the-first-spring = força na base de um modo, como a força da primeira mola
the-contributions-of-the-modes-sum-to-total-not-to-one-modes-are-missing-or-and-do-not-correspond = as contribuições dos modos somam { $total }, e não um: faltam modos, ou Γ e φ não se correspondem
half-waves-over-the-span-as-an-angle-per-unit-length = Meias ondas no vão, como ângulo por unidade de comprimento
natural-frequency-of-the-mode-with-this-number-of-half-waves = Frequência natural do modo com este número de meias ondas
modal-contribution-to-the-midspan-motion-when-both-supports-move-4-l-with-the-sign-of-sin-l-2 = Contribuição do modo ao movimento do meio do vão quando os dois apoios se movem: 4/(βL), com o sinal de sen(βL/2)
modal-participation-factor-by-quadrature-of-the-mode-shape-dx-dx = fator de participação modal por quadratura da forma modal, Γ = ∫φ dx/∫φ² dx
maximum-deflection-of-the-middle-in-this-mode-s-d = Deflexão máxima do meio neste modo, Γφ S_d
bending-stress-at-midspan-in-this-mode-e-c-times-the-curvature-y = Tensão de flexão no meio do vão neste modo: E c vezes a curvatura β²y
midspan-deflection-sum-of-absolute-values = Deflexão no meio do vão, soma dos valores absolutos
midspan-deflection-root-of-the-sum-of-squares = Deflexão no meio do vão, raiz da soma dos quadrados
midspan-deflection-complete-quadratic-combination = Deflexão no meio do vão, combinação quadrática completa
bending-stress-sum-of-absolute-values = Tensão de flexão, soma dos valores absolutos
bending-stress-root-of-the-sum-of-squares = Tensão de flexão, raiz da soma dos quadrados
bending-stress-complete-quadratic-combination = Tensão de flexão, combinação quadrática completa
correlation-of-the-modes = Correlação dos modos
mode-place = modo { $place }
ratio-of-the-two-natural-frequencies = Razão entre as duas frequências naturais
correlation-of-the-two-modes = Correlação dos dois modos
correlation-of-the-two-modes-under-white-noise-by-partial-fractions = correlação dos dois modos sob ruído branco, por frações parciais
absolute-sum-all-modes-at-their-maximum-at-the-same-time-an-upper-bound = Soma dos valores absolutos: todos os modos no seu máximo ao mesmo tempo, um limite superior
square-root-of-the-sum-of-squares-srss-well-separated-modes = Raiz da soma dos quadrados (SRSS): modos bem separados
complete-quadratic-combination-with-the-correlation-of-closely-spaced-modes-and-the-signs = Combinação quadrática completa: com a correlação dos modos próximos e os sinais

# vibration/shock-response-spectrum
shock-response-spectrum = Espectro de resposta ao choque
the-slope-of-the-spectrum-is-zero-at-its-maximum-ordinate = a inclinação do espectro é zero na sua ordenada máxima
residual-by-duhamel-s-integral-up-to-its-instant = residual, pela integral de Duhamel até o seu instante
primary-by-duhamel-s-integral-up-to-its-instant = primário, pela integral de Duhamel até o seu instante
maximum-ordinate-by-duhamel-s-integral-up-to-its-instant = ordenada máxima, pela integral de Duhamel até o seu instante
maximum-amplification-by-duhamel-s-integral = amplificação máxima, pela integral de Duhamel
velocity-change-integral-of-the-acceleration-piece-by-piece-by-quadrature = variação da velocidade: integral da aceleração trecho a trecho, por quadratura
amplification-by-the-integrals-over-unit-impulses = amplificação, pelas integrais sobre impulsos unitários
primary-residual-and-maximax-spectrum-of-a-pulse-or-a-recorded-shock-at-given-frequencies-and-over-a = Espectros primário, residual e maximax de um pulso ou de um choque registrado, em frequências dadas e numa faixa.
base-shock = Choque na base
damping-ratio-of-the-oscillators = Fator de amortecimento dos osciladores
n-0-05-q-10-unless-stated-otherwise = 0,05, Q = 10, salvo indicação em contrário.
quantity-plotted = Grandeza no gráfico
absolute-acceleration = Aceleração absoluta
pseudo-acceleration-relative-displacement-times = Pseudoaceleração: deslocamento relativo vezes ωₙ²
lowest-frequency = Frequência mínima
highest-frequency = Frequência máxima
the-spectrum-is-computed-at-each-of-them = O espectro é calculado em cada uma delas.
pulse = Pulso
form = Forma
half-sine = Meia-onda senoidal
triangle = Triângulo
at-the-middle-if-omitted-the-duration-for-a-terminal-peak-sawtooth = No meio, se omitido; a duração para um dente de serra de pico final.
the-lowest-frequency-is-not-below-the-highest-write-a-range = a menor frequência não está abaixo da maior: escreva uma faixa
velocity-change = Variação da velocidade
velocity-change-area-of-the-half-sine-pulse = Variação da velocidade: área do pulso de meia-onda senoidal
velocity-change-area-of-the-rectangular-pulse = Variação da velocidade: área do pulso retangular
velocity-change-area-of-the-triangular-pulse = Variação da velocidade: área do pulso triangular
all-accelerations-in-the-table-are-zero-there-is-no-shock = todas as acelerações da tabela são nulas: não há choque
maximum-response-during-the-shock-the-motion-is-exact-over-each-piece-of-the-shock-its-peaks-are = Resposta máxima durante o choque: o movimento é exato em cada trecho do choque, e os picos estão onde a sua taxa se anula
maximum-response-after-the-shock-from-the-free-motion-starting-at-its-end = Resposta máxima depois do choque, pelo movimento livre a partir do seu fim
the-maximax-is-the-larger-one-the-primary = O maximax é o maior dos dois: o primário
the-maximax-is-the-larger-one-the-residual = O maximax é o maior dos dois: o residual
primary-at-frequency = Primário na frequência
residual-at-frequency = Residual na frequência
maximax-at-frequency = Maximax na frequência
amplification-at-frequency = Amplificação na frequência
relative-displacement-by-duhamel-s-integral = deslocamento relativo pela integral de Duhamel
duration-over-the-natural-period = Duração dividida pelo período natural
amplification-the-spectrum-over-the-maximum-base-acceleration = Amplificação: o espectro sobre a aceleração máxima da base
primary-without-damping-from-its-closed-form = primário sem amortecimento, pela sua forma fechada
residual-without-damping-from-its-closed-form = residual sem amortecimento, pela sua forma fechada
maximum-ordinate-of-the-spectrum-over-the-range-where-its-slope-is-zero = Ordenada máxima do espectro na faixa, onde a sua inclinação se anula
maximum-ordinate-of-the-spectrum-among-the-plotted-frequencies = Ordenada máxima do espectro entre as frequências traçadas
maximum-ordinate-over-the-range = Ordenada máxima na faixa
maximum-amplification-over-the-range = Amplificação máxima na faixa
its-natural-frequency = A sua frequência natural
natural-frequency-of-the-maximum-ordinate = Frequência natural da ordenada máxima
duration-over-the-natural-period-at-the-maximum-ordinate = Duração dividida pelo período natural, na ordenada máxima
duration-over-the-natural-period-there = Duração dividida pelo período natural nesse ponto
the-spectrum-is-lower-on-both-sides-of-its-maximum-ordinate = o espectro é mais baixo dos dois lados da sua ordenada máxima
the-maximum-ordinate-is-at-an-end-of-the-range-the-spectrum-may-be-higher-beyond-it = a ordenada máxima está num extremo da faixa: além dele o espectro pode ser maior
maximax = maximax
primary = primário
shock-response-spectrum-in-numbers = Espectro de resposta ao choque em números

# vibration/transient-response
a-loss-factor-describes-steady-state-vibration-at-one-frequency-not-a-transient-or-random-motion-give = um fator de perda descreve a vibração em regime permanente numa frequência, não um movimento transitório ou aleatório: dê o fator de amortecimento, que para amortecimento fraco é metade do fator de perda
transient-response = Resposta transitória
overshoot-of-a-step-response-amplitude-ratio-after-half-a-cycle-of-free-vibration-e-1 = sobressinal da resposta ao degrau: razão de amplitudes após meio ciclo de vibração livre, e^(−πζ/√(1 − ζ²))
maximum-force-on-the-support-by-duhamel-s-integral-up-to-its-instant = força máxima no apoio, pela integral de Duhamel até o seu instante
maximum-acceleration-by-duhamel-s-integral-up-to-its-instant = aceleração máxima, pela integral de Duhamel até o seu instante
displacement-time-history-its-maximum-and-the-residual-response-of-one-degree-of-freedom-under-a-step = Evolução do deslocamento no tempo, o seu máximo e a resposta residual, de um grau de liberdade sob um degrau, rampa, pulso, tabela, impulso ou aceleração da base.
natural-frequency-given = Frequência natural dada
natural-period = Período natural
frequency-of-the-damped-motion = Frequência do movimento amortecido
slower-rate-of-decay-of-the-overdamped-motion = Taxa de decaimento mais lenta do movimento superamortecido
faster-decay-rate = Taxa de decaimento mais rápida
from-rest-unless-an-initial-motion-is-specified = A partir do repouso, a não ser que se informe um movimento inicial.
the-displacement-is-computed-at-each-of-them = O deslocamento é calculado em cada um deles.
distance-of-the-extreme-fibre = Distância da fibra extrema
from-the-neutral-axis-if-the-spring-is-a-beam-its-maximum-bending-stress-is-also-computed = A partir da linha neutra. Quando a mola é uma viga, a sua tensão máxima de flexão também é calculada.
size = Tamanho
magnitude = Intensidade
force-on-the-mass-from-a-table = Força sobre a massa por uma tabela
a-firing-order-contains-each-cylinder-once = Uma ordem de ignição contém cada cilindro uma vez
linear-between-the-points-zero-before-the-first-and-after-the-last = Linear entre os pontos, zero antes do primeiro e depois do último.
increasing-times-two-points-at-the-same-time-define-a-step = Tempos crescentes; dois pontos no mesmo tempo definem um degrau.
impulse-on-the-mass = Impulso sobre a massa
impulse = Impulso
the-displacement-is-that-relative-to-the-base = O deslocamento é o relativo à base.
acceleration-of-the-base-by-a-table = Aceleração da base por uma tabela
initial-motion = Movimento inicial
initial-displacement = Deslocamento inicial
initial-velocity = Velocidade inicial
maximum-force-given = Força máxima dada
largest-force = Força máxima
maximum-force = Força máxima
impulse-of-the-whole-pulse-given = Impulso do pulso inteiro dado
the-area-under-the-force = A área sob a força.
step = Degrau
applied-suddenly-and-held-constant = Aplicado subitamente e mantido constante.
ramp-then-constant = Rampa, depois constante
rises-linearly-and-then-stays-constant = Cresce linearmente e depois se mantém constante.
rise-time = Tempo de subida
ramp-without-end = Rampa sem fim
rises-linearly-without-end = Cresce linearmente sem limite.
rise-time-to-the-full-value = Tempo de subida até o valor final
exponential = Exponencial
applied-suddenly-it-decays-as-e-t = Aplicada subitamente, decai como e^(−t/τ).
time-constant = Constante de tempo
duration = Duração
triangular-pulse = Pulso triangular
time-of-the-peak = Instante do pico
at-the-middle-if-omitted-0-for-a-blast-the-duration-for-a-sawtooth = No meio, se omitido; 0 para uma explosão, a duração para um dente de serra.
half-sine-pulse = Pulso de meia-onda senoidal
the-peak-of-the-triangle-comes-after-its-end-write-a-time-of-the-peak-up-to-the-duration = o pico do triângulo vem depois do seu fim: escreva um instante do pico até a duração
the-times-of-the-table-must-begin-at-zero-or-later-and-ascend-sort-its-rows = os tempos da tabela devem começar em zero ou depois e ser crescentes: ordene as suas linhas
the-table-has-fewer-than-two-points-write-at-least-its-start-and-its-end = a tabela tem menos de dois pontos: escreva ao menos o seu começo e o seu fim
natural-period-without-damping = Período natural, sem amortecimento
static-displacement = Deslocamento estático
displacement-at-time = Deslocamento no instante
the-load-rises-without-end-and-the-motion-with-it-there-is-no-largest-displacement = a carga cresce sem fim, e o movimento com ela: não há deslocamento máximo
time-of-maximum-displacement-the-first-zero-of-the-velocity-at-which-it-is-reached = Instante do deslocamento máximo: o primeiro zero da velocidade em que ele é alcançado
the-velocity-is-zero-at-the-maximum-displacement = a velocidade é nula no deslocamento máximo
maximum-displacement-over-the-static-one-the-dynamic-load-factor = Deslocamento máximo dividido pelo estático: o fator de carga dinâmica
dynamic-load-factor = Fator de carga dinâmica
excess-of-the-maximum-displacement-over-the-final-value = Excesso do deslocamento máximo sobre o valor final
maximum-displacement-after-the-load-from-the-free-motion-starting-at-its-end = Deslocamento máximo depois da carga, pelo movimento livre a partir do seu fim
without-damping-the-residual-amplitude-is-that-of-the-state-at-the-end-of-the-load = sem amortecimento, a amplitude residual é a do estado no fim da carga
maximum-displacement-after-the-load = Deslocamento máximo depois da carga
dynamic-load-factor-of-a-step-from-its-closed-form-1-e-1 = fator de carga dinâmica de um degrau pela sua forma fechada, 1 + e^(−πζ/√(1 − ζ²))
dynamic-load-factor-of-the-ramp-from-its-closed-form-1-sin-t-r-t-t-r-t = fator de carga dinâmica da rampa pela sua forma fechada, 1 + |sin(πt_r/T)|/(πt_r/T)
its-rate-is-zero-at-that-time = a sua taxa se anula nesse instante
maximum-acceleration-of-the-mass-itself-2-z-where-its-rate-is-zero = Aceleração máxima da própria massa, −2ζωₙż − ωₙ²z, onde a sua taxa se anula
maximum-absolute-acceleration = Aceleração absoluta máxima
maximum-force-of-spring-and-damper-on-the-support-kx-c-where-its-rate-is-zero = Força máxima da mola e do amortecedor no apoio, kx + cẋ, onde a sua taxa se anula
maximum-force-on-the-support = Força máxima no apoio
relative-displacement = deslocamento relativo
static-displacement-under-the-load = deslocamento estático sob a carga
displacement-time-history = Evolução do deslocamento no tempo
a-force-moves-a-mass-give-the-mass-in-addition-to-the-natural-frequency = uma força move uma massa: dê a massa além da frequência natural
static-displacement-under-the-maximum-force = Deslocamento estático sob a força máxima
the-mass-relative-to-the-base-moves-as-under-the-force-m-static-displacement-under-its-maximum-value = O movimento da massa relativo à base é o causado pela força −m ÿ: deslocamento estático sob o seu valor máximo
the-impulse-instantaneously-gives-the-mass-its-momentum = O impulso dá instantaneamente à massa a sua quantidade de movimento
without-an-initial-displacement-or-velocity-nothing-moves-write-at-least-one-of-them = sem deslocamento nem velocidade iniciais nada se move: escreva ao menos um deles
the-peak-is-at-the-middle-of-the-pulse = O pico está no meio do pulso
frequency-of-the-sine-of-which-the-pulse-is-one-half-wave = Frequência do seno do qual o pulso é meia onda
frequency-ratio-of-that-sine = Razão de frequências desse seno
displacement-by-the-exact-recurrence-over-the-segments-of-the-load-each-linear-or-sinusoidal = Deslocamento pela recorrência exata nos trechos da carga, cada um linear ou senoidal
displacement-sum-of-the-responses-to-the-steps-ramps-or-waves-that-make-up-the-load = Deslocamento: a soma das respostas aos degraus, rampas ou ondas que compõem a carga
displacement-of-the-free-motion = Deslocamento da vibração livre
displacement-by-the-exact-recurrence-over-the-pieces-of-the-load = deslocamento pela recorrência exata nos trechos da carga
displacement-by-duhamel-s-integral-evaluated-numerically = deslocamento pela integral de Duhamel, avaliada numericamente
time-since-this-part-of-the-load-began = Tempo desde que essa parte da carga começou
free-vibration-from-a-unit-displacement-after-that-time = Vibração livre a partir de um deslocamento unitário, depois desse tempo
free-vibration-from-a-unit-velocity-after-that-time = Vibração livre a partir de uma velocidade unitária, depois desse tempo
equivalent-static-force-for-the-same-deflection-of-the-beam = Força estática equivalente para a mesma deflexão da viga
bending-moment-at-the-clamp = Momento fletor no engaste
bending-moment-at-midspan-under-the-mass = Momento fletor no meio do vão, sob a massa
bending-moment-under-the-mass = Momento fletor sob a massa
bending-moment-at-midspan-and-at-the-clamps = Momento fletor no meio do vão e nos engastes
bending-stress-at-the-extreme-fibre = Tensão de flexão na fibra extrema
bending-stress-by-the-curvature-of-the-bent-beam-e-c-w = tensão de flexão pela curvatura da viga fletida, E c w″
the-bending-stress-is-available-for-a-cantilever-a-simply-supported-beam-and-a-clamped-beam-with-the = a tensão de flexão está disponível para uma viga em balanço, uma biapoiada e uma biengastada com a massa no meio: omita a distância da fibra extrema para outras molas
# continuous
area-and-second-moment-given = Área e momento de inércia dados
axial-force = Força axial
bending-stiffness = Rigidez à flexão
clamped = Engastada
density-given = Massa específica dada
fixed = Fixa
free = Livre
frequency-equation = Equação de frequências
frequency-function = função de frequência
from-young-s-modulus-and-poisson-s-ratio = Pelo módulo de elasticidade e pelo coeficiente de Poisson
in-cycles-per-second = Em ciclos por segundo
left-end = Extremidade esquerda
mass-per-unit-length = Massa por unidade de comprimento
mass-per-unit-length-given = Massa por unidade de comprimento dada
mass-per-unit-length-density-times-area = Massa por unidade de comprimento: massa específica vezes área
mass-per-unit-length-weight-over-gravity = Massa por unidade de comprimento: peso sobre gravidade
mode-shapes = Modos de vibração
mode-shapes-in-motion = Modos de vibração em movimento
at-rest = em repouso
deflection-maximum-deflection = deflexão / deflexão máxima
distance-from-the-left-end = Distância da extremidade esquerda
natural-frequency-n = Frequência natural { $n }
nodes-of-mode = Nós do modo
number-of-frequencies = Número de frequências
pinned = Apoiada
poisson-s-ratio = Coeficiente de Poisson
ratio-of-the-diameters = Razão entre os diâmetros
right-end = Extremidade direita
roots = raízes
shear-coefficient = Coeficiente de cisalhamento
shear-coefficient-given = Coeficiente de cisalhamento dado
shear-coefficient-of-the-section = Coeficiente de cisalhamento da seção
shear-modulus-given = Módulo de elasticidade transversal dado
shear-modulus-of-an-isotropic-material = Módulo de elasticidade transversal de um material isotrópico
mode-shapes-n-and-m-are-orthogonal = as formas modais { $n } e { $m } são ortogonais
weight-per-unit-length = Peso por unidade de comprimento
weight-per-unit-length-given = Peso por unidade de comprimento dado
zero = zero
wave-speed-along-a-rod = Velocidade de onda ao longo de uma barra
the-beam-can-move-as-a-rigid-body-n-such-motions-at-frequency-zero-precede-the-first-frequency-and = a viga pode mover-se como corpo rígido: { $n } desses movimentos, com frequência nula, vêm antes da primeira frequência, e alguns livros os contam

# beam-vibration
axial-force-over-ei-l = Força axial sobre EI/L²
bending-alone-euler-bernoulli = Só flexão (Euler–Bernoulli)
bending-vibration-of-beams = Vibração de flexão de vigas
bending-shear-and-rotary-inertia-timoshenko = Flexão, cisalhamento e inércia de rotação (Timoshenko)
buckling-load = Carga de flambagem
compression-over-the-buckling-load = Compressão sobre a carga de flambagem
compression-over-ei-l-at-which-the-lowest-frequency-becomes-zero-the-beam-buckles = Compressão, sobre EI/L², em que a menor frequência se anula: a viga flamba
cowper-s-shear-coefficient-requires-the-shape-of-the-section-enter-the-coefficient-or-choose-a = o coeficiente de cisalhamento de Cowper requer a forma da seção: informe o coeficiente ou escolha uma seção pela forma
cowper-s-for-the-section = O de Cowper, para a seção
elastic-foundation = Fundação elástica
shear-flexibility-of-the-beam-over-its-bending-flexibility = Flexibilidade da viga ao cisalhamento sobre a flexibilidade à flexão
ground-reaction-per-unit-length-of-the-beam-and-unit-deflection = Reação do solo por unidade de comprimento da viga e por unidade de deflexão.
foundation-over-ei-l = Fundação sobre EI/L⁴
frequencies-mode-shapes-nodes-and-buckling-load-of-a-uniform-beam-euler-bernoulli-or-timoshenko-on = Frequências, formas modais, nós e carga de flambagem de uma viga uniforme (Euler–Bernoulli ou Timoshenko) com quaisquer apoios, com massas, molas, força axial e fundação elástica.
guided-deflects-without-rotating = Guiada: desloca-se sem girar
mass-of-the-beam = Massa da viga
masses-springs-and-supports-along-the-beam = Massas, molas e apoios ao longo da viga
moment-of-inertia-about-its-centre = Momento de inércia em relação ao seu centro
rigid-body-motions-of-an-unsupported-beam-are-not-included = Não se incluem os movimentos de corpo rígido de uma viga sem apoios.
root-of-cos-0 = Raiz de cos β = 0
root-of-cos-cosh-1-the-equation-of-identical-ends = Raiz de cos β cosh β = 1, a equação das extremidades iguais
root-of-cos-cosh-1-the-equation-of-a-cantilever = Raiz de cos β cosh β = −1, a equação da viga em balanço
root-of-sin-0 = Raiz de sen β = 0
root-of-tan-tanh-the-equation-of-a-pinned-end = Raiz de tan β = tanh β, a equação da extremidade apoiada
root-of-tan-tanh-the-equation-of-a-guided-end = Raiz de tan β = −tanh β, a equação da extremidade guiada
root-of-the-determinant-of-the-exact-dynamic-stiffness-with-the-frequencies-below-it-counted = Raiz do determinante da rigidez dinâmica exata, contadas as frequências abaixo dela
root-with-ei-m-l = Raiz β com ω = β²√(EI/(m̄L⁴))
with-ei-m-l = β, com ω = β²√(EI/(m̄L⁴))
rotary-inertia-of-the-sections-over-m-l = Inércia de rotação das seções sobre m̄L²
rotational-spring-to-the-ground = Mola rotacional ligada à base
rotational-stiffness = Rigidez rotacional
support-that-allows-rotation-of-the-beam = Apoio que permite a rotação da viga
tension-is-positive-compression-negative = Tração é positiva, compressão negativa.
the-frequencies-are-multiples-of-ei-m-l = As frequências são múltiplos de √(EI/(m̄L⁴))
theory = Teoria
attached-part = Peça acoplada
root-n-by-the-closed-form-of-a-beam-pinned-at-both-ends = raiz { $n } pela fórmula fechada de uma viga biapoiada
root-n-satisfies-the-frequency-equation = a raiz { $n } satisfaz a equação de frequências
an-item-lies-beyond-the-right-end-of-the-beam-write-a-distance-not-greater-than-its-length = um item está além da extremidade direita da viga: escreva uma distância não maior que o seu comprimento
the-beam-buckles-under-its-compression-write-a-smaller-one = a viga flamba sob a sua compressão: escreva uma menor
the-beam-buckles-under-this-compression-write-one-below-load = a viga flamba sob essa compressão: escreva uma abaixo de { $load }
the-beam-can-move-as-a-rigid-body-and-cannot-carry-compression-add-supports = a viga pode mover-se como corpo rígido e não suporta compressão: acrescente apoios
the-length-of-the-beam-is-less-than-ten-times-its-depth-shear-and-rotary-inertia-lower-its = o comprimento da viga é menor que dez vezes a sua altura: o cisalhamento e a inércia de rotação baixam as suas frequências; escolha a teoria de Timoshenko
the-beam-is-so-slender-so-highly-tensioned-or-so-heavily-loaded-that-its-bending-cannot-be-resolved = a viga é tão esbelta, tão tracionada ou tão carregada que a sua flexão não se distingue: trate-a como corda ou como corpo rígido
the-frequencies-cannot-be-found-masses-springs-and-forces-differ-too-much-from-those-of-the-beam = as frequências não podem ser encontradas: massas, molas e forças diferem demais das da viga

# rod-impact
along-its-axis-against-the-wall = Ao longo do seu eixo, contra a parede.
compressive-stress = Tensão de compressão
force-on-the-wall = Força na parede
force-on-the-wall-during-the-contact = Força na parede durante o contato
in-a-time-dt-the-wave-front-brings-a-length-c-dt-to-rest-which-shortens-by-v-dt = Num tempo dt a frente de onda leva ao repouso um comprimento c dt, que encurta v dt
maximum-compressive-stress = Tensão de compressão máxima
maximum-shortening = Encurtamento máximo
strength-of-the-material = Resistência do material
maximum-stress-maximum-shortening-and-contact-time-of-a-rod-that-strikes-a-rigid-wall-end-on-by-wave = Tensão máxima, encurtamento máximo e tempo de contato de uma barra que bate com a ponta numa parede rígida, por propagação de ondas.
rod-striking-a-wall = Barra que bate numa parede
shortening-of-the-rod = Encurtamento da barra
speed-at-which-the-stress-reaches-the-strength-of-the-material = Velocidade em que a tensão atinge a resistência do material
speed-of-the-rod = Velocidade da barra
stress-behind-the-wavefront-the-maximum-in-the-rod = Tensão atrás da frente de onda: a máxima na barra
the-wavefront-reaches-the-free-end-the-whole-rod-is-at-rest = A frente de onda chega à extremidade livre: toda a barra está em repouso
the-compressed-part-of-the-rod = A parte comprimida da barra
the-reflected-wave-unloads-the-rod-it-leaves-the-wall = A onda refletida descarrega a barra: ela deixa a parede
time-to-maximum-shortening = Tempo até o encurtamento máximo
until-then-the-free-end-has-continued-at-its-speed = Até então a extremidade livre continuou com a sua velocidade
wave-speed = Velocidade das ondas
if-given-the-force-on-the-wall-is-also-computed = Se for dada, a força na parede também é calculada.
if-given-the-speed-that-reaches-it-is-also-computed = Se for dada, a velocidade que a atinge também é calculada.
at-the-middle = no meio
at-the-wall = na parede
shortening = encurtamento
initial-kinetic-energy-equals-the-strain-energy-of-the-shortened-rod-per-unit-volume = a energia cinética inicial é igual à energia de deformação da barra encurtada, por unidade de volume
the-momentum-per-unit-area-is-reversed-by-the-stress-at-the-wall-during-contact = a quantidade de movimento por unidade de área é invertida pela tensão na parede durante o contato
the-rod-is-as-fast-as-the-waves-in-it-or-faster-no-elastic-wave-can-stop-it-write-a-smaller-speed = a barra é tão rápida quanto as suas ondas, ou mais: nenhuma onda elástica pode pará-la; escreva uma velocidade menor
the-rod-yields-the-elastic-stress-would-exceed-the-yield-strength-of-the-material = a barra escoa: a tensão elástica ultrapassaria a tensão de escoamento do material
the-strain-exceeds-2-this-is-beyond-small-deformations-and-the-range-of-most-materials = a deformação passa de 2 %: isso está além das pequenas deformações e do alcance da maioria dos materiais

# rod-under-sudden-force
after-the-wavefront-has-passed-the-place-moves-faster-by-v = Depois da passagem da frente de onda, a posição move-se mais rápido em v
compressive-stress-behind-the-wavefront-the-maximum-in-the-rod = Tensão de compressão atrás da frente de onda: a máxima na barra
constant-from-the-start-it-pushes-one-end-along-the-axis-of-the-rod-which-nothing-else-holds = Constante desde o início; empurra uma extremidade ao longo do eixo da barra, que nada mais segura.
displacement-along-the-rod = Deslocamento ao longo da barra
displacement-at-that-place-and-time = Deslocamento nessa posição e nesse instante
displacement-of-a-free-rod-that-a-constant-force-suddenly-pushes-at-one-end-by-wave-propagation = Deslocamento de uma barra livre que uma força constante empurra subitamente numa extremidade, por propagação de ondas: velocidade da extremidade carregada, retorno da onda, tensão, movimento de corpo rígido.
displacement-of-the-centre-of-mass = Deslocamento do centro de massa
displacement-of-the-whole-rod-at-the-velocities-that-the-round-trips-have-left-it = Deslocamento de toda a barra às velocidades que as idas e voltas lhe deixaram
distance-from-the-loaded-end = Distância a partir da extremidade carregada.
free-rod-under-a-sudden-force = Barra livre sob uma força súbita
in-a-time-dt-the-wavefront-strains-a-length-c-dt-by-e-velocity-of-the-part-behind-it = Num tempo dt a frente de onda deforma de σ/E um comprimento c dt: velocidade da parte atrás dela
mass-of-the-rod = Massa da barra
place-at-which-the-motion-is-required = Posição em que o movimento é pedido
rigid-body-motion-displacement-of-the-centre-of-mass = Movimento de corpo rígido: deslocamento do centro de massa
round-trips-of-the-wave-before-that-time-each-leaves-the-rod-without-stress-and-faster-by-2v = Idas e voltas da onda antes desse instante: cada uma deixa a barra sem tensão e mais rápida em 2v
the-free-rod-and-the-force-on-its-end = A barra livre e a força na sua extremidade
the-next-wavefront-has-not-reached-the-place = A frente de onda seguinte não chegou à posição
the-reflected-wave-has-passed-too-faster-by-v-once-more = A onda refletida também passou: mais rápido em v outra vez
the-wave-reflected-as-tension-is-back-at-the-loaded-end-the-rod-is-without-stress-and-moves-at-2v = A onda, refletida como tração, está de volta à extremidade carregada: a barra está sem tensão e move-se a 2v
the-wavefront-has-not-reached-the-place-it-is-at-rest = A frente de onda não chegou à posição: ela está em repouso
the-wavefront-reaches-the-free-end = A frente de onda chega à extremidade livre
time-for-the-wave-to-reach-the-free-end = Tempo da onda até a extremidade livre
time-since-the-last-of-them = Tempo desde a última delas
time-until-the-wave-returns = Tempo até o retorno da onda
velocity-of-the-loaded-end-until-the-wave-returns = Velocidade da extremidade carregada até o retorno da onda
at-that-place-and-time = nessa posição e nesse instante
centre-of-mass = centro de massa
displacement-from-the-rigid-body-motion-and-the-sum-of-the-free-free-modes = deslocamento pelo movimento de corpo rígido e pela soma dos modos livre-livre
displacement-of-the-centre-of-mass-mean-of-the-displacements-over-the-length = deslocamento do centro de massa: média dos deslocamentos ao longo do comprimento
free-end = extremidade livre
impulse-of-the-force-until-the-wave-is-back-momentum-of-the-rod-all-of-it-at-2v = impulso da força até o retorno da onda = quantidade de movimento da barra, toda a 2v
impulse-of-the-force-until-the-wavefront-reaches-the-free-end-momentum-of-the-rod-all-of-it-at-v = impulso da força até a frente de onda chegar à extremidade livre = quantidade de movimento da barra, toda a v
loaded-end = extremidade carregada
stress-behind-a-wavefront-from-the-velocity-c-v = tensão atrás de uma frente de onda pela velocidade, ρ c v
the-place-lies-beyond-the-free-end-of-the-rod-write-a-distance-not-greater-than-its-length = a posição está além da extremidade livre da barra: escreva uma distância não maior que o seu comprimento
work-of-the-force-until-then-kinetic-energy-strain-energy = trabalho da força até então = energia cinética + energia de deformação

# shaft-with-discs
bearings = Mancais
clamped-at-the-left-end = Engastado na extremidade esquerda
deflection-at-one-disc-due-to-a-unit-force-at-the-other = Deflexão num disco devida a uma força unitária no outro
deflection-at-the-disc-due-to-a-unit-force-there = Deflexão no disco devida a uma força unitária nele
distance-between-the-bearings = Distância entre os mancais
dunkerley = Dunkerley
error-of-dunkerley-s-frequency = Erro da frequência de Dunkerley
dunkerley-s-frequency-is-never-above-the-exact-one = A frequência de Dunkerley nunca está acima da exata
dunkerley-s-lower-bound = Limite inferior de Dunkerley
dunkerley-the-squares-of-the-periods-of-each-mass-alone-are-added = Dunkerley: somam-se os quadrados dos períodos de cada massa sozinha
exact-lowest-frequency = Menor frequência exata
exact-1-is-the-largest-eigenvalue-of-the-product-of-influence-coefficients-and-masses = Exata: 1/ω² é o maior autovalor do produto dos coeficientes de influência pelas massas
exact-lowest-root-of-the-dynamic-stiffness-of-the-shaft-including-its-mass-and-the-discs = Exata: menor raiz da rigidez dinâmica do eixo, incluindo a sua massa e os discos
frequency-of-the-shaft-without-discs = Frequência do eixo sem discos
its-mass-or-weight = Sua massa ou peso
mass-of-the-disc-weight-over-gravity = Massa do disco: peso sobre gravidade
mass-of-the-shaft-itself = Massa do próprio eixo
mass-of-the-shaft-times-the-square-of-its-static-deflection-integrated-over-the-length = Massa do eixo vezes o quadrado da sua deflexão estática, integrada no comprimento
matrix-iteration-from-equal-deflections = Iteração matricial a partir de deflexões iguais
neglected-if-omitted = Desprezada se omitida.
rayleigh = Rayleigh
error-of-rayleigh-s-value = Erro do valor de Rayleigh
rayleigh-s-frequency-is-never-below-the-exact-one = A frequência de Rayleigh nunca está abaixo da exata
rayleigh-s-upper-bound = Limite superior de Rayleigh
rayleigh-maximum-potential-energy-over-maximum-kinetic-energy-of-the-static-deflection = Rayleigh: energia potencial máxima sobre energia cinética máxima da deflexão estática
root-of-the-frequency-equation-of-the-shaft-without-discs = Raiz da equação de frequências do eixo sem discos
shaft-with-several-discs = Eixo com vários discos
short-bearings-at-both-ends = Mancais curtos nas duas extremidades
short-bearings-at-the-left-end-and-before-the-right-end = Mancais curtos na extremidade esquerda e antes da direita
static-deflection-and-exact-mode-shape = Deflexão estática e forma modal exata
static-deflection-at-the-disc-under-all-weights = Deflexão estática no disco sob todos os pesos
the-discs-on-the-shaft = Os discos no eixo
the-shaft-whirls-with-maximum-amplitude-at-its-natural-frequency-the-discs-treated-as-thin = O eixo tem precessão de máxima amplitude na sua frequência natural, com os discos tratados como finos
thin-they-load-the-shaft-without-stiffening-it = Finos: carregam o eixo sem enrijecê-lo.
three-methods-for-the-lowest-frequency = Três métodos para a menor frequência
weight-of-the-shaft-times-its-static-deflection-integrated-over-the-length = Peso do eixo vezes a sua deflexão estática, integrado no comprimento
a-disc-is-at-a-bearing-where-it-cannot-vibrate-leave-it-out-or-move-it = um disco está num mancal, onde não pode vibrar: omita-o ou mude a sua posição
a-disc-lies-beyond-the-right-end-of-the-shaft-write-a-distance-not-greater-than-its-length = um disco está além da extremidade direita do eixo: escreva uma distância não maior que o seu comprimento
bound = limite
disc-n = disco { $n }
discs-in-the-exact-mode-shape = discos na forma modal exata
lower-bound = limite inferior
matrix-iteration-starting-from-equal-deflections-converges-to-the-exact-frequency = a iteração matricial a partir de deflexões iguais converge para a frequência exata
more-than-eight-discs-merge-adjacent-discs-or-analyse-the-rotor-by-finite-elements = mais de oito discos: una discos adjacentes, ou analise o rotor por elementos finitos
error = erro
strain-energy-over-kinetic-energy-of-the-exact-mode-shape-reproduces-the-root = a energia de deformação sobre a energia cinética da forma modal exata reproduz a raiz
the-lowest-frequency-cannot-be-found-the-masses-of-discs-and-shaft-differ-too-much = a menor frequência não pode ser encontrada: as massas dos discos e do eixo diferem demais
the-second-bearing-is-not-before-the-end-of-the-shaft-choose-bearings-at-both-ends-or-write-a-shorter = o segundo mancal não está antes da extremidade do eixo: escolha mancais nas duas extremidades, ou escreva uma distância menor entre eles
upper-bound = limite superior
work-of-the-shaft-weight-through-the-deflection-due-to-the-discs-equals-that-of-the-discs-through-the = o trabalho do peso do eixo na deflexão causada pelos discos é igual ao dos discos na deflexão causada pelo peso do eixo (Betti)
critical-speeds-and-mode-shapes = Velocidades críticas e formas modais
critical-speeds-and-mode-shapes-of-a-shaft-with-several-discs-the-lowest-also-by-dunkerley-rayleigh = Velocidades críticas e formas modais de um eixo com vários discos; a menor também por Dunkerley, Rayleigh e iteração matricial, com o valor exato e o limite que cada método dá.
higher-frequency = Frequência superior
higher-frequency-the-next-eigenvalue-of-the-product-of-influence-coefficients-and-masses = Frequência superior: o autovalor seguinte do produto dos coeficientes de influência pelas massas
higher-root-of-the-dynamic-stiffness = Raiz superior da rigidez dinâmica
only-for-the-mass-of-the-beam-itself-by-its-density = Apenas para a massa da própria viga, pela sua massa específica.
determinant-of-the-frequency-equation-at-this-frequency = determinante da equação de frequências nesta frequência
the-highest-frequencies-are-more-than-three-hundred-times-the-lowest-and-are-left-out-discs-near-a = as frequências mais altas passam de trezentas vezes a menor e são omitidas: discos perto de um mancal ou de massa desprezível
the-mass-of-the-shaft-by-its-density-needs-the-area-of-the-section-write-the-area-or-the-mass-per = a massa do eixo pela sua massa específica exige a área da seção: escreva a área, ou a massa por unidade de comprimento

# string-rod-shaft
shear-beam-no-bending = Viga de cisalhamento (sem flexão)
disc-on-a-torsional-spring-to-the-ground = Disco com mola de torção ligada à base
frequencies-mode-shapes-and-nodes-of-a-string-under-tension-a-rod-in-axial-vibration-a-shaft-in = Frequências, formas modais e nós de uma corda tracionada, uma barra em vibração axial, um eixo em torção ou uma viga de cisalhamento, com extremidades fixas, livres, com mola ou com massa.
mass-of-the-string = Massa da corda
mass-on-a-spring-to-the-ground = Massa com mola ligada à base
moment-of-inertia-of-the-shaft-i-pl = Momento de inércia do eixo, ρI_pL
rigid-body-motions-of-an-unsupported-body-are-not-included = Não se incluem os movimentos de corpo rígido de um corpo sem apoios.
needed-with-a-density-only = Necessária só com a massa específica.
needed-with-a-spring-or-a-mass-at-an-end-only = Necessária só com mola ou massa numa extremidade.
one-side = Um lado
other-side = Outro lado
polar-second-moment-of-area = Momento polar de inércia
polar-second-moment-of-area-of-a-round-section-also-the-torsion-constant = Momento polar de inércia, numa seção circular também a constante de torção
rectangle-free-to-warp = Retângulo, livre para empenar
rod-along-its-axis = Barra ao longo do seu eixo
root-of-g-g-l-sin-g-g-l-cos-0-g-the-frequency-equation-of-these-ends = Raiz de (g₀ g_L − β²) sen β + (g₀ + g_L) β cos β = 0, g = κ − μβ², a equação de frequências destas extremidades
root-of-sin-cos-0-the-frequency-equation-of-these-ends = Raiz de (κ − μβ²) sen β + β cos β = 0, a equação de frequências destas extremidades
root-of-cos-0-the-frequency-equation-of-these-ends = Raiz de cos β = 0, a equação de frequências destas extremidades
root-of-sin-0-the-frequency-equation-of-these-ends = Raiz de sen β = 0, a equação de frequências destas extremidades
root-l-c = Raiz β = ωL/c
short-and-hollow-so-that-bending-is-negligible = Curta e oca, de modo que a flexão é desprezível.
wave-speed-along-a-string-under-tension = Velocidade de onda ao longo de uma corda tracionada
shear-wave-speed-along-the-beam = Velocidade da onda de cisalhamento ao longo da viga
torsional-wave-speed-along-a-shaft = Velocidade da onda de torção ao longo de um eixo
spring-stiffness-over-the-stiffness-of-the-body = Rigidez da mola sobre a rigidez do corpo
shear-stiffness-of-the-beam-ga-l = Rigidez ao cisalhamento da viga, κGA/L
stiffness-of-the-rod-ea-l = Rigidez da barra, EA/L
stiffness-of-the-shaft-gj-l = Rigidez do eixo, GJ/L
stiffness-of-the-string-t-l = Rigidez da corda, T/L
string-or-cable-under-tension = Corda ou cabo tracionado
strings-rods-shafts-and-shear-beams = Cordas, barras, eixos e vigas de cisalhamento
the-inertia-per-unit-length-is-times-it = A inércia por unidade de comprimento é ρ vezes ele.
the-torque-is-g-j-times-the-twist-per-unit-length-for-a-circular-section-j-is-the-polar-second-moment = O torque é G J vezes o ângulo de torção por unidade de comprimento; numa seção circular, J é o momento polar.
thin-walled-circular-tube = Tubo circular de parede fina
thin-walled-square-tube = Tubo quadrado de parede fina
torsion-constant-and-polar-second-moment-given = Constante de torção e momento polar dados
torsion-constant-of-a-rectangle-by-saint-venant-s-series = Constante de torção de um retângulo, pela série de Saint-Venant
torsion-spring-to-the-ground = Mola de torção ligada à base
attached-inertia-at-the-end-over-the-inertia-of-the-body = Inércia acoplada à extremidade sobre a inércia do corpo
the-body-is-unrestrained-its-rigid-body-motion-at-frequency-zero-precedes-the-first-frequency-and = o corpo está livre: antes da primeira frequência vem o seu movimento de corpo rígido, de frequência nula, que alguns livros contam como primeiro modo
the-area-of-the-section-is-needed-here-write-it-since-mass-or-ends-depend-on-it = a área da seção é necessária aqui: escreva-a, pois a massa ou as extremidades dependem dela
the-frequencies-cannot-be-found-the-spring-or-the-mass-at-an-end-differs-too-much-from-that-of-the = as frequências não podem ser encontradas: a mola ou a massa de uma extremidade difere demais da do corpo

# tapered-beam
area-of-the-left-end = Área da extremidade esquerda
bending-vibration-of-tapered-beams = Vibração de flexão de vigas afiladas
width-at-the-left-end = Largura na extremidade esquerda
width-at-the-right-end = Largura na extremidade direita
width-of-the-right-end-over-that-of-the-left = Largura da extremidade direita sobre a da esquerda
diameter-at-the-left-end = Diâmetro na extremidade esquerda
diameter-at-the-right-end = Diâmetro na extremidade direita
diameter-of-the-right-end-over-that-of-the-left = Diâmetro da extremidade direita sobre o da esquerda
frequencies-with-more-terms = Frequências com mais termos
frequency-error-relative-to-the-converged-value = Erro da frequência em relação ao valor convergido
frequency-number-l-a-ei = Número de frequência Λ = ωL²√(ρA₀/(EI₀))
height-at-the-left-end = Altura na extremidade esquerda
height-at-the-right-end = Altura na extremidade direita
ratio-of-right-end-to-left-end-height = Razão entre as alturas das extremidades direita e esquerda
rayleigh-ritz-with-polynomials-that-satisfy-the-supports-the-minimum-of-strain-energy-over-kinetic = Rayleigh–Ritz com polinômios que satisfazem os apoios: o mínimo da energia de deformação sobre a energia cinética, uma cota superior já convergida
second-moment-of-area-of-the-left-end = Momento de inércia de área da extremidade esquerda
section-at-both-ends = Seção nas duas extremidades
the-beam-and-its-taper-from-the-side-and-from-above = A viga e o seu afilamento, de lado e de cima
the-frequencies-are-multiples-of-ei-a-l-with-the-section-of-the-left-end = As frequências são múltiplos de √(EI₀/(ρA₀L⁴)), com a seção da extremidade esquerda
zero-for-a-beam-that-is-triangular-in-plan = Zero para uma viga triangular em planta.
zero-for-a-cone = Zero para um cone.
zero-for-a-wedge = Zero para uma cunha.
a-right-end-that-tapers-to-a-point-or-an-edge-cannot-be-supported-leave-it-free-or-give-it-a-section = uma extremidade direita que termina em ponta ou aresta não pode ter apoio: deixe-a livre, ou dê-lhe uma seção
relative-distance = distância relativa
mode-shape-n-the-moments-of-its-inertia-forces-store-the-same-energy = forma modal { $n }: os momentos das suas forças de inércia armazenam a mesma energia
terms = termos
the-frequencies-cannot-be-found-the-taper-is-too-strong = as frequências não podem ser encontradas: o afilamento é forte demais
the-frequencies-do-not-converge-with-more-terms-the-taper-is-too-strong-choose-fewer-frequencies = as frequências não convergem com mais termos: o afilamento é forte demais, escolha menos frequências

# beam-with-tip-body
bending-stiffness-in-the-plane-xy = Rigidez à flexão no plano xy
bending-stiffness-in-the-plane-xz = Rigidez à flexão no plano xz
bending-shear-and-rotary-inertia-timoshenko-with-cowper-s-shear-coefficient = Flexão, cisalhamento e inércia de rotação (Timoshenko), com o coeficiente de cisalhamento de Cowper
cantilever-with-a-rigid-body-at-its-tip = Viga em balanço com um corpo rígido na ponta
the-moments-of-the-masses-about-their-centre-cancel = os momentos das massas em torno do seu centro se anulam
frequencies-and-coupled-motions-bending-in-two-planes-axial-torsion-of-a-cantilever-with-masses-on = Frequências e movimentos acoplados (flexão em dois planos, axial, torção) de uma viga em balanço com massas em braços rígidos na ponta.
centre-of-mass-of-the-body = Centro de massa do corpo
centre-of-mass-of-the-body-its-offset-from-the-axis-couples-the-motions = Centro de massa do corpo: o seu afastamento do eixo acopla os movimentos
mass-of-the-body-at-the-tip = Massa do corpo na ponta
masses-at-the-tip = Massas na ponta
moment-of-inertia-per-unit-length-about-the-axis = Momento de inércia por unidade de comprimento em torno do eixo
motion-of-the-tip = Movimento da ponta
motion-of-the-tip-u-l-in-mode = Movimento da ponta (u, θL) no modo
on-rigid-arms-without-mass = Em braços rígidos sem massa.
position-from-the-tip = Posição, a partir da ponta
root-of-the-determinant-of-the-exact-stiffness-of-the-beam-at-its-tip-and-of-the-inertia-of-the-body = Raiz do determinante da rigidez exata da viga na ponta e da inércia do corpo, contadas as frequências abaixo dela
side-along-y = Lado ao longo de y
side-along-z = Lado ao longo de z
stiffness-along-the-axis = Rigidez ao longo do eixo
torsional-rigidity = Rigidez à torção
the-beam-and-its-body-in-the-plane-xy = A viga e o seu corpo no plano xy
theory-of-bending = Teoria de flexão
mass-n = massa { $n }
the-frequencies-cannot-be-found-the-body-at-the-tip-differs-too-much-from-the-mass-or-the-size-of-the = as frequências não podem ser encontradas: o corpo na ponta difere demais da massa ou do tamanho da viga
vibration-n-the-forces-of-the-beam-and-of-the-body-at-the-tip-balance = vibração { $n }: as forças da viga e do corpo na ponta se equilibram
x-continues-along-the-beam-axis-y-and-z-are-transverse = x continua ao longo do eixo da viga, y e z são transversais.

# multi-span-beam
a-span-is-so-slender-so-highly-tensioned-or-so-heavily-loaded-that-its-bending-cannot-be-resolved = um vão é tão esbelto, tão tracionado ou tão carregado que a sua flexão não se distingue: trate-o como corda ou como corpo rígido
beam-over-several-supports = Viga contínua sobre vários apoios
bending-stiffness-of-the-span = Rigidez à flexão do vão
elements-in-each-span = elementos em cada vão
exact-frequencies-mode-shapes-and-nodes-of-a-continuous-beam-of-several-spans-each-with-its-section = Frequências exatas, formas modais e nós de uma viga contínua de vários vãos, cada um com sua seção, força axial e fundação, sobre apoios articulados, engastes e apoios elásticos, com massas nas junções; comparadas com elementos finitos.
finite-elements-upper-bounds-of-the-frequencies = Elementos finitos: limites superiores das frequências
unsupported-joint-between-two-spans-only-the-section-of-the-beam-changes = Junção sem apoio entre dois vãos: apenas muda a seção da viga.
from-left-to-right-each-with-the-element-at-its-right-end = Da esquerda para a direita, cada um com o elemento da sua extremidade direita.
attached-mass = Massa fixada
mass-of-the-span = Massa do vão
moment-of-inertia-of-the-mass-about-its-centre = Momento de inércia da massa em relação ao seu centro
right-end-of-the-span = Extremidade direita do vão
root-n-satisfies-the-equation-of-equal-spans-on-pins = a raiz { $n } satisfaz a equação de vãos iguais sobre apoios
root-of-the-determinant-of-the-exact-dynamic-stiffness-of-all-spans-with-the-frequencies-below-it = Raiz do determinante da rigidez dinâmica exata de todos os vãos, contadas as frequências abaixo dela
root-with-ei-m-l-of-the-first-span = Raiz β com ω = β²√(EI₁/(m̄₁L⁴)), do primeiro vão
spans = Vãos
the-frequencies-are-written-as-multiples-of-ei-m-l-of-the-first-span-and-the-whole-length = As frequências são escritas como múltiplos de √(EI₁/(m̄₁L⁴)), do primeiro vão e do comprimento total
the-frequencies-cannot-be-found-spans-masses-springs-and-forces-differ-too-much-in-magnitude = as frequências não podem ser encontradas: vãos, massas, molas e forças diferem demais em ordem de grandeza
total-length = Comprimento total
there-are-more-than-40-spans-join-equal-adjacent-spans-with-nothing-between-them = há mais de 40 vãos: una vãos iguais adjacentes sem nada entre eles
two-frequencies-coincide-any-linear-combination-of-their-mode-shapes-is-also-a-mode-shape-one-of-them = duas frequências coincidem: qualquer combinação linear das suas formas modais é também uma forma modal; mostra-se uma delas

# plate-and-membrane
bending-stiffness-of-the-plate = Rigidez à flexão da placa
width-between-the-other-two-edges = Largura entre as outras duas bordas
circle = Círculo
clamped-edge = Borda engastada
density-and-thickness = Massa específica e espessura
edge = Borda
exact-frequencies-and-nodal-lines-of-rectangular-and-circular-membranes-circular-plates-and = Frequências exatas e linhas nodais de membranas retangulares e circulares, placas circulares e placas retangulares com duas bordas opostas simplesmente apoiadas.
first-of-the-other-two-edges = Primeira das outras duas bordas
force-per-unit-length-of-the-edge = Força por unidade de comprimento da borda.
free-edge = Borda livre
frequencies-by-nodal-pattern = Frequências por padrão nodal
frequency-number-a-d = Número de frequência Λ = ωa²√(μ/D)
frequency-number-r-d = Número de frequência Λ = ωR²√(μ/D)
frequency-number-the-square-of-the-root = Número de frequência, o quadrado da raiz
half-waves-along-a = meias ondas ao longo de a
half-waves-along-a-and-along-b = Meias ondas ao longo de a e de b
half-waves-along-a-and-number-of-the-shape-across = Meias ondas ao longo de a e número da forma transversal
fixed-along-the-whole-edge = Fixa em todo o contorno.
l-vy-w-y-y-sin-m-x-a-gives-an-ordinary-differential-equation-for-y-a-beam-under-tension-on-a = Lévy: w = Y(y) sen({ $m }πx/a) dá uma equação diferencial ordinária para Y, a de uma viga tracionada sobre fundação; sua raiz { $n }, contada exatamente
length-between-the-two-simply-supported-edges = Comprimento entre as duas bordas simplesmente apoiadas
mode-of-m-n-half-waves-along-a-and-b-c-m-a-n-b = Modo de { $m } × { $n } meias ondas ao longo de a e b: ω = πc√((m/a)² + (n/b)²)
mass-per-unit-area = Massa por unidade de área
mass-per-unit-area-density-times-thickness = Massa por unidade de área: massa específica vezes espessura
mass-per-unit-area-given = Massa por unidade de área dada
mass-per-unit-area-that-of-the-plate-and-what-it-carries = Massa por unidade de área: a da placa e a do que ela carrega
mass-of-the-membrane = Massa da membrana
membrane-under-tension-without-bending-stiffness = Membrana: tracionada, sem rigidez à flexão
nodal-circles = circunferências nodais
nodal-diameters = diâmetros nodais
nodal-diameters-and-nodal-circles = Diâmetros nodais e circunferências nodais
nodal-lines = Linhas nodais
number-across = número transversal
of-what-lies-on-the-plate-and-does-not-stiffen-it = Do que está sobre a placa e não a enrijece.
one-side-is-more-than-a-hundred-times-the-other-treat-the-strip-as-a-string-or-as-a-beam = um lado é mais de cem vezes o outro: trate a faixa como corda ou como viga
additional-mass-per-unit-area = Massa adicional por unidade de área
outline = Contorno
outline-and-edges = Contorno e bordas
rectangle-with-two-opposite-edges-simply-supported = Retângulo com duas bordas opostas simplesmente apoiadas
root-n-by-navier-s-double-sine-m-na-b = raiz { $n } pelo duplo seno de Navier: π²(m² + (na/b)²)
root-s-for-n-n-of-the-condition-that-deflection-and-radial-moment-vanish-at-the-edge = Raiz { $s } para n = { $n } da condição de que a deflexão e o momento radial se anulem na borda
root-s-for-n-n-of-the-condition-that-radial-moment-and-edge-force-vanish = Raiz { $s } para n = { $n } da condição de que o momento radial e a força de borda se anulem
root-s-of-j-n-i-n-i-n-j-n-0-for-n-n-no-deflection-no-slope-at-the-edge = Raiz { $s } de J_n(λ) I_n'(λ) − I_n(λ) J_n'(λ) = 0 para n = { $n }: nem deflexão nem inclinação na borda
second-of-the-other-two-edges = Segunda das outras duas bordas
mode-m-n-in-motion = Modo ({ $m }, { $n }) em movimento
mode-shape-n-bending-and-torsion-energy-over-kinetic-energy = forma modal { $n }: energia de flexão e torção sobre energia cinética
mode-shape-n-energy-of-the-tension-over-kinetic-energy = forma modal { $n }: energia da tração sobre energia cinética
simply-supported-edge = Borda simplesmente apoiada
speed-of-waves-on-the-membrane = Velocidade das ondas na membrana
the-frequencies-are-multiples-of-d-over-the-square-of-the-length = As frequências são múltiplos de √(D/μ) sobre o quadrado do comprimento
the-frequencies-are-multiples-of-the-speed-over-the-radius = As frequências são múltiplos da velocidade sobre o raio
the-frequencies-of-the-plate-cannot-be-found = as frequências da placa não podem ser encontradas
the-plate-can-move-as-a-rigid-body-its-three-motions-at-frequency-zero-are-not-counted = a placa pode mover-se como corpo rígido: seus três movimentos de frequência nula não são contados
the-plate-is-thicker-than-one-twentieth-of-its-smaller-side-shear-and-rotary-inertia-neglected-in = a placa é mais espessa que um vigésimo do seu lado menor: o cisalhamento e a inércia de rotação, desprezados na teoria de placas finas, baixam suas frequências
the-mode-shapes-across-the-plate-are-too-short-for-its-width-choose-fewer-frequencies-or-analyse-the = as formas modais transversais da placa são curtas demais para sua largura: escolha menos frequências ou analise a faixa como viga
thin-plate = Placa fina
vibration-of-plates-and-membranes = Vibração de placas e membranas
vibrating-system = Sistema vibrante
zero-of-the-bessel-function-r-c = Zero da função de Bessel, λ = ωR/c
zero-s-of-the-bessel-function-j-of-order-n = Zero { $s } da função de Bessel J de ordem { $n }

# double-pendulum
body-of-any-form = Corpo de qualquer forma
det-k-m-0-is-2s-k-k-0-with = det(K − λM) = 0 é Δλ² − 2sλ + K₁₁K₂₂ = 0, com λ = ω²
determinant-of-the-masses = Determinante das massas
distance-from-its-pivot-to-the-centre-of-mass = Distância de sua articulação ao centro de massa
distance-from-its-pivot-to-the-other-pivot = Distância de sua articulação à outra articulação
double-pendulum = Pêndulo duplo
first-row-of-k-m-0-angle-of-the-lower-pendulum-over-that-of-the-upper = Primeira linha de (K − λM) φ = 0: o ângulo do pêndulo inferior sobre o do superior
for-small-angles-cos-1-the-velocities-of-pivot-and-centre-add = Para ângulos pequenos cos(θ₁ − θ₂) = 1: as velocidades da articulação e do centro se somam
frequency-n-by-the-numerical-eigenvalues-of-k-and-m = frequência { $n } pelos autovalores numéricos de K e M
its-larger-root-under-the-sign-s-k-k-written-as-a-sum-of-squares = Sua maior raiz; sob o radical, s² − ΔK₁₁K₂₂ escrito como soma de quadrados
lower-pendulum = Pêndulo inferior
mode-n-potential-energy-over-kinetic-energy = modo { $n }: energia potencial sobre energia cinética
moment-of-inertia-about-the-pivot-by-the-parallel-axis-theorem = Momento de inércia em relação à articulação, pelo teorema dos eixos paralelos
natural-frequencies-and-modes-of-two-pendulums-one-hanging-from-the-other-small-masses-rods-or-bodies = Frequências naturais e modos de dois pêndulos, um pendurado no outro: pequenas massas, barras ou corpos de qualquer forma.
natural-angular-frequency = Frequência angular natural
on-the-line-of-the-pivots-positive-downwards = Na linha das articulações, positiva para baixo.
period-a-full-cycle-of-2-over = Período: um ciclo completo de 2π sobre ω
second-row-of-k-m-0-angle-of-the-lower-pendulum-over-that-of-the-upper = Segunda linha de (K − λM) φ = 0: o ângulo do pêndulo inferior sobre o do superior
slender-uniform-rod = Barra esbelta uniforme
small-mass-on-a-light-rod-or-string = Pequena massa em haste leve ou fio
t-m-m-m-the-lower-mass-goes-along-with-the-lower-pivot = T = ½M₁₁θ₁'² + M₁₂θ₁'θ₂' + ½M₂₂θ₂'²: a massa inferior acompanha a articulação inferior
the-centre-of-mass-of-the-rod-is-at-its-middle = O centro de massa da barra está em seu meio
the-lower-pendulum-rotates-about-its-own-pivot = O pêndulo inferior gira em torno de sua própria articulação
the-values-of-the-pendulums-differ-too-much-for-two-frequencies-treat-them-as-one-pendulum = os valores dos pêndulos diferem demais para duas frequências: trate-os como um só pêndulo
the-pendulums = Os pêndulos
the-smaller-root-the-product-of-the-two-is-k-k = A menor raiz: o produto das duas é K₁₁K₂₂/Δ
the-upper-pendulum-is-top-heavy-and-the-lower-one-does-not-compensate-for-it-the-rest-position-is = o pêndulo superior tem o centro de massa acima da articulação e o inferior não o compensa: a posição de repouso é instável e não há vibração
the-weight-of-the-lower-pendulum = O peso do pêndulo inferior
angle-of-the-lower-over-that-of-the-upper-both-from-the-vertical = Ângulo do inferior sobre o do superior, ambos a partir da vertical
upper-pendulum = Pêndulo superior
v-k-k-heights-of-the-weights-from-the-cosines-of-the-angles-with-the-vertical = V = ½K₁₁θ₁² + ½K₂₂θ₂²: alturas dos pesos pelos cossenos dos ângulos com a vertical

# rotating-beam
angle-between-the-motion-and-the-axis-of-rotation = Ângulo entre o movimento e o eixo de rotação
at-an-angle-to-the-axis-of-rotation = Em ângulo com o eixo de rotação
direction-of-the-motion = Direção do movimento
frequencies-of-a-uniform-blade-on-a-rotating-hub-flapwise-or-edgewise-with-centrifugal-stiffening = Frequências de uma pá uniforme em um cubo girante, em batimento ou no plano de rotação, com enrijecimento centrífugo, coeficientes de Southwell e diagrama de Campbell.
frequencies-against-speed = Frequências em função da rotação
frequency-number-of-mode-n-at-rest-over-ei-m-l = Número de frequência do modo { $n } em repouso, ω sobre √(EI/(m̄L⁴))
out-of-plane-frequency-number-f-m-l-ei = Número de frequência fora do plano, ω_f√(m̄L⁴/(EI))
from-the-axis-to-the-clamped-end = Do eixo à extremidade engastada.
in-the-plane-of-rotation-lagwise = No plano de rotação (avanço e recuo)
in-the-plane-of-rotation-the-centrifugal-force-rotates-with-the-blade-and-subtracts = No plano de rotação a força centrífuga gira com a pá e subtrai Ω²
length-of-the-blade = Comprimento da pá
mass-at-the-tip = Massa na ponta
mass-at-the-tip-over-that-of-the-blade = Massa na ponta sobre a da pá
mass-of-the-blade = Massa da pá
mode-n-the-moment-balance-at-low-speed-rises-by-southwell-s-coefficient = modo { $n }: o equilíbrio de momentos em baixa rotação cresce com o coeficiente de Southwell
n-0-is-flapwise-90-edgewise = 0° é batimento, 90° é no plano de rotação.
natural-frequency-n-out-of-the-plane-of-rotation = Frequência natural { $n }, fora do plano de rotação
out-of-the-plane-of-rotation-flapwise = Fora do plano de rotação (batimento)
radius-of-the-hub = Raio do cubo
radius-of-the-hub-over-the-length = Raio do cubo sobre o comprimento
rayleigh-ritz-with-polynomials-that-satisfy-the-clamped-end-the-work-of-the-centrifugal-tension = Rayleigh–Ritz com polinômios que satisfazem o engaste, incluído o trabalho da tração centrífuga: uma cota superior já convergida
rotating-blade = Pá em rotação
mode-shape-n-the-moments-of-tension-and-inertia-forces-balance-the-bending-moment = forma modal { $n }: os momentos da tração e das forças de inércia equilibram o momento fletor
southwell-s-coefficient-at-this-speed = Coeficiente de Southwell nesta rotação
southwell-s-coefficient-from-the-mode-shape-at-rest = Coeficiente de Southwell pela forma modal em repouso
southwell-s-coefficient-from-the-mode-shape-at-rest-work-of-the-centrifugal-tension-at-unit-speed = Coeficiente de Southwell pela forma modal em repouso: trabalho da tração centrífuga à rotação unitária sobre a energia cinética
southwell-s-coefficient-f-s-at-this-speed = Coeficiente de Southwell: ω_f² = ω₀² + S Ω² nesta rotação
speed-in-multiples-of-this-unit = Rotação em múltiplos desta unidade
speed-of-rotation = Velocidade de rotação
rotational-speed = Velocidade de rotação
the-blade-is-unstable-in-the-plane-of-rotation-write-a-larger-stiffness = a pá é instável no plano de rotação: escreva uma rigidez maior
the-blade-rotates-so-fast-for-its-stiffness-that-its-mode-shapes-do-not-converge-write-a-lower-speed = a pá gira tão depressa para sua rigidez que as formas modais não convergem: escreva uma rotação menor ou analise-a como corda
the-frequencies-cannot-be-found-speed-hub-and-mass-at-the-tip-are-too-large-for-this-blade = as frequências não podem ser encontradas: a rotação, o cubo e a massa na ponta são grandes demais para esta pá

# engine-orders
torsional-vibration-of-an-engine = Vibração torcional de um motor
natural-frequencies-of-crankshaft-and-driven-machine-sums-of-the-phase-vectors-of-each-order-critical = Frequências naturais do virabrequim e da máquina acionada, somas dos fasores de cada ordem, rotações críticas com as suas amplitudes e torques.
cycle = Ciclo
firing = Ignição
cranks = Manivelas
in-front-of-the-cranks = À frente das manivelas
damper-pulley-pump-starting-from-the-free-end = Amortecedor, polia, bomba: a partir da extremidade livre.
behind-the-cranks = Atrás das manivelas
flywheel-coupling-driven-machine-starting-from-the-engine-all-referred-to-the-crankshaft-speed = Volante, acoplamento, máquina acionada: a partir do motor, tudo referido à rotação do virabrequim.
torques-of-a-cylinder = Torques de um cilindro
harmonics-of-the-torque-on-one-crank-all-cylinders-have-the-same = Harmônicos do torque sobre uma manivela; todos os cilindros têm os mesmos.
modes-considered = Modos considerados
starting-from-the-lowest = A partir do mais baixo.
without-it-the-amplitude-at-a-critical-speed-is-unbounded = Sem ele a amplitude numa rotação crítica é ilimitada.
diameter-of-the-crankshaft = Diâmetro do virabrequim
the-smallest-diameter-that-transmits-the-torque-within-the-shear-stress-limit = O menor diâmetro que transmite o torque dentro do limite da tensão de cisalhamento.
four-strokes = Quatro tempos
each-cylinder-fires-once-every-two-revolutions-half-orders-too = Cada cilindro tem uma ignição a cada duas voltas: também meias ordens harmônicas.
two-strokes = Dois tempos
each-cylinder-fires-once-per-revolution-integer-orders-only = Cada cilindro tem uma ignição por volta: só ordens harmônicas inteiras.
at-even-intervals = A intervalos iguais
one-cylinder-to-each-crank = Um cilindro em cada manivela.
firing-order = Ordem de ignição
the-numbers-of-the-cylinders-from-the-free-end-such-as-1-5-3-6-2-4 = Os números dos cilindros a partir da extremidade livre, como 1-5-3-6-2-4.
at-given-angles = Em ângulos dados
for-unequal-intervals-and-for-v-engines-with-two-cylinders-per-crank = Para intervalos desiguais e para motores em V com dois cilindros por manivela.
cylinders = Cilindros
crank = Manivela
counted-from-the-free-end = Contada a partir da extremidade livre.
firing-angle = Ângulo de ignição
crank-angle-since-the-first-cylinder-fired = Ângulo do virabrequim desde a ignição do primeiro cilindro.
all-equal = Todas iguais
moment-of-inertia-of-a-crank = Momento de inércia de uma manivela
crank-throw-big-end-and-half-of-the-reciprocating-mass-at-the-crank-radius = Cotovelo, cabeça da biela e metade da massa alternativa, no raio da manivela.
stiffness-between-two-cranks = Rigidez entre duas manivelas
one-by-one = Uma a uma
stiffness-of-the-shaft-to-the-next-crank = Rigidez do eixo até a manivela seguinte
omit-for-the-last-crank = Omitida na última manivela.
shaft-towards-the-engine = Eixo do lado do motor
from-the-middle-of-the-nearest-crank-or-from-the-previous-part = Desde o meio da manivela mais próxima, ou desde a peça anterior.
only-the-sums-of-the-phase-vectors = Só as somas dos fasores.
highest-order = Maior ordem
maximum-order = Ordem máxima
amplitudes-of-the-torque = Amplitudes do torque
harmonics = Harmônicos
amplitudes-of-the-tangential-pressure = Amplitudes da pressão tangencial
the-tangential-force-at-the-crankpin-over-the-area-of-the-piston = A força tangencial no moente sobre a área do pistão.
bore = Diâmetro do cilindro
order = Ordem
the-same-for-every-mode = A mesma para todos os modos.
dynamic-magnifier-given = Fator de amplificação dinâmica dado
amplitude-at-resonance-over-the-equilibrium-amplitude = Amplitude na ressonância sobre a amplitude de equilíbrio.
dynamic-magnifier = Fator de amplificação dinâmica
damping-at-the-cranks = Amortecimento nas manivelas
damping-coefficient-of-a-cylinder = Coeficiente de amortecimento de um cilindro
torque-over-angular-velocity-of-the-vibration = Torque sobre velocidade angular da vibração.
equivalent-length-given = Comprimento equivalente dado
a-straight-shaft-with-the-same-twist = Um eixo reto com a mesma torção.
equivalent-length = Comprimento equivalente
diameter-of-the-equivalent-shaft = Diâmetro do eixo equivalente
dimensions-given = Dimensões dadas
length-of-a-journal = Comprimento de um munhão
diameter-of-the-journals = Diâmetro dos munhões
bore-of-the-journals = Furo dos munhões
length-of-the-crankpin = Comprimento do moente
diameter-of-the-crankpin = Diâmetro do moente
bore-of-the-crankpin = Furo do moente
thickness-of-a-web = Espessura de um braço
along-the-shaft = Ao longo do eixo.
width-of-a-web = Largura de um braço
radius-of-the-crank = Raio da manivela
half-of-the-stroke = Metade do curso.
formula = Fórmula
carter = Carter
for-webs-whose-bending-exceeds-the-twist-of-journals-and-crankpin = Para braços cuja flexão supera a torção de munhões e moente.
ker-wilson = Ker Wilson
for-stiff-webs = Para braços rígidos.
mean-of-both = Média das duas
the-lowest-speed-is-not-below-the-highest-one-write-the-smaller-one-as-the-lowest = a menor rotação não está abaixo da maior: escreva a menor das duas como a mais baixa
a-single-crank-rotates-freely-and-does-not-vibrate-write-a-flywheel-or-another-crank = uma manivela sozinha gira livremente e não vibra: escreva um volante ou outra manivela
sums-of-the-phase-vectors-by-order = Somas dos fasores por ordem harmônica
major-orders-all-cylinders-push-together = Ordens principais: todos os cilindros agem juntos
critical-speeds-between-the-lowest-and-the-highest-speed-an-order-coincides-with-a-natural-frequency = Rotações críticas entre a menor e a maior: uma ordem harmônica coincide com uma frequência natural
number-of-critical-speeds-in-the-range = Número de rotações críticas na faixa
without-damping-the-amplitude-at-a-critical-speed-is-unbounded-it-grows-with-time-the-equilibrium = sem amortecimento a amplitude numa rotação crítica não tem limite: cresce com o tempo; dá-se em seu lugar a amplitude de equilíbrio
the-major-order-order-of-the-first-mode-is-critical-at-speed-within-the-range-of-speeds = a ordem principal { $order } do primeiro modo é crítica em { $speed }, dentro da faixa de rotações
there-are-more-than-100-orders-omit-the-highest-ones = há mais de 100 ordens: omita as mais altas
an-order-of-a-four-stroke-engine-is-a-multiple-of-one-half-write-orders-such-as-0-5-1-or-4-5 = uma ordem de um motor de quatro tempos é múltiplo de um meio: escreva ordens como 0.5, 1 ou 4.5
an-order-of-a-two-stroke-engine-is-a-whole-number-write-orders-such-as-1-2-or-6 = uma ordem de um motor de dois tempos é um número inteiro: escreva ordens como 1, 2 ou 6
an-order-appears-twice-in-the-table-write-each-order-once = uma ordem aparece duas vezes na tabela: escreva cada ordem uma só vez
by-holzer-s-method-at-this-frequency-the-residual-torque-at-the-last-mass-is-zero = Pelo método de Holzer: nesta frequência o torque residual na última massa é nulo
amplitude-of-the-first-mass-the-reference-for-all-others = Amplitude da primeira massa, referência para todas as outras
from-holzer-s-table-amplitude-of-the-previous-mass-minus-the-twist-between-them = Pela tabela de Holzer: amplitude da massa anterior, menos a torção entre elas
inertia-of-the-mode-a-disc-at-the-first-mass-with-the-same-kinetic-energy = Inércia do modo: um disco na primeira massa com a mesma energia cinética
nodes-from-the-free-end-position-in-mass-spacings = Nós a partir da extremidade livre (posição em espaçamentos de massas)
amplitude-of-the-crank-on-which-the-cylinder-works = Amplitude da manivela em que o cilindro age
a-four-stroke-cylinder-fires-once-every-two-revolutions = Um cilindro de quatro tempos tem uma ignição a cada duas voltas
a-two-stroke-cylinder-fires-once-per-revolution = Um cilindro de dois tempos tem uma ignição por volta
crank-angle-from-one-firing-to-the-next = Ângulo de manivela de uma ignição à seguinte
firing-angle-by-the-place-in-the-firing-order = Ângulo de ignição, pela posição na ordem de ignição
there-are-more-than-48-cylinders-write-fewer = há mais de 48 cilindros: escreva menos
a-cylinder-acts-on-crank-crank-but-there-are-only-count-write-more-cranks-or-another-number = um cilindro age na manivela { $crank }, mas há só { $count }: escreva mais manivelas ou outro número
the-firing-order-contains-no-cylinder-or-more-than-24-write-the-numbers-of-the-cylinders-such-as-1-3 = a ordem de ignição não tem nenhum cilindro, ou tem mais de 24: escreva os números dos cilindros, como 1-3-4-2
the-firing-order-of-count-cylinders-does-not-include-number-write-each-number-from-1-on-once = a ordem de ignição de { $count } cilindros não inclui { $number }: escreva cada número a partir de 1 uma só vez
the-last-crank-has-no-next-one-omit-its-stiffness-and-write-it-with-the-part-behind = a última manivela não tem seguinte: omita a sua rigidez e escreva-a na peça de trás
the-stiffness-from-crank-crank-to-the-next-one-is-missing-write-it = falta a rigidez da manivela { $crank } até a seguinte: escreva-a
crank-n = manivela { $n }
there-are-more-than-200-masses-join-some-of-them = há mais de 200 massas: reúna algumas delas
polar-second-moment-of-area-of-the-equivalent-shaft = Momento polar de inércia do eixo equivalente
stiffness-between-two-cranks-that-of-the-equivalent-shaft = Rigidez entre duas manivelas: a do eixo equivalente
a-bore-is-not-smaller-than-the-surrounding-diameter-write-a-smaller-bore-or-leave-it-out = um furo não é menor que o diâmetro em torno dele: escreva um furo menor ou omita-o
contribution-of-the-journals-length-over-the-fourth-power-of-the-diameter-plus-the-twisting-part-of = Contribuição dos munhões: comprimento sobre a quarta potência do diâmetro, com a parte dos braços que torce
contribution-of-the-crankpin = Contribuição do moente
contribution-of-the-webs-in-bending = Contribuição dos braços em flexão
stiffness-by-carter-s-formula = Rigidez pela fórmula de Carter
stiffness-by-ker-wilson-s-formula = Rigidez pela fórmula de Ker Wilson
journal-and-crankpin-overlap-so-much-that-ker-wilson-s-formula-leaves-no-web-length-choose-carter-s = munhão e moente se sobrepõem tanto que a fórmula de Ker Wilson não deixa comprimento de braço: escolha a fórmula de Carter
carter-s-and-ker-wilson-s-formulas-differ-by-more-than-20-measure-the-stiffness-or-calculate-with = as fórmulas de Carter e de Ker Wilson diferem em mais de 20 %: meça a rigidez ou calcule com as duas
mean-of-the-two-formulas = Média das duas fórmulas
polar-second-moment-of-area-of-a-straight-shaft-with-the-diameter-of-the-journals = Momento polar de inércia de um eixo reto com o diâmetro dos munhões
equivalent-length-a-straight-shaft-with-the-same-twist = Comprimento equivalente: um eixo reto com a mesma torção
equivalent-length-of-a-throw = Comprimento equivalente de um cotovelo
order-of-a-torque-that-is-critical-in-mode-mode = Ordem de um torque que é crítica no modo { $mode }
the-order-makes-n-vibrations-per-revolution-critical-speed = A ordem harmônica faz n vibrações por volta: rotação crítica
phase-vectors-each-cylinder-with-the-amplitude-of-its-crank-rotated-by-n-times-its-firing-angle = Fasores: cada cilindro com a amplitude da sua manivela, girado n vezes o seu ângulo de ignição
sum-of-their-sine-components = Soma das suas componentes em seno
sum-of-the-phase-vectors = Soma dos fasores
sum-of-the-phasors = Soma dos fasores
square-of-the-sum-from-the-angles-between-each-pair-of-cylinders = quadrado da soma pelos ângulos entre cada par de cilindros
torque-of-a-cylinder-for-this-order-from-the-table = Torque de um cilindro nesta ordem harmônica, pela tabela
tangential-pressure-for-this-order-from-the-table = Pressão tangencial desta ordem harmônica, pela tabela
torque-of-a-cylinder-pressure-times-piston-area-times-crank-radius = Torque de um cilindro: pressão vezes área do pistão vezes raio da manivela
equilibrium-amplitude-at-the-first-mass-static-torques-over-the-modal-stiffness-j = Amplitude de equilíbrio na primeira massa: torques estáticos sobre a rigidez modal ω² J
equilibrium-amplitude-of-the-first-mass = Amplitude de equilíbrio da primeira massa
energy-balance-the-work-t-s-of-the-torques-per-cycle-equals-the-energy-c-dissipated-by-damping = Balanço de energia: o trabalho π T Θ S dos torques por ciclo é igual à energia π c ω Θ² Σ β² dissipada pelo amortecimento
amplitude-at-resonance-larger-by-the-factor-1-2 = Amplitude na ressonância, maior pelo fator 1/(2 ζ)
amplitude-at-resonance-larger-by-the-dynamic-magnifier = Amplitude na ressonância: maior pelo fator de amplificação dinâmica
sum-of-the-squared-amplitudes-of-the-damped-cranks = Soma dos quadrados das amplitudes das manivelas amortecidas
amplitude-of-the-first-mass = Amplitude da primeira massa
work-of-the-torques-summed-over-a-cycle-equals-the-energy-dissipated-by-damping = o trabalho dos torques, somado num ciclo, é igual à energia dissipada pelo amortecimento
maximum-vibratory-torque-in-the-crankshaft-behind-mass = Torque vibratório máximo no virabrequim, após { $mass }
maximum-torque-in-the-crankshaft = Torque máximo no virabrequim
shear-stress-due-to-that-torque-in-a-circular-shaft = Tensão de cisalhamento devida a esse torque num eixo circular
shear-stress-in-the-crankshaft = Tensão de cisalhamento no virabrequim
critical-speeds-in-the-range = Rotações críticas na faixa
major = principal
sum-of-phasors = soma dos fasores
torque-of-a-cylinder = torque de um cilindro
equilibrium-amplitude = amplitude de equilíbrio
sums-of-the-phase-vectors = Somas dos fasores
k-to-the-next = k até a seguinte
masses-and-their-amplitudes = Massas e as suas amplitudes
sums-of-the-phase-vectors-against-the-order = Somas dos fasores em função da ordem
order-order = ordem { $order }
critical-speeds = rotações críticas
range-of-speeds = faixa de rotações
interference-diagram = Diagrama de interferência
amplitudes-along-the-line = Amplitudes ao longo da linha
mass-number-from-the-free-end = número da massa a partir da extremidade livre
amplitude-relative-to-that-of-the-first-mass = amplitude relativa à da primeira massa
amplitude-of-the-first-mass-against-the-speed = Amplitude da primeira massa em função da rotação
phase-vector-star-diagrams = Estrelas dos fasores
phase-vector-star-diagrams-in-the-first-mode-the-sum-as-a-fraction-of-the-total-length = Estrelas dos fasores no primeiro modo; a soma como fração do comprimento total
torques-unknown = Torques desconhecidos
# pendulum-absorber
pendulum-absorber = Absorvedor pendular
order-arm-and-mass-of-centrifugal-pendulums-and-rollers-on-a-rotor-their-swing-and-effective-inertia = Ordem, braço e massa de pêndulos centrífugos e roletes num rotor, a sua oscilação e inércia efetiva, e pêndulos sob uma massa que oscila.
on-a-rotor = Num rotor
the-centrifugal-field-restores-the-pendulum-so-its-frequency-is-proportional-to-the-speed = O campo centrífugo restaura o pêndulo, de modo que a sua frequência é proporcional à rotação.
distance-of-the-pivot-from-the-shaft = Distância do pino ao eixo
for-rollers-measured-to-the-centre-of-the-hole = Para roletes, medida até o centro do furo.
mass-of-a-pendulum = Massa de um pêndulo
pendulums = Pêndulos
without-the-pendulums = Sem os pêndulos.
stiffness-of-the-shaft-supporting-the-rotor = Rigidez do eixo que suporta o rotor
omit-for-a-rotor-that-turns-freely = Omitida para um rotor que gira livremente.
order-of-the-torque = Ordem do torque
if-omitted-it-is-the-tuned-order = Se for omitida, é a ordem sintonizada.
suspended-from-an-oscillating-mass = Suspenso de uma massa oscilante
gravity-is-the-restoring-force-of-the-pendulum-the-mass-moves-sideways = A gravidade é a força restauradora do pêndulo; a massa move-se lateralmente.
oscillating-mass = Massa oscilante
stiffness-of-its-springs = Rigidez das suas molas
length-of-the-pendulum = Comprimento do pêndulo
mass-of-the-pendulum = Massa do pêndulo
small-mass-on-an-arm = Massa pequena num braço
body-on-a-pivot = Corpo articulado
it-rotates-with-its-arm = Gira com o seu braço.
radius-of-gyration-about-its-centre-of-mass = Raio de giração em relação ao seu centro de massa
bifilar-on-two-pins-in-larger-holes = Bifilar: em dois pinos dentro de furos maiores
it-does-not-rotate-relative-to-the-rotor-the-arm-is-the-hole-diameter-minus-the-pin-diameter = Não gira em relação ao rotor; o braço é o diâmetro dos furos menos o dos pinos.
roller-in-a-hole = Rolete num furo
it-rolls-without-slipping-the-arm-is-the-hole-radius-minus-the-roller-radius = Rola sem deslizar; o braço é o raio do furo menos o do rolete.
radius-of-the-roller = Raio do rolete
shape = Forma
solid-cylinder = Cilindro maciço
arm-given = Braço dado
from-the-pivot-to-the-centre-of-mass = Do pino ao centro de massa.
order-to-tune-to = Ordem a sintonizar
vibrations-per-revolution-to-be-absorbed-by-the-pendulum = Vibrações por volta que o pêndulo deve absorver.
length-given = Comprimento dado
omit-for-a-small-mass-on-a-string = Omitido para uma massa pequena num fio.
tuned-to-the-force = Sintonizado com a força
a-small-mass-on-a-string = Uma massa pequena num fio.
limited-swing-angle = Ângulo de oscilação limitado
the-lightest-pendulum-that-does-not-exceed-this-amplitude-under-the-load-it-absorbs = O pêndulo mais leve que não excede esta amplitude sob a carga que absorve.
maximum-swing-angle = Ângulo máximo de oscilação
square-of-the-radius-of-gyration-of-a-solid-roller-over-that-of-its-radius = Quadrado do raio de giração de um rolete maciço sobre o do seu raio
square-of-the-radius-of-gyration-of-a-ring-over-that-of-its-radius = Quadrado do raio de giração de um anel sobre o do seu raio
radius-of-gyration-of-the-roller = Raio de giração do rolete
arm-that-tunes-a-roller-to-the-order-from-n-r-r-1-q = Braço que sintoniza um rolete na ordem harmônica, por n² = R/(r (1 + q))
the-arm-is-a-root-of-r-2-h-r-0-from-n-r-r-r-with-this-h = O braço é uma raiz de r² − 2 h r + κ² = 0, por n² = R r/(r² + κ²), com este h
no-arm-tunes-this-body-to-the-order-write-a-smaller-radius-of-gyration-or-a-pivot-further-out = nenhum braço sintoniza este corpo na ordem: escreva um raio de giração menor ou um pino mais afastado
the-larger-root-the-shorter-arm-needs-a-much-larger-oscillation = A raiz maior: o braço mais curto exige uma oscilação muito maior
arm-that-tunes-the-pendulum-to-the-order-from-n-r-r = Braço que sintoniza o pêndulo na ordem harmônica, por n² = R/r
inertia-of-the-pendulum-motion-per-kilogram-the-smaller-a-roller-the-faster-it-spins = Inércia do movimento pendular por quilograma: quanto menor o rolete, mais depressa ele gira
inertia-of-the-pendulum-motion-per-kilogram-about-the-pivot = Inércia do movimento pendular por quilograma, em relação ao pino
coupling-per-kilogram-a-roller-rotates-opposite-to-the-pendulum-motion-of-its-centre = Acoplamento por quilograma: um rolete gira em sentido oposto ao movimento pendular do seu centro
coupling-of-pendulum-motion-and-rotor-per-kilogram = Acoplamento entre movimento pendular e rotor por quilograma
the-roller-is-so-large-that-it-rotates-against-its-own-swing-and-absorbs-nothing-write-a-smaller-one = o rolete é tão grande que gira contra a sua própria oscilação e nada absorve: escreva um menor
tuned-order-frequency-of-the-pendulum-over-the-speed-at-any-speed = Ordem sintonizada: frequência do pêndulo sobre a rotação, em qualquer rotação
tuned-order = Ordem sintonizada
frequency-of-the-pendulum-motion-at-this-speed-at-this-frequency-the-rotor-is-at-rest = Frequência do movimento pendular nesta rotação: nessa frequência o rotor fica em repouso
frequency-at-which-the-rotor-is-at-rest = Frequência em que o rotor fica em repouso
the-mass-for-a-limited-swing-follows-from-the-torque-write-its-amplitude = a massa para uma oscilação limitada decorre do torque: escreva a sua amplitude
mass-of-each-pendulum-at-its-limit-angle-it-absorbs-the-whole-torque-of-the-tuned-order = Massa de cada pêndulo: no seu ângulo-limite absorve todo o torque da ordem sintonizada
rotor-with-the-pendulums-locked-to-it = Rotor com os pêndulos travados nele
inertia-coupling-of-rotor-and-pendulum-motion = Acoplamento inercial entre rotor e movimento pendular
inertia-of-the-pendulum-motion = Inércia do movimento pendular
natural-frequency-of-rotor-and-pendulum = Frequência natural de rotor e pêndulo
order-that-coincides-with-it-at-this-speed = Ordem que coincide com ela nesta rotação
order-that-resonates-at-this-speed = Ordem que ressoa nesta rotação
at-the-tuned-order-the-pendulum-acts-like-an-infinite-flywheel-friction-alone-leaves-some-motion = na ordem sintonizada o pêndulo age como um volante infinito; só o atrito deixa algum movimento
effective-inertia-of-the-pendulums-at-the-order-of-the-torque-negative-beyond-the-tuned-order = Inércia efetiva dos pêndulos na ordem harmônica do torque; negativa além da ordem sintonizada
effective-inertia-of-the-pendulums = Inércia efetiva dos pêndulos
effective-inertia-from-the-pendulum-oscillation-caused-by-a-moving-rotor = inércia efetiva pela oscilação dos pêndulos causada por um rotor em movimento
frequency-of-the-torque = Frequência do torque
coupling-coefficient-of-body-and-pendulum-motion = Coeficiente de acoplamento entre corpo e movimento pendular
the-rotor-is-unrestrained-rotor-and-pendulum-oscillate-against-each-other = O rotor está livre: rotor e pêndulo oscilam um contra o outro
frequency-with-the-pendulum-locked = Frequência com o pêndulo travado
the-larger-root-of-1-p-p-0-with = A raiz maior de (1 − ε) λ² − (p² + ω₀²) λ + p² ω₀² = 0, com λ = ω²
the-product-of-the-roots-is-p-1 = O produto das raízes é p² ω₀²/(1 − ε)
upper-natural-frequency = Frequência natural superior
lower-natural-frequency = frequência natural inferior
frequency-from-the-matrices-of-the-small-motions = frequência pelas matrizes dos pequenos movimentos
determinant-of-the-two-equations-of-the-steady-state-motion = Determinante das duas equações do regime permanente
the-load-frequency-coincides-with-a-natural-frequency-of-body-and-pendulum-without-damping-the-motion = a frequência da carga coincide com uma frequência natural de corpo e pêndulo: sem amortecimento o movimento cresce sem limite e não há regime permanente
amplitude-of-the-body-negative-if-opposed-to-the-load = Amplitude do corpo; negativa se oposta à carga
amplitude-of-the-rotor = Amplitude do rotor
swing-amplitude-of-the-pendulum-negative-if-opposed-to-the-load = Amplitude de oscilação do pêndulo; negativa se oposta à carga
swing-amplitude-of-the-pendulum = Amplitude de oscilação do pêndulo
load-inertia-and-springs-are-in-equilibrium-at-the-body = carga, inércia e molas estão em equilíbrio no corpo
oscillation-from-the-matrices-of-the-small-motions = oscilação pelas matrizes dos pequenos movimentos
the-swing-angle-is-above-20-the-frequency-of-a-pendulum-on-a-circle-decreases-with-amplitude-and-the = o ângulo de oscilação passa de 20°: a frequência de um pêndulo num arco de círculo diminui com a amplitude, e os resultados valem para oscilações pequenas
length-that-tunes-the-pendulum-to-the-force-from-g-l = Comprimento que sintoniza o pêndulo com a força, por ω² = g/l
frequency-of-the-pendulum-on-a-fixed-pivot-at-this-frequency-the-mass-is-at-rest = Frequência do pêndulo num pino fixo: nessa frequência a massa fica em repouso
frequency-at-which-the-mass-is-at-rest = Frequência em que a massa fica em repouso
the-mass-for-a-limited-swing-follows-from-the-force-write-its-amplitude = a massa para uma oscilação limitada decorre da força: escreva a sua amplitude
mass-of-the-pendulum-at-its-limit-angle-and-its-own-frequency-it-absorbs-the-whole-force = Massa do pêndulo: no seu ângulo-limite e na sua própria frequência absorve toda a força
mass-and-pendulum-move-sideways-together = Massa e pêndulo movem-se lateralmente juntos
inertia-coupling-of-mass-and-pendulum-motion = Acoplamento inercial entre massa e movimento pendular
moment-of-inertia-of-the-pendulum-about-its-pivot = Momento de inércia do pêndulo em relação ao seu pino
natural-frequency-of-mass-and-pendulum = Frequência natural de massa e pêndulo
effective-inertia-of-the-pendulums-against-the-order = Inércia efetiva dos pêndulos em função da ordem harmônica
effective-inertia = inércia efetiva
cancels-the-rotor-inertia = anula a inércia do rotor
natural-frequencies-against-the-speed = Frequências naturais em função da rotação
the-pendulum-on-the-rotor = O pêndulo no rotor
amplitudes-of-the-mass-and-of-the-end-of-the-pendulum-per-newton-of-force = Amplitudes da massa e da ponta do pêndulo por newton da força
amplitude-over-force = amplitude sobre força
oscillation-at-the-end-of-the-pendulum = oscilação na ponta do pêndulo
this-force = esta força
the-mass-with-its-pendulum = A massa com o seu pêndulo
# swing-test
distance = distância
moment-of-inertia-from-an-oscillation-test = Momento de inércia por ensaio de oscilação
moment-of-inertia-from-the-period-on-a-knife-edge-about-two-points-on-wires-on-a-torsion-wire-or = Momento de inércia pelo período sobre um cutelo, em torno de dois pontos, em fios, num fio de torção ou rolando em trilhos.
test = Ensaio
about-one-point-centre-of-mass-known = Em torno de um ponto, centro de massa conhecido
a-compound-pendulum-a-connecting-rod-on-a-knife-edge = Um pêndulo composto: uma biela sobre um cutelo.
from-the-point-of-suspension-to-the-centre-of-mass = Do ponto de suspensão ao centro de massa
swings = Oscilações
oscillations = Oscilações
amplitude-of-the-oscillations = Amplitude das oscilações
from-the-lowest-position-omitted-for-small-oscillations = A partir da posição mais baixa; omitida para oscilações pequenas.
about-two-points-centre-of-mass-unknown = Em torno de dois pontos, centro de massa desconhecido
the-two-points-and-the-centre-of-mass-are-collinear = Os dois pontos e o centro de massa são colineares.
between-the-two-points = Entre os dois pontos
position-of-the-centre-of-mass = Posição do centro de massa
oscillations-about-the-first-point = Oscilações em torno do primeiro ponto
oscillations-about-the-second-point = Oscilações em torno do segundo ponto
the-same-for-both-omitted-for-small-oscillations = A mesma para as duas; omitida para oscilações pequenas.
on-two-three-or-more-parallel-wires = Em dois, três ou mais fios paralelos
bifilar-trifilar-the-body-rotates-about-the-vertical-line-through-its-centre-of-mass = Bifilar, trifilar: o corpo gira em torno da vertical pelo seu centro de massa.
from-the-axis-to-the-wires-at-the-body = Do eixo aos fios, no corpo
from-the-axis-to-the-wires-at-the-top = Do eixo aos fios, em cima
omit-if-the-wires-are-vertical = Omitida quando os fios são verticais.
platform = Plataforma
carries-the-body-omitted-if-the-wires-support-the-body-itself = Sustenta o corpo; omitida quando os fios sustentam o próprio corpo.
on-a-wire-in-torsion = Num fio em torção
wire = Fio
oscillating-by-rolling-in-concave-rails = Oscilando por rolamento em trilhos côncavos
on-its-journals = Sobre os seus munhões.
radius-of-the-journals = Raio dos munhões
radius-of-the-rails = Raio dos trilhos
rolling-down-inclined-rails = Descendo trilhos inclinados
on-its-journals-from-rest-and-without-slipping = Sobre os seus munhões, a partir do repouso e sem deslizar.
slope-of-the-rails = Inclinação dos trilhos
distance-rolled = Distância percorrida
time-taken = Tempo gasto
period-given = Período dado
a-complete-oscillation = Uma oscilação completa.
time-of-several-oscillations = Tempo de várias oscilações
number-of-oscillations = Número de oscilações
full-oscillations-there-and-back = Oscilações completas (ida e volta).
total-time = Tempo total
beyond-the-second-point = Além do segundo ponto
both-points-on-one-side-of-it-the-second-one-nearer = Os dois pontos de um mesmo lado dele, o segundo mais perto.
mass-of-the-platform = Massa da plataforma
oscillations-of-the-empty-platform = Oscilações da plataforma vazia
known-inertia-added = Inércia conhecida acrescentada
the-body-is-oscillated-again-with-it = O corpo oscila outra vez com ela.
added-inertia = Inércia acrescentada
oscillations-with-it = Oscilações com ela
known-body-in-its-place = Corpo conhecido no lugar
inertia-of-the-known-body = Inércia do corpo conhecido
oscillations-of-the-known-body-alone = Oscilações do corpo conhecido sozinho
the-journals-are-not-smaller-than-the-curvature-radius-of-the-rails-write-a-larger-rail-radius = os munhões não são menores que o raio de curvatura dos trilhos: escreva um raio maior dos trilhos
the-journal-rolls-without-slipping-t-4-r-1-g = O munhão rola sem deslizar: T² = 4π² (R − ρ)(1 + κ²/ρ²)/g
period-from-the-kinetic-and-the-potential-energy = período pelas energias cinética e potencial
acceleration-of-the-centre-from-rest-s-a-t-2 = Aceleração do centro, a partir do repouso: s = a t²/2
rolling-without-slipping-a-g-sin-1 = Rolamento sem deslizamento: a = g sen α/(1 + κ²/ρ²)
kinetic-energy-at-the-end-is-the-work-of-the-weight = a energia cinética no fim é o trabalho do peso
moment-of-inertia-about-the-axis-of-the-wire = Momento de inércia em relação ao eixo do fio
period-the-time-over-the-number-of-oscillations = Período: o tempo sobre o número de oscilações
period-of-small-oscillations-large-ones-take-1-agm-1-cos-2-times-as-long = Período das pequenas oscilações: o das grandes é esse multiplicado por 1/agm(1, cos θ₀/2)
period-of-the-large-amplitude-oscillation-by-quadrature = período da oscilação de grande amplitude por quadratura
the-same-mean-as-for-the-first-point = A mesma média que para o primeiro ponto
the-body-would-roll-faster-than-a-body-without-inertia-the-time-is-too-short-for-these-rails = o corpo rolaria mais depressa que um corpo sem inércia: o tempo é curto demais para estes trilhos
moment-of-inertia-about-the-axis-of-rolling = Momento de inércia em relação ao eixo de rolamento
length-of-the-simple-pendulum-of-equal-period-t-4-g = Comprimento do pêndulo simples de mesmo período: T² = 4π² λ/g
length-of-the-equivalent-simple-pendulum-to-the-centre-of-percussion = Comprimento do pêndulo simples equivalente, até o centro de percussão
the-period-is-that-of-a-simple-pendulum-shorter-than-the-distance-to-the-centre-of-mass-which-is = o período é o de um pêndulo simples mais curto que a distância ao centro de massa, o que é impossível: escreva um período maior ou uma distância menor
moment-of-inertia-about-the-point-of-suspension-from-j-o-m-s = Momento de inércia em relação ao ponto de suspensão, por λ = J_O/(m s)
moment-of-inertia-about-the-point-of-suspension = Momento de inércia em relação ao ponto de suspensão
parallel-axis-theorem-the-moment-of-inertia-about-the-centre-of-mass-is-smaller-by-m-s = Teorema dos eixos paralelos: o momento de inércia em relação ao centro de massa é menor em m s²
the-radius-of-gyration-reproduces-the-period = o raio de giração reproduz o período
the-moment-of-inertia-is-a-small-difference-of-large-values-errors-of-distance-and-period-are = o momento de inércia é uma diferença pequena entre valores grandes: os erros da distância e do período são amplificados; suspenda o corpo mais perto do seu centro de massa
length-of-the-simple-pendulum-of-equal-period = Comprimento do pêndulo simples de mesmo período
the-two-points-are-conjugate-like-those-of-a-reversible-pendulum-every-centre-of-mass-between-them = os dois pontos são conjugados como os de um pêndulo reversível: qualquer centro de massa entre eles serve, escolha outros pontos
from-the-first-point-to-the-centre-of-mass-h-h-h-h-with-h-h-l = Do primeiro ponto ao centro de massa: h₁² − λ₁ h₁ = h₂² − λ₂ h₂ = −κ², com h₁ + h₂ = L
from-the-first-point-to-the-centre-of-mass-beyond-the-second-point-h-h-h-h-with-h-h-l = Do primeiro ponto ao centro de massa além do segundo: h₁² − λ₁ h₁ = h₂² − λ₂ h₂ = −κ², com h₁ − h₂ = L
from-the-second-point-to-the-centre-of-mass = Do segundo ponto ao centro de massa
no-centre-of-mass-on-this-side-fits-the-two-periods-check-whether-it-is-between-the-points-or-beyond = nenhum centro de massa deste lado é compatível com os dois períodos: verifique se ele está entre os pontos ou além do segundo
centre-of-mass-from-the-first-point = Centro de massa a partir do primeiro ponto
moment-of-inertia-about-the-centre-of-mass-m-m-h-h = Momento de inércia em relação ao centro de massa: m κ² = m h₁ (λ₁ − h₁)
the-oscillation-about-the-second-point-gives-the-same-moment-of-inertia = a oscilação em torno do segundo ponto dá o mesmo momento de inércia
the-radius-of-gyration-reproduces-the-second-period = o raio de giração reproduz o segundo período
the-two-periods-are-almost-those-of-a-reversible-pendulum-small-errors-in-them-shift-the-centre-of = os dois períodos são quase os de um pêndulo reversível: pequenos erros neles deslocam muito o centro de massa
period-against-the-distance-of-the-point-of-suspension-from-the-centre-of-mass = Período em função da distância do ponto de suspensão ao centro de massa
first-point = primeiro ponto
second-point = segundo ponto
minimum-period = período mínimo
the-body-and-its-points-of-suspension = O corpo e os seus pontos de suspensão
the-wires-are-too-short-to-reach-from-one-circle-to-the-other-write-a-larger-length = os fios são curtos demais para ir de um círculo ao outro: escreva um comprimento maior
vertical-distance-between-the-two-ends-of-a-wire = Distância vertical entre as duas extremidades de um fio
the-wires-lean-as-the-body-turns-and-lift-it-j-m-g-r-r-h = Os fios inclinam-se quando o corpo gira e o levantam: J ω² = m g r R/h
moment-of-inertia-of-the-platform-alone = Momento de inércia da plataforma sozinha
period-of-the-platform-alone-from-its-rise-as-it-rotates = período da plataforma sozinha pela sua elevação ao girar
moment-of-inertia-of-the-platform = Momento de inércia da plataforma
the-moment-of-inertia-of-the-platform-with-the-body-is-not-larger-than-that-of-the-platform-alone = o momento de inércia da plataforma com o corpo não é maior que o da plataforma sozinha: confira os períodos
contribution-of-the-body-to-the-platform = Contribuição do corpo à plataforma
period-from-the-rise-of-the-body-as-it-rotates = período pela elevação do corpo ao girar
the-period-with-the-added-inertia-is-not-longer-than-without-it-check-which-is-which = o período com a inércia acrescentada não é maior que sem ela: verifique qual é qual
the-stiffness-is-the-same-j-t-j-j-a-t-a-so-that-j-follows-from-the-two-periods = A rigidez é a mesma: J/T² = (J + J_a)/T_a², de modo que J decorre dos dois períodos
the-stiffness-is-the-same-the-moments-of-inertia-are-proportional-to-the-squares-of-the-periods = A rigidez é a mesma: os momentos de inércia são proporcionais aos quadrados dos períodos
torsional-pendulum-t-4-j-k-t = Pêndulo de torção: T² = 4π² J/k_t
the-properties-of-the-wire-are-missing-write-them = faltam os dados do fio: escreva-os
period-of-the-body-on-the-stiffness-of-the-wire = período do corpo na rigidez do fio
torsional-stiffness-of-the-wire = Rigidez torcional do fio
the-body-on-its-wires = O corpo nos seus fios
the-body-on-the-wire = O corpo no fio
the-journal-on-the-concave-rail = O munhão no trilho côncavo
the-journal-on-the-inclined-rail = O munhão no trilho inclinado
# Words that several analyses use
density = Massa específica
modes = Modos

# Topics
stiffness-and-inertia = Rigidez e inércia
harmonic-excitation = Excitação harmônica
isolation-absorbers-and-instruments = Isolamento, absorvedores e instrumentos
shock-and-impact = Choque e impacto
random-vibration-and-earthquakes = Vibração aleatória e sismos
nonlinear-vibration = Vibração não linear
several-degrees-of-freedom = Vários graus de liberdade
strings-beams-and-plates = Cordas, vigas e placas
shafts-and-rotors = Eixos e rotores

### Published cases

# bar_on_two_springs.toml
car-body-bounce-and-pitch = Carroceria de automóvel: salto vertical e arfagem
ansys-mechanical-apdl-verification-manual-vm52-thomson-vibration-theory-and-applications-example-6-7 = ANSYS Mechanical APDL Verification Manual, VM52 (Thomson, Vibration Theory and Applications, exemplo 6.7-1)
the-manual-gives-the-weight-its-mass-is-that-over-32-2-ft-s-its-radius-of-gyration-4-ft = O manual dá o peso; a massa é esse peso sobre 32,2 ft/s², e o raio de giração é de 4 ft.
a-uniform-bar-on-equal-springs-at-its-ends = Barra uniforme sobre molas iguais nas extremidades
bounce-2k-m-pitch-6k-m-without-coupling = Salto vertical ω² = 2k/m, arfagem ω² = 6k/m, sem acoplamento
nodes-of-a-bar-with-unequal-springs = Nós de uma barra com molas desiguais
k-3-k-1-a-b-1-m-j-1-8-12-0-2-and-6-y-4-2 = k₁ = 3, k₂ = 1, a = b = 1, m = J = 1: λ² − 8λ + 12 = 0, λ = 2 e 6; θ/y = (4 − λ)/2
coincident-springs = Molas coincidentes
springs-at-one-point-exert-no-moment-about-it-the-pitch-is-free = Molas num mesmo ponto não exercem momento em relação a ele: a arfagem é livre

# base_excitation.toml
trailer-on-a-wavy-road = Reboque em estrada ondulada
the-springs-are-specified-by-their-static-deflection-no-damping = As molas são definidas pela sua deflexão estática; sem amortecimento.
vehicle-on-a-rough-road = Veículo em estrada irregular
s-s-rao-mechanical-vibrations-ch-3-vehicle-on-a-rough-road = S. S. Rao, Mechanical Vibrations, cap. 3: veículo em estrada irregular
the-source-rounds-the-frequency-of-the-road = a fonte arredonda a frequência da estrada
seismic-mass-at-rest-base-motion-switched-on = Massa sísmica em repouso, início súbito do movimento da base
free-period-of-0-8-s-the-base-motion-is-18-sin-2-t-mm = Período livre de 0,8 s; o movimento da base é 18 sen 2πt mm.
frequency-ratio-2-transmissibility-1-for-all-damping = Razão de frequências √2, transmissibilidade 1 para todo amortecimento
at-r-2-the-transmissibility-is-one-for-any-damping-rao-5th-ed-3-6 = Em r = √2 a transmissibilidade é um para qualquer amortecimento (Rao, 5ª ed., §3.6)
base-motion-switched-on-with-damping = Início súbito do movimento da base, com amortecimento
x-t-of-4-100x-4-100y-with-y-0-01-sin-10t-by-residues-of-the-laplace-transform = x(t) de ẍ + 4ẋ + 100x = 4ẏ + 100y com y = 0,01 sen 10t, por resíduos da transformada de Laplace
n-0-2-at-resonance-tr-1-16-0-4 = ζ = 0,2 na ressonância: TR = √1,16/0,4.
base-motion-at-the-natural-frequency-without-damping = Excitação pela base na frequência natural, sem amortecimento
x-y-2-sin-t-t-cos-t-at-t-the-amplitude-grows-by-y-2-each-second = x = (Y/2)(sen ωt − ωt cos ωt) em ωt = π: a amplitude cresce de Yω/2 a cada segundo
hysteretic-mounts-at-resonance = Coxins histeréticos na ressonância
damped-trailer-on-a-wavy-road = Reboque com amortecimento em estrada ondulada
x-y-k-ic-k-m-ic-with-c-2-km-z-x-y-v-c-2-and-the-largest-x-y-by-newton-s-method = X/Y = (k + icω)/(k − mω² + icω) com c = 2ζ√(km), Z = X − Y; v_c = λωₙ/(2π), e o maior |X/Y| pelo método de Newton
tr-1-tan-1-and-90-at-r-1 = TR = √(1 + η²)/η, tan ψ = 1/η e φ = 90° em r = 1
a-coefficient-without-a-mass = Um coeficiente sem massa
a-damping-coefficient-has-no-meaning-without-a-mass = Um coeficiente de amortecimento não tem significado sem uma massa

# beam_and_springs.toml
mass-on-a-cantilever-and-two-springs = Massa sobre viga em balanço e duas molas
lists-06-08-list-08-question-4 = Listas 06–08, lista 08, questão 4
the-figure-is-lost-the-printed-formula-has-the-cantilever-in-parallel-with-the-spring-of-5e5-n-m-both = A figura se perdeu. A fórmula impressa tem a viga em balanço em paralelo com a mola de 5e5 N/m, e as duas em série com a de 2e5 N/m. O texto impresso diz E = 120 GPa, mas a rigidez que ele dá à viga, 6,05e5 N/m, exige 210 GPa.
n-1-1-6-05e5-5e5-1-2e5-is-1-69e5-n-m-a-digit-was-copied-incorrectly = 1/(1/(6,05e5 + 5e5) + 1/2e5) é 1,69e5 N/m: um algarismo foi copiado errado.
follows-from-the-incorrectly-copied-stiffness-and-from-the-frequency-of-the-force-22-7-rad-s-used = Decorre da rigidez copiada errada e do uso da frequência da força, 22,7 rad/s, no lugar da frequência natural. Os 180 ciclos por minuto contados e o decaimento dão 18,90 rad/s e m = 474,2 kg.
the-decay-ratio-15-1-was-not-used-the-damping-ratio-was-taken-from-1-1-2-with-227-rad-s-instead-of-22 = O decaimento 15:1 não foi usado. O fator de amortecimento foi tirado de ω/ωₙ = 1/√(1 − 2ζ²) com 227 rad/s em vez de 22,7, o que dá ζ² = −72; o sinal foi desprezado. O decremento dá ζ = 0,0716 e c = 1284 N·s/m.
follows-from-12-and-r-0-0832-with-0-0716-and-r-22-7-18-90-the-force-on-the-support-is-2-14-times-the = Decorre de ζ = 12 e r = 0,0832. Com ζ = 0,0716 e r = 22,7/18,90 a força no apoio é 2,14 vezes a força na massa, qualquer que seja a interpretação da figura perdida.
the-cantilever-of-question-4-alone = Só a viga em balanço da questão 4
the-printed-stiffness-of-the-beam-is-right-with-e-210-gpa = A rigidez impressa da viga está certa, com E = 210 GPa.
question-4-corrected = Questão 4, corrigida
lists-06-08-list-08-question-4-solved-with-k-1-1-k-4-d-1 = Listas 06–08, lista 08, questão 4, resolvida com k = 1/Σ(1/k), ζ = δ/√(4π² + δ²), ωₙ = ω_d/√(1 − ζ²)
seven-amplitudes-read-as-seven-cycles = Sete amplitudes lidas como sete ciclos
lists-06-08-list-08-question-4-another-reading = Listas 06–08, lista 08, questão 4, outra leitura
the-transmissibility-changes-by-one-per-cent-only = A transmissibilidade muda apenas um por cento.
the-figure-read-as-the-cantilever-beside-two-springs-in-series = A figura lida como a viga em balanço ao lado de duas molas em série
mass-and-damping-scale-with-the-stiffness-the-transmissibility-does-not-change = Massa e amortecimento variam com a rigidez; a transmissibilidade não muda.
e-120-gpa-as-printed = E = 120 GPa, como impresso
three-springs-in-series-in-parallel-with-two-more = Três molas em série, em paralelo com outras duas
the-mass-that-gives-10-hz-without-damping = A massa que dá 10 Hz sem amortecimento.
reed-of-a-tachometer-tuned-to-1800-cycles-a-minute = Lâmina de um tacômetro sintonizada em 1800 ciclos por minuto
a-thin-cantilever-of-rectangular-section-without-damping = Uma viga em balanço delgada, de seção retangular, sem amortecimento.
three-helical-springs-of-a-truck-in-parallel = Três molas helicoidais de um caminhão em paralelo
s-s-rao-mechanical-vibrations-si-ed-2017-ex-1-5 = S. S. Rao, Mechanical Vibrations, ed. SI, 2017, ex. 1.5
only-the-stiffness-is-asked-for-frequency-and-decay-are-computed-values = Pede-se apenas a rigidez; a frequência e o decaimento são valores calculados.
undamped-mass-excited-at-its-natural-frequency = Massa sem amortecimento excitada na sua frequência natural
no-steady-state-exists-rao-5th-ed-3-3 = Não existe regime permanente (Rao, 5ª ed., §3.3)

# beam_vibration.toml
cantilever-roots-of-cos-cosh-1-rao-5th-ed-8-5 = Viga em balanço, raízes de cos β cosh β = −1 (Rao, 5ª ed., §8.5)
a-steel-strip-of-1-m-40-mm-by-10-mm-f-1-875104-2-ei-m-l-8-3819-hz = Uma lâmina de aço de 1 m, de 40 mm por 10 mm: f₁ = 1,875104²/(2π)·√(EI/(m̄L⁴)) = 8,3819 Hz.
pinned-and-free-beam = Viga apoiada e livre
code-aster-validation-manual-document-v2-05-400-roots-of-a-beam-pinned-at-one-end-and-free-at-the = Code_Aster, manual de validação, documento v2.05.400, raízes de uma viga apoiada numa extremidade e livre na outra
the-rigid-body-rotation-of-the-beam-about-its-pin-is-not-counted = A rotação de corpo rígido da viga em torno da sua articulação não é contada.
roots-of-cos-cosh-1-rao-5th-ed-8-5 = Raízes de cos β cosh β = 1 (Rao, 5ª ed., §8.5)
free-beam = Viga livre
roots-of-cos-cosh-1-nodes-of-the-first-mode-rao-5th-ed-8-5 = Raízes de cos β cosh β = 1; nós do primeiro modo (Rao, 5ª ed., §8.5)
the-same-roots-as-for-clamped-at-both-ends-preceded-by-two-rigid-body-modes-the-nodes-of-the-first = As mesmas raízes da viga biengastada, precedidas por dois modos de corpo rígido. Os nós do primeiro modo estão a 0,2242 do comprimento a partir de cada extremidade.
roots-of-tan-tanh-rao-5th-ed-8-5 = Raízes de tan β = tanh β (Rao, 5ª ed., §8.5)
pinned-bar-under-compression = Barra biapoiada sob compressão
s-timoshenko-vibration-problems-in-engineering-art-59-target-of-the-verification-problem-vm59-of = S. Timoshenko, Vibration Problems in Engineering, art. 59; valor de referência do problema de verificação VM59 do Ansys Mechanical APDL
a-bar-of-2-in-by-2-in-and-80-in-under-40000-lbf-density-0-000727973-lbf-s-in = Uma barra de 2 in por 2 in e 80 in sob 40000 lbf; massa específica de 0,000727973 lbf·s²/in⁴.
the-target-value-is-truncated-after-17-0558-instead-of-rounded = o valor de referência está truncado depois de 17,0558 em vez de arredondado
the-target-value-is-truncated-after-105-3258-instead-of-rounded = o valor de referência está truncado depois de 105,3258 em vez de arredondado
short-pinned-beam-in-bending = Viga biapoiada curta em flexão
code-aster-validation-manual-v2-test-sdll01-bending-modes = Code_Aster, manual de validação V2, teste SDLL01, modos de flexão
n-1-m-long-0-2-m-deep-0-1-m-wide-the-shear-coefficient-is-1-1-17692 = 1 m de comprimento, 0,2 m de altura, 0,1 m de largura; o coeficiente de cisalhamento é 1/1,17692.
the-manual-truncates-the-series-of-timoshenko-s-frequency-equation = o manual trunca a série da equação das frequências de Timoshenko
the-manual-truncates-the-series-of-timoshenko-s-frequency-equation-its-own-finite-elements-give-4370 = o manual trunca a série da equação das frequências de Timoshenko; os seus próprios elementos finitos dão 4370,8 Hz
deep-square-beam-in-bending = Viga alta de seção quadrada em flexão
nafems-test-fv5-bending-modes-target-in-the-verification-problem-vmp09-t5-of-ansys-mechanical-apdl = NAFEMS, teste FV5, modos de flexão; valor de referência no problema de verificação VMP09-T5 do Ansys Mechanical APDL
n-10-m-long-and-2-m-by-2-m-simply-supported-the-shear-coefficient-is-taken-as-5-6 = 10 m de comprimento e 2 m por 2 m, biapoiada; o coeficiente de cisalhamento é tomado como 5/6.
the-target-lies-0-1-above-the-exact-root-of-timoshenko-s-equation-with-5-6 = o valor de referência fica 0,1 % acima da raiz exata da equação de Timoshenko com κ = 5/6
the-target-lies-0-25-above-the-exact-root-of-timoshenko-s-equation-with-5-6 = o valor de referência fica 0,25 % acima da raiz exata da equação de Timoshenko com κ = 5/6
the-target-lies-0-4-above-the-exact-root-of-timoshenko-s-equation-with-5-6 = o valor de referência fica 0,4 % acima da raiz exata da equação de Timoshenko com κ = 5/6
cantilever-with-a-heavy-mass-at-its-tip = Viga em balanço com massa pesada na ponta
n-3ei-l-m-33-140-m-b-rao-5th-ed-2-5 = ω² = 3EI/(L³(m + 33/140 m_b)) (Rao, 5ª ed., §2.5)
the-effective-mass-of-the-cantilever-33-140-is-that-from-the-static-deflection-exact-in-the-limit-of = A massa efetiva da viga em balanço, 33/140, é a da deflexão estática: exata no limite de uma massa grande na ponta. E I = 700 N·m², 100 kg na ponta de uma viga de 3,12 kg.
continuous-beam-over-three-supports = Viga contínua sobre três apoios
symmetry-the-first-mode-of-two-equal-spans-is-that-of-one-span-pinned-at-both-ends-the-second-that-of = Simetria: o primeiro modo de dois vãos iguais é o de um vão biapoiado, o segundo o de um vão engastado no apoio do meio
beam-on-an-elastic-foundation-under-tension = Viga sobre fundação elástica sob tração
n-n-l-n-ei-k-l-ei-for-a-beam-pinned-at-both-ends-timoshenko-arts-59-60 = λ = (nπ)⁴ + N L²(nπ)²/(EI) + k L⁴/(EI) para uma viga biapoiada (Timoshenko, arts. 59–60)
e-i-2-kn-m-n-20-kn-k-200-kn-m-over-1-m-10-100-296-105 = E I = 2 kN·m², N = 20 kN, k = 200 kN/m² em 1 m: λ₁ = π⁴ + 10π² + 100 = 296,105.
compression-beyond-the-buckling-load = Compressão além da carga de flambagem
euler-s-buckling-load-ei-l-19-74-kn = Carga de flambagem de Euler π²EI/L² = 19,74 kN
round-shaft-on-two-pins = Eixo redondo sobre dois apoios
f-2-e-d-4l = f₁ = π/2·√(E/ρ)·d/(4L²)
e-5000-m-s-f-2-5000-0-0125-hz = √(E/ρ) = 5000 m/s: f₁ = π/2·5000·0,0125 Hz.

# beam_with_tip_body.toml
cantilever-with-two-eccentric-masses = Viga em balanço com duas massas excêntricas
nafems-test-fv4-targets-in-the-verification-problem-vmp09-t4-of-ansys-mechanical-apdl = NAFEMS, teste FV4; valores de referência no problema de verificação VMP09-T4 do Ansys Mechanical APDL
n-10-m-of-round-bar-10000-kg-at-2-m-and-1000-kg-at-2-m-across-the-axis-on-rigid-arms-without-shear = 10 m de barra circular, 10000 kg a +2 m e 1000 kg a −2 m transversalmente à linha de centro, em braços rígidos. Sem cisalhamento e sem inércia de rotação as frequências são as de elementos de pórtico convergidos: 1,723278; 1,726843; 7,413388; 9,974768; 18,1816 e 26,9855 Hz.
the-target-value-lies-between-the-theories-of-euler-bernoulli-9-975-hz-and-timoshenko-9-947-hz = o valor de referência fica entre as teorias de Euler–Bernoulli, 9,975 Hz, e de Timoshenko, 9,947 Hz
the-target-value-lies-between-the-theories-of-euler-bernoulli-18-182-hz-and-timoshenko = o valor de referência fica entre as teorias de Euler–Bernoulli, 18,182 Hz, e de Timoshenko
the-target-value-lies-between-the-theories-of-euler-bernoulli-26-985-hz-and-timoshenko-26-687-hz = o valor de referência fica entre as teorias de Euler–Bernoulli, 26,985 Hz, e de Timoshenko, 26,687 Hz
eccentric-masses-by-frame-elements = Massas excêntricas por elementos de pórtico
converged-frame-model-of-euler-bernoulli-elements-with-consistent-masses = Modelo de pórtico convergido, de elementos de Euler–Bernoulli com massas consistentes
tip-body-of-negligible-mass = Corpo na ponta com massa desprezível
cantilever-1-875104-and-4-694091-in-both-planes-torsion-c-4l = Viga em balanço: β = 1,875104 e 4,694091 nos dois planos; torção c/(4L)
n-1-m-of-round-bar-100-mm-ei-m-125-m-s-69-95-hz-twice-438-4-hz-twice-torsion-g-4-775-22-hz = 1 m de barra circular, 100 mm: √(EI/m̄) = 125 m²/s; 69,95 Hz duas vezes, 438,4 Hz duas vezes, torção √(G/ρ)/4 = 775,22 Hz.
strip-with-an-eccentric-mass = Lâmina com uma massa excêntrica
exact-stiffness-at-the-tip-verified-by-the-balance-of-the-forces-there = Rigidez exata na ponta; verificada pelo equilíbrio das forças nela
a-tube-without-a-wall = Um tubo sem parede
the-inner-diameter-must-be-below-the-outer-one = O diâmetro interno deve ser menor que o externo

# coulomb_damping.toml
amplitude-of-50-mm-to-be-halved = Amplitude de 50 mm a reduzir à metade
n-5-kg-on-980-n-m-with-0-025-and-g-9-81-m-s-the-printed-solution-counts-whole-cycles = 5 kg sobre 980 N/m com µ = 0,025 e g = 9,81 m/s²; a solução impressa conta ciclos inteiros.
block-pulled-by-an-inch-after-0-09-s = Bloco puxado uma polegada, após 0,09 s
f-s-tse-i-e-morse-and-r-t-hinkle-mechanical-vibrations-p-175-target-of-the-verification-problem-vm73 = F. S. Tse, I. E. Morse e R. T. Hinkle, Mechanical Vibrations, p. 175; valor de referência do problema de verificação VM73 do Ansys Mechanical APDL
the-block-on-its-return-after-0-102-s = O bloco no retorno, após 0,102 s
the-block-after-nearly-a-cycle-0-183-s = O bloco após quase um ciclo, 0,183 s
the-block-at-rest = O bloco em repouso
n-1-1-16-1-8-7-5-strokes-rounded-up-x-r-1-8-8-in = n = (1 − 1/16)/(1/8) = 7,5 cursos, arredondado para cima; x_R = ∓(1 − 8/8) in
impulse-against-friction = Impulso contra o atrito
r-f-v-f-2-mm-v-20-mm-then-2f-4-mm-per-half-cycle = R = √(f² + (v₀/ωₙ)²), f = 2 mm, v₀/ωₙ = 20 mm; depois 2f = 4 mm por meio ciclo
friction-beside-viscous-damping = Atrito ao lado de amortecimento viscoso
x-q-x-f-1-q-f-2-mm-0-1-from-50-mm = Xₙ₊₁ = q Xₙ − f (1 + q), f = 2 mm, ζ = 0,1, a partir de 50 mm
friction-identified-from-the-decay = Atrito identificado pelo decaimento
f-k-x-4-f-m-g-the-numbers-of-grover-s-ex-3-6-1-backwards = F = k ΔX/4, µ = F/(m g): os números do ex. 3.6.1 de Grover, ao contrário
viscous-damping-above-critical = Amortecimento viscoso acima do crítico
the-mass-approaches-f-k-2-mm-without-oscillation = A massa tende a F/k = 2 mm sem oscilar
a-spring-too-weak-for-the-friction = Mola fraca demais para o atrito
k-x-0-1-n-is-below-f-0-2-n = k x₀ = 0,1 N está abaixo de F = 0,2 N

# torsional_friction.toml
a-pulley-of-25-kg-m-on-a-steel-shaft-of-1-m-and-50-mm-a-friction-torque-of-400-n-m-twisted-by-6-and = Uma polia de 25 kg·m² num eixo de aço de 1 m e 50 mm, um torque de atrito de 400 N·m, torcida de 6° e solta.
a-shaft-too-weak-for-the-friction = Eixo fraco demais para o atrito
disc-struck-against-a-brake-shoe = Disco golpeado contra uma sapata de freio
friction-torque-beside-viscous-damping = Torque de atrito ao lado de amortecimento viscoso
friction-torque-identified-from-the-decay = Torque de atrito identificado pelo decaimento
pulley-on-a-shaft-with-a-band-brake = Polia num eixo com freio de cinta
r-f-f-2-mrad-20-mrad-then-2-f-4-mrad-per-half-cycle = R = √(θ_f² + (Ω₀/ωₙ)²), θ_f = 2 mrad, Ω₀/ωₙ = 20 mrad; depois 2θ_f = 4 mrad por meio ciclo
s-s-rao-mechanical-vibrations-ch-2-example-on-a-pulley-with-coulomb-damping = S. S. Rao, Mechanical Vibrations, cap. 2, exemplo de uma polia com amortecimento de Coulomb
t-f-0-2-10-0-1-0-2-n-m-k-t-100-n-m-rad-j-8-1-8-1-kg-m = T_f = 0,2·10·0,1 = 0,2 N·m, k_t = 100 N·m/rad, J = 8·1²/8 = 1 kg·m².
the-body-approaches-t-f-k-t-2-mrad-without-oscillation = O corpo tende a T_f/k_t = 2 mrad sem oscilar
viscous-torsional-damping-above-critical = Amortecimento viscoso torcional acima do crítico
k-t-0-1-n-m-is-below-t-f-0-2-n-m = k_t θ₀ = 0,1 N·m está abaixo de T_f = 0,2 N·m
q-f-1-q-f-2-mrad-0-1-from-50-mrad = Θₙ₊₁ = q Θₙ − θ_f (1 + q), θ_f = 2 mrad, ζ = 0,1, a partir de 50 mrad
t-f-k-t-4-980-0-00500510204-4-n-m-below-25-mrad-after-five-periods-of-2-14-s = T_f = k_t ΔΘ/4: 980·0,00500510204/4 N·m; abaixo de 25 mrad após cinco períodos de 2π/14 s

# coupled_pendulums.toml
two-rods-joined-at-their-free-ends = Duas barras unidas nas suas extremidades livres
rods-of-5-kg-m-and-0-75-m-and-1-m-without-gravity-the-other-mode-is-a-rotation-of-both-with-the = Barras de 5 kg/m com 0,75 m e 1 m; sem gravidade, o outro modo é um giro das duas com a mola indeformada.
the-exact-ratio-is-9-16-0-5625 = a razão exata é −9/16 = −0,5625
two-equal-pendulums-in-phase-and-in-antiphase = Dois pêndulos iguais: em fase e em oposição
g-l-g-l-2ka-ml = ω₁² = g/l, ω₂² = g/l + 2ka²/(ml²)
two-inverted-pendulums = Dois pêndulos invertidos
in-phase-the-spring-has-no-effect-k-k-mgl-0 = Em fase a mola não tem efeito: K₁₁ + K₁₂ = −mgl < 0

# damped_absorber.toml
mass-ratio-of-one-twentieth-by-the-fixed-points = Razão de massas de um vigésimo, pelos pontos fixos
j-p-den-hartog-mechanical-vibrations-4th-ed-3-3-f-1-1-3-8-1-h-1-2-g-1-2-1 = J. P. Den Hartog, Mechanical Vibrations, 4ª ed., §3.3: f = 1/(1 + μ), γ² = 3μ/(8(1 + μ)³), H = √(1 + 2/μ), g² = (1 ∓ √(μ/(2 + μ)))/(1 + μ)
c-2-m-a-m-and-a-c-2-m-a-a-differ-by-the-tuning-the-true-peak-with-these-values-lies-0-08-above-the = γ = c/(2 m_a ω_m) e ζ_a = c/(2 m_a ω_a) diferem pela sintonia. O pico verdadeiro com estes valores fica 0,08 % acima dos pontos fixos.
mass-ratio-of-one-twentieth-for-the-lowest-peak = Razão de massas de um vigésimo, para o menor pico
direct-minimisation-of-the-maximum-magnification-over-tuning-and-damping = Minimização direta da amplificação máxima em relação à sintonia e ao amortecimento
tuning-and-damping-differ-by-0-001-and-0-24-from-the-fixed-point-values-the-peak-falls-from-6-408443 = Sintonia e amortecimento diferem 0,001 % e 0,24 % dos valores dos pontos fixos; o pico cai de 6,408443 para 6,40792. Um mínimo é achatado: uma busca direta encontra o pico com precisão total, mas a sintonia e o amortecimento só com poucos algarismos. O segundo método é a forma fechada de Nishihara e Asami.
found-by-a-direct-search-where-the-minimum-is-flat = encontrado por uma busca direta, onde o mínimo é achatado
untuned-viscous-damper-with-as-much-inertia-as-the-main-system = Amortecedor viscoso não sintonizado, com inércia igual à do sistema principal
automotive-chassis-engineering-p-289 = Automotive Chassis Engineering, p. 289
houdaille-damper-the-optimum-damping-is-1-12-relative-to-the-main-frequency-and-the-peak-1-2-3 = Amortecedor de Houdaille. O amortecimento ótimo é 1/√12 em relação à frequência principal, e o pico é 1 + 2/μ = 3.
the-book-truncates-the-digits-of-0-28868 = o livro trunca os algarismos de 0,28868
the-same-damper-by-its-closed-form = O mesmo amortecedor pela sua fórmula fechada
n-1-2-1-2-1-12-g-2-3-h-1-2 = γ = 1/√(2(1 + μ)(2 + μ)) = 1/√12, g = √(2/3), H = 1 + 2/μ
lowest-peak-with-5-3 = O menor pico com μ = 5/3
nishihara-and-asami-with-s-4-3-3-f-6-43-a-165-40-h-43-3-275-3 = Nishihara e Asami com s = √(4 + 3μ) = 3: f = √(6/43), ζ_a = ¼√(165/40), H = 43/(3√(275/3))
building-with-an-absorber-of-given-tuning-and-damping = Edifício com absorvedor de sintonia e amortecimento dados
f-1-0-1-0-1-at-g-1-x-x-st-2i-1-2i-s-1-1-2i = f = 1, γ = 0,1, μ = 0,1 em g = 1: X/X_st = |2iγ/(−μ(1 + 2iγ))|, S = 1/(μ|1 + 2iγ|)
an-absorber-as-heavy-as-its-main-system-damped-by-the-main-frequency = Absorvedor tão pesado quanto o sistema principal, com amortecimento referido à frequência principal
n-1-f-1-2-1-4-at-g-1-1-4-i-2-numerator-3-4-i-2 = μ = 1, f = 1/2, γ = 1/4 em g = 1: Δ = −1/4 − i/2, numerador = −3/4 + i/2
viscous-damper-with-a-given-coefficient = Amortecedor viscoso com coeficiente dado
n-1-2-1-4-at-the-fixed-point-g-2-2-0-8-h-1-2-5-for-every-damping = μ = 1/2, γ = 1/4 no ponto fixo g² = 2/(2 + μ) = 0,8: H = 1 + 2/μ = 5 para qualquer amortecimento
a-damped-main-system = Sistema principal amortecido
a-main-system-with-2-damping-and-an-absorber-with-5-of-its-mass = Um sistema principal com 2 % de amortecimento e um absorvedor com 5 % da sua massa.
main-system-with-too-much-damping = Sistema principal com amortecimento excessivo
with-0-9-the-response-of-the-main-system-has-no-peak-and-a-light-absorber-does-not-produce-two = Com ζ = 0,9 a resposta do sistema principal não tem pico, e um absorvedor leve não produz dois

# decay_identification.toml
amplitudes-that-halve-in-every-cycle = Amplitudes que caem à metade em cada ciclo
x-80-mm-2-n-ln-2 = X = 80 mm · 2^(−n): δ = ln 2
amplitudes-that-decrease-by-equal-steps = Amplitudes que diminuem em passos iguais
x-50-mm-4n-f-k-with-f-k-1-25-mm-f-k-g = X = 50 mm − 4n F/k com F/k = 1,25 mm; µ = (F/k) ωₙ²/g
near-the-numbers-of-grover-s-ex-3-6-1-5-kg-on-980-n-m = Próximo dos números do ex. 3.6.1 de Grover: 5 kg sobre 980 N/m.
viscous-and-coulomb-damping-by-the-turning-points = Amortecimento viscoso e de Coulomb, pelos pontos de retorno
x-q-x-f-f-in-each-half-cycle-0-02-f-0-5-mm-from-50-mm = Xₙ₊₁ = q (Xₙ − f) − f em cada meio ciclo, ζ = 0,02, f = 0,5 mm, a partir de 50 mm
viscous-and-coulomb-damping-by-samples-of-the-motion = Amortecimento viscoso e de Coulomb, por amostras do movimento
exact-motion-half-cycle-by-half-cycle-with-0-02-f-k-0-5-mm-and-10-rad-s-released-at-50-mm-sampled-at = Movimento exato, meio ciclo a meio ciclo, com ζ = 0,02, F/k = 0,5 mm e ωₙ = 10 rad/s, solto a 50 mm; 60 amostras por segundo
the-turning-points-lie-between-the-samples-a-parabola-through-three-of-them-finds-each-to-a-few = Os pontos de retorno ficam entre as amostras: uma parábola por três delas encontra cada um com erro de alguns milésimos.
the-turning-points-lie-between-the-samples = os pontos de retorno ficam entre as amostras
three-amplitudes = Três amplitudes
with-two-parameters-in-each-fit-too-few-data-remain-to-distinguish-them = Com dois parâmetros em cada ajuste, restam poucos dados para distingui-los

# double_pendulum.toml
two-equal-small-masses-on-equal-strings = Duas pequenas massas iguais em fios iguais
n-2-2-g-l-angles-in-the-ratio-2 = ω² = (2 ∓ √2) g/l, ângulos na razão ±√2
n-1-kg-and-1-m-each = 1 kg e 1 m em cada um.
two-equal-rods = Duas barras iguais
n-3-6-7-g-l-angles-in-the-ratio-2-7-1-3 = ω² = (3 ∓ 6/√7) g/l, ângulos na razão (±2√7 − 1)/3
n-0-8557-g-l-and-2-2953-g-l = 0,8557 √(g/l) e 2,2953 √(g/l).
a-body-that-is-a-small-mass-on-a-string = Um corpo que é uma pequena massa num fio
a-body-with-zero-moment-of-inertia-is-a-point-mass-2-2-g-l-angles-in-the-ratio-2 = Um corpo com momento de inércia nulo é uma massa pontual: ω² = (2 ∓ √2) g/l, ângulos na razão ±√2
a-light-pendulum-under-a-heavy-one = Pêndulo leve sob um pêndulo pesado
with-m-much-smaller-than-m-each-oscillates-independently-g-l = Com m₂ muito menor que m₁ cada um oscila por si: √(g/l)
a-millionth-of-the-mass-l-2-5-m-l-0-4-m-g-10-m-s = Um milionésimo da massa; l₁ = 2,5 m, l₂ = 0,4 m, g = 10 m/s².
body-with-its-centre-of-mass-above-the-pivot = Corpo com o centro de massa acima do pivô
k-m-c-m-l-g-0 = K₁₁ = (m₁c₁ + m₂l₁) g < 0

# drop_impact.toml
block-dropped-on-a-sprung-pan = Bloco que cai sobre um prato com mola
f-p-beer-and-e-r-johnston-vector-mechanics-for-engineers-p-635-target-of-the-verification-problem = F. P. Beer e E. R. Johnston, Vector Mechanics for Engineers, p. 635; valor de referência do problema de verificação VME2 do Ansys Mechanical APDL
the-pan-is-at-rest-on-its-spring-the-impact-is-perfectly-plastic-g-9-81-m-s = O prato está em repouso sobre a sua mola; o choque é perfeitamente plástico. g = 9,81 m/s².
package-on-its-cushion = Produto na sua embalagem
w-t-thomson-vibration-theory-and-applications-ex-4-6-1-target-of-the-verification-problems-vm65-and = W. T. Thomson, Vibration Theory and Applications, ex. 4.6-1; valor de referência dos problemas de verificação VM65 e VM81 do Ansys Mechanical APDL
distances-are-measured-from-the-release-1-in-above-the-cushion-g-386-in-s = As distâncias são medidas a partir da soltura, 1 in acima da embalagem; g = 386 in/s².
the-printed-speed-is-rounded-up-2-386-27-785 = a velocidade impressa está arredondada para cima: √(2·386) = 27,785
the-printed-value-is-truncated-not-rounded = o valor impresso está truncado, não arredondado
the-printed-time-is-that-of-the-nearest-time-step = o tempo impresso é o do passo de tempo mais próximo
the-printed-value-comes-from-time-steps = o valor impresso vem de uma integração com passos de tempo
the-package-by-energy = O produto, por energia
mg-h-y-ky-2-y-2-h = mg(h + y) = ky²/2: y = δ + √(δ² + 2δh)
suddenly-applied-load = Carga aplicada subitamente
a-load-released-from-zero-height-compresses-a-spring-to-twice-the-static-deflection = Uma carga solta de altura zero comprime a mola o dobro da deflexão estática
a-cushion-with-damping = Embalagem com amortecimento
runge-kutta-integration-of-m-c-k-y-m-g = Integração de Runge–Kutta de m ÿ + c ẏ + k y = m g
the-package-after-its-rebound = O produto após o ressalto
without-damping-the-cushion-throws-the-package-back = Sem amortecimento a embalagem lança o produto de volta

# duffing_oscillator.toml
hardening-spring-released-at-1-in = Mola com enrijecimento, solta a 1 in
ansys-mechanical-apdl-verification-manual-vm156-natural-frequency-of-a-nonlinear-spring-mass-system = ANSYS Mechanical APDL Verification Manual, VM156 (frequência natural de um sistema massa–mola não linear)
the-target-was-read-from-a-transient-of-finite-steps-the-elliptic-integral-gives-0-14404-s = o valor de referência foi lido de uma resposta transitória com passos finitos; a integral elíptica dá 0,14404 s
the-same-spring-by-the-elliptic-integral-and-by-harmonic-balance = A mesma mola pela integral elíptica e pelo balanço harmônico
t-4k-with-6-0-002588-s-1-3-t-2-0-002588-5-and-their-relative-difference = T = 4K(κ)/Ω com Ω² = 6/0,002588 s⁻², κ² = 1/3; T′ = 2π√(0,002588/5), e a diferença relativa entre eles
forced-at-the-peak-of-its-response-smaller-force = Forçada no pico da resposta, força menor
ansys-mechanical-apdl-verification-manual-vm319-forced-duffing-oscillator-f-m-125-mm-s = ANSYS Mechanical APDL Verification Manual, VM319 (oscilador de Duffing forçado), F/m = 125 mm/s²
n-200-x-46-752-x-125-cos-t-in-mm-and-s-with-8766-2-s-for-a-mass-of-1-kg = ẍ + (ω₀/200) ẋ + ω₀² x + 46,752 x³ = 125 cos ωt em mm e s, com ω₀² = 8766,2 s⁻², para uma massa de 1 kg.
printed-to-two-digits = impresso com dois algarismos
forced-at-the-peak-of-its-response-larger-force = Forçada no pico da resposta, força maior
ansys-mechanical-apdl-verification-manual-vm319-forced-duffing-oscillator-f-m-250-mm-s = ANSYS Mechanical APDL Verification Manual, VM319 (oscilador de Duffing forçado), F/m = 250 mm/s²
the-printed-peak-is-read-from-a-stepped-sweep = o pico impresso é lido de uma varredura em passos
a-softening-spring-at-its-limit = Mola que amolece, no seu limite
k-h-a-the-spring-exerts-no-restoring-force = k = |h| A²: a mola não exerce força restauradora
small-amplitudes-are-linear = Pequenas amplitudes são lineares
t-2-m-k = T = 2π√(m/k)

# engine_orders.toml
six-cylinders-with-damper-pulley-and-flywheel = Seis cilindros com polia amortecedora e volante
eigenvalues-of-the-assembled-matrices-by-jacobi-s-rotations-sums-of-the-phase-vectors-as-complex = Autovalores das matrizes montadas por rotações de Jacobi, somas dos fasores como exponenciais complexas
four-stroke-firing-order-1-5-3-6-2-4-orders-3-6-9-and-12-are-major-orders-all-cylinders-act-in-phase = Quatro tempos, ordem de ignição 1-5-3-6-2-4. As ordens harmônicas 3, 6, 9 e 12 são principais: todos os cilindros agem em fase.
one-cylinder-and-its-flywheel = Um cilindro e o seu volante
k-j-j-j-j-t-j-j-j-with-an-amplitude-of-j-j-of-the-flywheel = ω = √(k (J₁ + J₂)/(J₁ J₂)), Θ₀ = T/(ω² (J₁ + J₁²/J₂)), com uma amplitude de −J₁/J₂ do volante
one-cylinder-every-order-is-major-and-the-sum-of-the-phase-vectors-is-one = Um só cilindro: toda ordem é principal e a soma dos fasores é um.
tangential-pressure-and-damping-at-the-crank = Pressão tangencial, e amortecimento na manivela
t-c-for-one-cylinder-t-p-b-s-8 = Θ = T/(c ω) para um cilindro, T = p π B² S/8
two-cylinders-vibrating-in-antiphase = Dois cilindros vibrando em oposição de fase
n-2k-j-amplitudes-1-and-1-cylinders-half-a-revolution-apart-reinforce-each-other-at-odd-orders-and = ω = √(2k/J), amplitudes 1 e −1: cilindros defasados de meia volta se reforçam nas ordens ímpares e se cancelam nas pares
the-even-orders-are-the-major-orders-and-harmless-in-this-mode-the-two-cranks-move-in-antiphase = As ordens harmônicas pares são as principais, e inofensivas: neste modo as duas manivelas movem-se em oposição de fase.
v8-with-a-cross-plane-crankshaft = V8 com virabrequim em cruz
two-cylinders-on-each-crank-firing-every-90-order-4-is-major-order-2-vanishes-in-every-mode = Dois cilindros em cada manivela, com ignição a cada 90°. A ordem 4 é principal; a ordem 2 anula-se em todos os modos.
stiffness-of-a-throw-by-two-formulas = Rigidez de um cotovelo por duas fórmulas
carter-l-0-8t-d-0-75l-c-d-c-d-c-1-5r-tw-ker-wilson-l-0-4d-d-l-c-0-4d-c-d-c-d-c-r-0-2-d-d-c-tw-as-in-w = Carter: (Lⱼ + 0,8t)/Dⱼ⁴ + 0,75L_c/(D_c⁴ − d_c⁴) + 1,5R/(tW³); Ker Wilson: (Lⱼ + 0,4Dⱼ)/Dⱼ⁴ + (L_c + 0,4D_c)/(D_c⁴ − d_c⁴) + (R − 0,2(Dⱼ + D_c))/(tW³), como em W. Ker Wilson, Practical Solution of Torsional Vibration Problems
half-orders-of-a-two-stroke-engine = Meias ordens de um motor de dois tempos

# equivalent_damping.toml
stiffness-multiplier-below-resonance = Multiplicador da rigidez abaixo da ressonância
x-f-k-m-i-k-in-complex-numbers-c-k-w-kx = X = F₀/(k − mω² + iωβk) em números complexos; c = βk, η = βω, W = πηkX²
structural-damping-at-resonance = Amortecimento estrutural na ressonância
w-t-thomson-vibration-theory-and-applications-art-3-9-target-of-the-verification-problem-vm87-of = W. T. Thomson, Vibration Theory and Applications, art. 3.9; valor de referência do problema de verificação VM87 do Ansys Mechanical APDL
the-stiffness-multiplier-of-the-program-is-0-03-s-so-that-the-loss-factor-at-20-rad-s-is-0-6 = O multiplicador da rigidez no programa é 0,03 s, de modo que o fator de perda a 20 rad/s é 0,6.
the-same-by-its-loss-factor = O mesmo pelo seu fator de perda
x-f-k-at-the-natural-frequency = X = F₀/(ηk) na frequência natural
loop-of-1-2-j-at-20-mm = Laço de 1,2π J a 20 mm
w-kx-0-3-x-f-k-m-k = η = ΔW/(πkX²) = 0,3; X = F₀/√((k − mω²)² + (ηk)²)
drag-with-the-square-of-the-velocity-at-resonance = Arrasto com o quadrado da velocidade, na ressonância
x-3-f-8a-at-the-natural-frequency = X = √(3πF₀/(8aω²)) na frequência natural
spring-without-damping = Mola sem amortecimento
without-damping-the-amplitude-at-resonance-is-unbounded = Sem amortecimento a amplitude na ressonância é ilimitada

# equivalent_stiffness.toml
the-mass-that-has-a-natural-frequency-of-10-hz = A massa que tem uma frequência natural de 10 Hz.
the-mass-at-the-tip-of-a-thin-steel-reed-the-mass-of-the-reed-is-neglected = A massa na ponta de uma lâmina delgada de aço; a massa da lâmina é desprezada.
weight-on-a-reed-tuned-to-50-hz = Peso sobre uma lâmina sintonizada em 50 Hz
a-four-inch-steel-reed-the-weight-is-in-pounds-force-with-g-386-in-s = Uma lâmina de aço de quatro polegadas; o peso está em libras-força, com g = 386 in/s².
weight-of-35-lb-on-a-spring = Peso de 35 lb sobre uma mola
the-weight-is-a-force-g-386-in-s = O peso é uma força; g = 386 in/s².
mass-on-a-spring-in-inches-and-pounds = Massa sobre uma mola, em polegadas e libras
ansys-mechanical-apdl-verification-manual-vm45-w-t-thomson-vibration-theory-and-applications-ex-1-2-2 = ANSYS Mechanical APDL Verification Manual, VM45 (W. T. Thomson, Vibration Theory and Applications, ex. 1.2-2)
disc-on-a-wire = Disco num fio
ansys-mechanical-apdl-verification-manual-vm47-w-t-thomson-vibration-theory-and-applications-ex-1-3-2 = ANSYS Mechanical APDL Verification Manual, VM47 (W. T. Thomson, Vibration Theory and Applications, ex. 1.3-2)
armature-of-a-motor-generator-on-a-short-shaft = Induzido de um motor-gerador num eixo curto
ansys-mechanical-apdl-verification-manual-vm48-w-t-thomson-vibration-theory-and-applications-ex-1-3-3 = ANSYS Mechanical APDL Verification Manual, VM48 (W. T. Thomson, Vibration Theory and Applications, ex. 1.3-3)
torsional-pendulum-on-a-thin-rod = Pêndulo de torção numa haste fina
the-same-solution-prints-22-57-rad-s-which-is-3-59-hz-misplaced-decimal-point = A mesma solução imprime ωₙ = 22,57 rad/s, que são 3,59 Hz: vírgula decimal fora do lugar.
spring-for-a-mass-with-a-period-of-one-second = Mola para uma massa com período de um segundo
code-aster-validation-manual-test-sdld32-v2-01-032 = Code_Aster, manual de validação, teste SDLD32 (V2.01.032)
the-manual-prints-k-m-2-with-2-rad-s-it-is-4-39-48-n-m = O manual imprime k = m ω₀² = 2π; com ω₀ = 2π rad/s são 4π² = 39,48 N/m.
spring-for-a-mass-with-a-period-of-one-second-corrected = Mola para uma massa com período de um segundo, corrigida
k-4-m-t = k = 4π² m/T²
helical-spring-with-mass = Mola helicoidal com massa
k-100-n-m-m-m-s-3-1-kg-10-rad-s = k = 100 N/m, m + m_s/3 = 1 kg: ωₙ = 10 rad/s
spring-acting-through-a-lever-in-series-with-a-spring-at-the-load = Mola que atua por uma alavanca, em série com uma mola na carga
the-spring-of-16-kn-m-at-half-of-the-load-s-arm-is-equivalent-to-4-kn-m-with-4-kn-m-in-series-k-2-kn = A mola de 16 kN/m na metade do braço da carga equivale a 4 kN/m; com 4 kN/m em série k = 2 kN/m
stepped-shaft-with-a-geared-branch = Eixo escalonado com um ramo engrenado
two-equal-lengths-with-diameters-in-the-ratio-1-to-2-have-16-17-of-the-stiffness-of-the-thinner-one-a = Dois trechos iguais com diâmetros na razão de 1 para 2 têm 16/17 da rigidez do mais fino; uma mola atrás de engrenagens de razão 3 é multiplicada por nove
g-j-l-of-the-thin-length-is-80e9-0-02-32-0-5-2513-27-n-m-rad = G J/L do trecho fino é 80e9·π·0,02⁴/32/0,5 = 2513,27 N·m/rad.
body-on-three-wires = Corpo em três fios
trifilar-suspension-t-2-j-l-m-g-r-for-a-ring-hung-at-its-own-radius-t-2-l-g = Suspensão trifilar: T = 2π √(J l/(m g r²)); para um anel suspenso no seu próprio raio T = 2π √(l/g)
a-spring-too-heavy-for-the-frequency = Mola pesada demais para a frequência
the-effective-third-of-the-spring-mass-alone-gives-10-rad-s = O terço efetivo da massa da mola sozinho dá 10 rad/s

# forced_coulomb.toml
force-of-19-6-n-at-5-hz = Força de 19,6 N a 5 Hz
the-book-gives-a-mass-of-8-7-kg-its-numbers-correspond-to-3-7-kg-the-equivalent-damping-gives-the = O livro dá uma massa de 8,7 kg; os seus números correspondem a 3,7 kg. O amortecimento equivalente dá a resposta impressa; a amplitude exata é 8 % maior.
the-exact-motion-at-5-hz = O movimento exato a 5 Hz
x-f-v-k-fu-k-with-the-numbers-of-grover-s-ex-4-6-1-a-time-integration-gives-4-675-mm = X = √((F₀V/k)² − (FU/k)²) com os números do ex. 4.6.1 de Grover; uma integração no tempo dá 4,675 mm
force-for-40-mm-at-2-hz = Força para 40 mm a 2 Hz
s-s-rao-mechanical-vibrations-problem-of-ch-3-on-forced-vibration-with-coulomb-damping = S. S. Rao, Mechanical Vibrations, problema do cap. 3 sobre vibração forçada com amortecimento de Coulomb
the-printed-value-is-computed-from-rounded-numbers-g-9-81-m-s-gives-97-9877-n = o valor impresso é calculado com números arredondados; g = 9,81 m/s² dá 97,9877 N
exact-motion-without-sticking-at-twice-the-natural-frequency = Movimento exato sem adesão no dobro da frequência natural
j-p-den-hartog-forced-vibrations-with-combined-coulomb-and-viscous-friction-1931-v-1-3-u-tan-4-2-1-2 = J. P. Den Hartog, Forced vibrations with combined Coulomb and viscous friction, 1931: V = −1/3, U = tan(π/4)/2 = 1/2 em r = 2
the-force-of-that-motion = A força desse movimento
f-k-1-r-x-f-u-the-inverse-of-the-case-above-by-equivalent-damping-c-eq-4f-x-and-f-k-1-r-x-4f = F₀ = k |1 − r²| √(X² + (f U)²), o inverso do caso acima; pelo amortecimento equivalente c_eq = 4F/(πωX) e F₀ = √((k |1 − r²| X)² + (4F/π)²)
motion-with-stick-slip = Movimento com adesão e deslizamento
slip-and-stick-phases-solved-piecewise-a-time-integration-with-20-s-steps-also-gives-125-159-mm = Fases de deslizamento e aderência resolvidas trecho a trecho; uma integração no tempo com passos de 20 µs também dá 125,159 mm
friction-balances-60-of-the-force-the-mass-is-at-rest-twice-per-cycle = O atrito equilibra 60 % da força; a massa fica em repouso duas vezes por ciclo.
resonance-that-friction-cannot-limit = Ressonância que o atrito não limita
n-4f-1-27-n-is-below-f-10-n = 4F/π = 1,27 N está abaixo de F₀ = 10 N
force-below-the-friction = Força abaixo do atrito
the-mass-does-not-move = A massa não se move

# free_vibration.toml
underdamped-release = Soltura com subamortecimento
w-t-thomson-vibration-theory-and-applications-ex-2-2-1-target-of-the-verification-problem-vm71-of = W. T. Thomson, Vibration Theory and Applications, ex. 2.2-1; valor de referência do problema de verificação VM71 do Ansys Mechanical APDL
a-weight-of-10-lb-on-30-lbf-in-displaced-by-1-in-and-released-0-2 = Um peso de 10 lb sobre 30 lbf/in, deslocado de 1 in e solto; ζ = 0,2.
the-printed-value-is-truncated-the-computed-value-is-0-521085 = o valor impresso está truncado; o valor calculado é -0,521085
overdamped-release = Soltura com superamortecimento
critically-damped-release = Soltura com amortecimento crítico
undamped-release = Soltura sem amortecimento
the-printed-value-is-truncated-the-computed-value-is-0-996885 = o valor impresso está truncado; o valor calculado é -0,996885
natural-frequency-of-rad-s-with-a-tenth-of-critical-damping = Frequência natural de π rad/s com um décimo do amortecimento crítico
code-aster-validation-manual-v2-01-034-test-sdld34 = Code_Aster, manual de validação, V2.01.034, teste SDLD34
a-mass-on-a-spring-released-from-rest-the-undamped-and-damped-natural-frequencies = Uma massa sobre uma mola, solta do repouso; as frequências naturais não amortecida e amortecida.
damping-for-an-overshoot-of-20 = Amortecimento para um sobressinal de 20 %
ln-5-ln-5 = ζ = ln 5/√(π² + (ln 5)²)
damping-for-an-envelope-that-settles-in-half-a-second = Amortecimento para uma envoltória que se acomoda em meio segundo
ln-1-p-t-with-p-2 = ζ = ln(1/p)/(ωₙ tₛ) com p = 2 %
x-v-t-e-t-maximum-v-e-at-1 = x = v₀ t e^(−ωₙt), máximo v₀/(e ωₙ) em 1/ωₙ
torsional-pendulum-with-negative-damping = Pêndulo de torção com amortecimento negativo
e-0-5-s-t-cos-d-t-0-5-d-sin-d-t-with-5-rad-s-0-1 = θ = θ₀ e^(0,5 s⁻¹ t) (cos ω_d t − (0,5/ω_d) sen ω_d t) com ωₙ = 5 rad/s, ζ = −0,1
galloping-lines-and-dry-friction-brakes-have-negative-damping-about-their-equilibrium-position = Linhas de transmissão em galope e freios com atrito seco têm amortecimento negativo em torno da sua posição de equilíbrio.
at-rest-in-the-equilibrium-position = Em repouso na posição de equilíbrio

# frequency_response_identification.toml
frequency-sweep-of-a-vehicle-suspension = Varredura em frequência de uma suspensão de veículo
lists-06-08 = Listas 06–08
exercise-lists-06-07-and-08-course-on-mechanical-vibration = Listas de exercícios 06, 07 e 08, disciplina de vibrações mecânicas
lists-06-08-list-06-question-1 = Listas 06–08, lista 06, questão 1
the-static-value-and-peak-are-read-from-the-printed-curve-the-printed-solution-takes-the-peak = O valor estático e o pico são lidos da curva impressa. A solução impressa toma a frequência do pico como frequência natural, boa aproximação com este amortecimento: m sai 0,8 % e c 0,2 % acima. A amplitude na ressonância, que ela pede, fica sem resposta: 1,6 mm por newton.
the-printed-solution-calls-the-peak-frequency-the-natural-frequency = a solução impressa chama a frequência do pico de frequência natural
the-suspension-by-its-exact-peak-under-100-n = A suspensão pelo seu pico exato, sob 100 N
lists-06-08-list-06-question-1-with-the-peak-at-1-2 = Listas 06–08, lista 06, questão 1, com o pico em ωₙ√(1 − 2ζ²)
the-suspension-as-a-table-of-points = A suspensão como tabela de pontos
n-1-k-m-c-with-k-5000-n-m-m-34-45-kg-c-51-98-n-s-m-to-five-digits-the-spread-of-the-three-readings-of = 1/√((k − m ω²)² + (c ω)²) com k = 5000 N/m, m = 34,45 kg, c = 51,98 N·s/m, com cinco algarismos; a dispersão das três leituras da tabela por NumPy
all-three-readings-should-give-the-same-system = As três leituras devem dar o mesmo sistema.
the-table-is-rounded-to-five-digits = a tabela está arredondada a cinco algarismos
the-half-power-points-lie-between-the-points-of-the-table = os pontos de meia potência ficam entre os pontos da tabela
a-response-without-a-peak = Resposta sem pico
a-peak-is-higher-than-the-static-value-rao-5th-ed-3-4 = Um pico é mais alto que o valor estático (Rao, 5ª ed., §3.4)
a-table-that-ends-at-its-highest-point = Tabela que termina no seu ponto mais alto
a-peak-has-lower-points-on-both-sides = Um pico tem pontos mais baixos dos dois lados
first-mode-of-a-chain-from-three-complex-receptances = Primeiro modo de uma cadeia a partir de três receptâncias complexas
code-aster-validation-manual-sdld21-sdld21a-comm-receptance-of-node-n5-frequency-of-sdld02-damping-c = Code_Aster, manual de validação, SDLD21 (sdld21a.comm): receptância do nó N5; frequência do SDLD02, amortecimento C = 5·10⁻⁴ K
three-points-and-four-unknowns-with-a-real-residual-the-printed-damping-ratio-is-that-of-the-model = Três pontos e quatro incógnitas com um resíduo real. O fator de amortecimento impresso é o do modelo; os pontos têm cinco algarismos e vestígios de sete outros modos.
three-points-of-five-digits-and-modes-that-a-constant-residual-does-not-follow = três pontos de cinco algarismos, e modos que um resíduo constante não acompanha
the-nyquist-circle-of-the-same-three-receptances = O círculo de Nyquist das mesmas três receptâncias
code-aster-validation-manual-sdld21-sdld21a-comm-three-points-of-node-n5-the-circle-through-three = Code_Aster, manual de validação, SDLD21 (sdld21a.comm): três pontos do nó N5; o círculo por três pontos é único; a dispersão das três leituras por SciPy
a-mobility-by-amplitude-and-phase = Mobilidade por amplitude e fase
i-k-m-ic-with-m-2-kg-10-hz-and-0-02-to-six-digits = iω/(k − mω² + icω) com m = 2 kg, 10 Hz e ζ = 0,02, com seis algarismos
all-readings-should-give-the-same-mode = Todas as leituras devem dar o mesmo modo.
hysteretic-mode-with-residual-stiffness-of-other-modes = Modo histerético com rigidez residual dos outros modos
n-1-k-1-0-04i-m-2-10-m-n-with-m-2-kg-and-10-hz-to-six-digits-the-spread-of-the-three-readings-by = 1/(k(1 + 0,04i) − mω²) + 2·10⁻⁶ m/N com m = 2 kg e 10 Hz, com seis algarismos; a dispersão das três leituras por SciPy
the-residual-shifts-the-circle-away-from-the-origin-without-changing-its-diameter-1-k = O resíduo desloca a circunferência da origem sem alterar o seu diâmetro 1/(ηk).
the-residual-is-a-thousandth-of-the-peak-and-the-table-has-six-digits = o resíduo é um milésimo do pico, e a tabela tem seis algarismos
an-accelerance-with-decimal-commas-out-of-order = Acelerância com vírgulas decimais, fora de ordem
k-m-ic-10-m-n-with-m-5-kg-25-hz-and-0-05-to-six-digits-the-spread-of-the-three-readings-by-scipy = −ω²/(k − mω² + icω) − ω²·10⁻⁶ m/N com m = 5 kg, 25 Hz e ζ = 0,05, com seis algarismos; a dispersão das três leituras por SciPy
the-table-has-six-digits = a tabela tem seis algarismos
free-test-at-9-8-hz-forced-peak-at-9-6-hz = Ensaio livre a 9,8 Hz, pico forçado a 9,6 Hz
the-book-rounds-intermediate-results-d-1-2-1-gives-0-19706 = o livro arredonda resultados intermediários; (ωₚ/ω_d)² = (1 − 2ζ²)/(1 − ζ²) dá 0,19706
the-same-test-in-a-companion-to-the-book = O mesmo ensaio num complemento do livro
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-4-2-2 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 4.2.2
the-companion-confuses-d-with-its-square-d-1-2-1-so-that-0-19706-as-in-the-book = O complemento confunde ωₚ/ω_d com o seu quadrado: (ωₚ/ω_d)² = (1 − 2ζ²)/(1 − ζ²), de modo que ζ = 0,19706, como no livro.
it-follows-from-the-damping-ratio-without-the-square-9-8-hz-1-0-19706-is-9-996-hz = Decorre do fator de amortecimento sem o quadrado; 9,8 Hz/√(1 − 0,19706²) é 9,996 Hz.
the-same-test-without-intermediate-rounding = O mesmo ensaio sem arredondamentos intermediários
d-2-d-3-88-99-92 = ζ² = (ω_d² − ωₚ²)/(2ω_d² − ωₚ²) = 3,88/99,92
unbalance-12-mm-at-resonance-1-3-mm-far-above-it = Desbalanceamento: 12 mm na ressonância, 1,3 mm muito acima dela
the-same-with-12-mm-as-the-largest-amplitude-of-all = O mesmo com 12 mm como a maior amplitude de todas
w-g-mclean-and-e-w-nelson-schaum-s-engineering-mechanics-prob-19-28-with-the-peak-1-2-1 = W. G. McLean e E. W. Nelson, Schaum's Engineering Mechanics, probl. 19-28, com o pico 1/(2ζ√(1 − ζ²))
unbalance-at-two-speeds = Desbalanceamento em duas rotações
r-1-r-2-r-with-0-1-and-1200-rpm-m-e-m-2-mm = Λ = r²/√((1 − r²)² + (2ζr)²) com ζ = 0,1 e 1200 rpm, m₀e/m = 2 mm
amplitude-at-resonance-over-that-at-four-fifths-of-it = Amplitude na ressonância sobre a amplitude a quatro quintos dela
q-1-r-2-r-2-with-0-08-and-r-0-8 = q = √((1 − r²)² + (2ζr)²)/(2ζ) com ζ = 0,08 e r = 0,8
unbalance-amplitude-at-resonance-over-that-at-twice-the-speed = Desbalanceamento: amplitude na ressonância sobre a amplitude no dobro da rotação
q-1-r-2-r-2-r-with-0-08-and-r-2 = q = √((1 − r²)² + (2ζr)²)/(2ζr²) com ζ = 0,08 e r = 2
a-forced-peak-above-the-free-frequency = Pico forçado acima da frequência livre
n-1-2-is-never-above-n-1 = ω_n√(1 − 2ζ²) nunca está acima de ω_n√(1 − ζ²)
two-different-values-at-one-frequency = Dois valores diferentes numa mesma frequência
a-response-has-one-value-at-each-frequency = Uma resposta tem um único valor em cada frequência
points-on-a-straight-line = Pontos sobre uma reta
a-line-is-not-a-circle = Uma reta não é uma circunferência

# frequency_response_matrix.toml
two-masses-with-dampers-to-the-ground-forced-in-phase = Duas massas com amortecedores ao solo, forçadas em fase
eight-masses-with-dampers-between-them-forced-at-the-fourth = Oito massas com amortecedores entre elas, com força na quarta
code-aster-validation-manual-v2-test-sdld21 = Manual de validação do Code_Aster, V2, teste SDLD21
receptance-of-mass-4-under-1-n-at-5-5-5-10-and-40-hz-the-dampers-of-50-n-s-m-are-in-parallel-with-all = Receptância da massa 4 sob 1 N, a 5; 5,5; 10 e 40 Hz. Os amortecedores de 50 N·s/m ficam em paralelo com todas as nove molas.
two-masses-near-resonance-and-beyond = Duas massas perto da ressonância e além dela
ansys-mechanical-apdl-verification-manual-vm183-vierck-vibration-analysis-4-2 = ANSYS Mechanical APDL Verification Manual, VM183 (Vierck, Vibration Analysis, §4-2)
the-free-mass-is-coordinate-2-here-y1-in-the-manual-the-first-target-is-0-4-above-the-first-natural = A massa livre é aqui a coordenada 2, y1 no manual. O primeiro valor de referência está 0,4 % acima da primeira frequência natural, 0,22508 Hz.
modal-damping-of-one-mass-is-that-of-one-degree-of-freedom = O amortecimento modal de uma massa é o de um grau de liberdade
x-f-k-m-c-at-f-2-k = X = F/√((k − mω²)² + (cω)²) em ω = ωₙ: F/(2ζk)
resonance-without-damping = Ressonância sem amortecimento
the-motion-grows-with-t-there-is-no-steady-state-rao-5th-ed-3-3 = O movimento cresce com t: não há regime permanente (Rao, 5ª ed., §3.3)
force-on-a-mass-that-does-not-exist = Força numa massa que não existe
a-chain-of-one-mass-has-one-coordinate = Uma cadeia de uma só massa tem uma só coordenada

# friction_damper.toml
oscillator-of-944-6-kg-with-an-elastic-friction-damper = Oscilador de 944,6 kg com amortecedor elástico de atrito
j-guillen-and-c-pierre-1999-target-of-the-verification-problem-vm320-of-ansys-mechanical-apdl = J. Guillen e C. Pierre, 1999; valor de referência do problema de verificação VM320 do Ansys Mechanical APDL
the-printed-peak-is-read-off-the-curve-of-the-reference = O pico impresso é lido da curva da referência.
read-off-a-curve = lido de uma curva
slip-of-half-the-amplitude = Deslizamento de metade da amplitude
without-viscous-damping-the-peak-takes-f-hx-2f-d-at-k-k-d-2-m = Sem amortecimento viscoso, o pico exige F₀ = hX = 2F_d/π em √((k + k_d/2)/m).
friction-element-that-always-sticks = Elemento de atrito que nunca desliza
viscous-oscillator-with-k-k-d-100-n-m-and-0-1-x-f-2-k-1 = Oscilador viscoso com k + k_d = 100 N/m e ζ = 0,1: X = F₀/(2ζk√(1 − ζ²))
force-that-slip-cannot-limit = Força que o deslizamento não limita
n-4f-d-is-below-f-and-c-0 = 4F_d/π é menor que F₀ e c = 0

# gun_recoil.toml
barrel-of-600-kg = Cano de 600 kg
spring-of-294-kn-m-recoil-of-1-3-m-the-return-is-timed-up-to-50-mm-from-the-equilibrium-position = Mola de 294 kN/m, recuo de 1,3 m; o tempo de retorno é contado até 50 mm da posição de equilíbrio.
the-printed-time-is-read-from-a-table-of-x-t-in-steps-of-0-01-s-at-0-22-s-of-the-return-there-the = O tempo impresso é o de uma tabela de x(t) em passos de 0,01 s, lida a 0,22 s do retorno; ali o cano ainda está a 59 mm. Ele passa por 50 mm aos 0,22858 s; 0,29954 s ao todo.
the-barrel-timed-exactly = O cano com os tempos exatos
x-r-1-t-e-t-with-the-numbers-of-grover-s-ex-3-3-3 = x₁ = R (1 + ωₙt) e^(−ωₙt) com os números do ex. 3.3.3 de Grover
return-that-ends-before-it-begins = Retorno que termina antes de começar
the-return-goes-from-the-end-of-the-recoil-towards-the-equilibrium-position = O retorno vai do fim do recuo em direção à posição de equilíbrio

# half_car.toml
car-with-uncoupled-front-and-rear = Carro com dianteira e traseira desacopladas
j-m-l-f-l-r-each-end-is-a-body-mass-m-l-r-l-and-m-l-f-l-on-its-own-axle-two-systems-of-two-masses = J = m l_f l_r: cada extremidade é uma massa da carroceria, m l_r/l e m l_f/l, sobre o seu próprio eixo; dois sistemas de duas massas
front-600-kg-on-18-kn-m-over-a-wheel-of-40-kg-on-160-kn-m-rear-400-kg-on-16-kn-m-over-40-kg-on-160-kn = Dianteira: 600 kg sobre 18 kN/m, acima de uma roda de 40 kg sobre 160 kN/m; traseira: 400 kg sobre 16 kN/m, acima de 40 kg sobre 160 kN/m. Cada par satisfaz (18e3 − 600λ)(178e3 − 40λ) = (18e3)² e (16e3 − 400λ)(176e3 − 40λ) = (16e3)².
the-same-car-with-dampers = O mesmo carro com amortecedores
roots-of-600s-1200s-18e3-40s-1200s-178e3-1200s-18e3-at-the-front-and-of-400s-1000s-16e3-40s-1000s = Raízes de (600s² + 1200s + 18e3)(40s² + 1200s + 178e3) = (1200s + 18e3)² na dianteira e de (400s² + 1000s + 16e3)(40s² + 1000s + 176e3) = (1000s + 16e3)² na traseira
mass-beyond-the-range-of-numbers = Massa além do alcance dos números
a-mass-of-10-kg-beside-one-of-40-kg-cannot-be-represented = Uma massa de 10³⁰⁰ kg ao lado de uma de 40 kg não pode ser representada

# harmonic_force.toml
oscillator-driven-at-its-natural-frequency = Oscilador excitado na sua frequência natural
w-t-thomson-theory-of-vibration-with-applications-ex-3-1-2-target-of-the-verification-problem-vm86-of = W. T. Thomson, Theory of Vibration with Applications, ex. 3.1-2; valor de referência do problema de verificação VM86 do Ansys Mechanical APDL
power-of-a-shaker = Potência de um excitador
the-oscillator-is-specified-by-its-damped-frequency-the-amplitude-is-prescribed-and-the-force-is = O oscilador é definido pela sua frequência amortecida; a amplitude é imposta e a força é a incógnita.
the-source-uses-the-damped-frequency-instead-of-the-natural-one-in-c-2-m = a fonte usa a frequência amortecida em vez da natural em c = 2ζωₙm
build-up-of-resonance-with-one-per-cent-of-critical-damping = Crescimento da amplitude na ressonância com um por cento do amortecimento crítico
code-aster-validation-manual-v2-01-321-sdld321 = Manual de validação do Code_Aster, V2.01.321, SDLD321
the-oscillator-is-at-rest-until-the-force-f-sin-t-is-applied-at-its-own-natural-frequency-the-printed = O oscilador está em repouso até que a força F₀ sen ωt seja aplicada na sua frequência natural. A forma fechada impressa é avaliada em 1 s.
the-same-with-critical-damping = O mesmo com amortecimento crítico
the-same-without-damping-unbounded = O mesmo sem amortecimento: sem limite
x-f-2k-sin-t-t-cos-t-at-t-50 = x = F₀/(2k) (sen ωt − ωt cos ωt) em ωt = 50
heavy-mass-on-a-soft-spring-at-its-natural-frequency = Massa pesada sobre mola macia, na sua frequência natural
weight-in-oil = Peso imerso em óleo
w-t-thomson-theory-of-vibration-with-applications-ch-3-free-period-1-80-s-ratio-of-successive = W. T. Thomson, Theory of Vibration with Applications, cap. 3: período livre de 1,80 s, razão de amplitudes sucessivas de 4,2; F = 2 cos 3t; X = F/√((k − mω²)² + (cω)²), F_c = cωX, e os máximos de X e ω²X
the-mass-of-2-lb-0-907-kg-is-quoted-from-memory-it-is-cut-off-in-the-statement-consulted = A massa de 2 lb, 0,907 kg, é citada de memória: está cortada no enunciado consultado.
hysteretic-spring-at-its-natural-frequency = Mola histerética na sua frequência natural
x-f-k-90-rao-5th-ed-3-10-the-damping-alone-balances-the-force-energy-k-x-per-cycle = X = F₀/(ηk), φ = 90° (Rao, 5ª ed., §3.10): só o amortecimento equilibra a força; energia π η k X² por ciclo
overdamped-start-under-a-cosine-force = Início superamortecido sob uma força cossenoidal
x-t-by-residues-of-the-laplace-transform-with-poles-5-and-20-rad-s-and-force-8-cos-10t-on-1-kg = x(t) pelos resíduos da transformada de Laplace, com polos em −5 e −20 rad/s e força 8 cos 10t sobre 1 kg
k-100-n-m-c-25-n-s-m-x-8-250-m-90-so-x-0-032-sin-10t-c-e-5t-c-e-20t-with-c-c-0-32-15 = k = 100 N/m, c = 25 N·s/m: X = 8/250 m, φ = 90°, portanto x = 0,032 sen 10t + C₁e^(−5t) + C₂e^(−20t) com C₁ = −C₂ = −0,32/15.
force-for-a-given-power = Força para uma potência dada
p-c-x-and-f-x-k-m-c = P = ½ c ω² X² e F₀ = X √((k − mω²)² + (cω)²)
c-20-n-s-m-30-rad-s-x-0-1-m-p-90-w-k-m-1000-900-100-n-m-f-0-1-100-600-n = c = 20 N·s/m, ω = 30 rad/s, X = 0,1 m: P = 90 W; k − mω² = 1000 − 900 = 100 N/m, F₀ = 0,1 √(100² + 600²) N.
force-required-at-an-undamped-resonance = Força procurada numa ressonância sem amortecimento
any-force-at-the-natural-frequency-makes-an-undamped-motion-grow = Qualquer força na frequência natural faz crescer um movimento sem amortecimento
a-torque-does-no-work-on-a-translation = Um torque não realiza trabalho numa translação
base-motion-of-an-oscillator-known-by-its-free-decay = Movimento da base de um oscilador conhecido pelo seu decaimento livre
disc-on-two-shafts-from-rest = Disco sobre dois eixos, a partir do repouso
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-4-2-1 = Companion FOSSEE em Scilab de G. K. Grover, Mechanical Vibrations, ex. 4.2.1
j-16-1-8-2-kg-m-k-t-500-300-n-m-rad-20-rad-s-0-0666667-sin-1-0-5-sin-2-rad = J = 16·1²/8 = 2 kg·m², k_t = 500 + 300 N·m/rad: ωₙ = 20 rad/s; θ = 0,0666667 (sen 1 − 0,5 sen 2) rad.
machine-of-known-static-deflection = Máquina de deflexão estática conhecida
mass-on-two-parallel-springs = Massa sobre duas molas em paralelo
straight-spring-on-a-body-that-rotates = Mola linear num corpo que gira
the-stiffness-of-a-rotation-is-a-torque-per-angle = A rigidez de uma rotação é um torque por ângulo
torque-at-an-undamped-resonance = Torque numa ressonância sem amortecimento
torque-on-a-mass-that-moves-along-a-line = Torque numa massa que se move em linha reta
torque-that-keeps-an-amplitude-at-the-natural-frequency = Torque que mantém uma amplitude na frequência natural
torsional-oscillation-the-wire-is-the-torsional-spring-the-dashpot-a-torsional-damper = Oscilação torcional: o fio é a mola de torção, e o amortecedor é torcional.
wheel-on-a-wire-under-a-harmonic-torque = Roda num fio sob um torque harmônico
x-f-k-m-undamped-below-the-natural-frequency = X = F₀/(k − mω²), sem amortecimento, abaixo da frequência natural
k-t-2-20-800-n-m-rad-t-0-5-800-0-05-n-m-p-t = k_t = 2·20² = 800 N·m/rad: T₀ = 0,5·800·0,05 N·m; P = ½ T₀ ω Θ.
t-k-t-1-r-sin-t-r-sin-t-with-r-1-2 = θ = T₀/(k_t (1 − r²)) (sen ωt − r sen ωₙt), com r = 1/2
n-1000-rad-s-400-rad-s-x-60-10-600-m = ωₙ² = 1000 rad²/s², ω² = 400 rad²/s²: X = 60/(10·600) m.

# harmonic_sum.toml
beating-of-two-motions = Batimento de dois movimentos
work-of-a-force-of-25-n-in-one-second = Trabalho de uma força de 25 N em um segundo
the-same-force-in-a-quarter-of-a-cycle = A mesma força em um quarto de ciclo
three-vectors-of-one-frequency = Três vetores de uma mesma frequência
n-3-cos-t-4-cos-t-90-5-cos-t-180-20-cos-t-116-565 = 3 cos ωt + 4 cos(ωt + 90°) + 5 cos(ωt + 180°) = √20 cos(ωt + 116,565°)
three-motions-of-different-frequencies = Três movimentos de frequências diferentes
mean-square-half-the-sum-of-the-squares-of-the-amplitudes = Valor quadrático médio: metade da soma dos quadrados das amplitudes
two-motions-of-one-frequency-beat-with-a-third = Dois movimentos de uma mesma frequência batem com um terceiro
n-3-and-4-mm-a-quarter-of-a-cycle-apart-add-up-to-5-mm-with-6-mm-the-amplitude-varies-between-11-and = 3 e 4 mm defasados de um quarto de ciclo somam 5 mm; com 6 mm a amplitude varia entre 11 e 1 mm, e o valor quadrático médio é (5² + 6²)/2 mm²
force-beyond-the-range-of-numbers = Força além do alcance dos números
the-work-is-1e399-j-beyond-the-range-of-representable-numbers = O trabalho é de 1e399 J, além da faixa dos números representáveis

# large_pendulum.toml
pendulum-of-100-in-released-at-36-87 = Pêndulo de 100 in solto a 36,87°
w-t-thomson-vibration-theory-and-applications-ex-5-4-1-ansys-mechanical-apdl-verification-manual-vm91 = W. T. Thomson, Vibration Theory and Applications, ex. 5.4-1; ANSYS Mechanical APDL Verification Manual, VM91
rod-of-one-metre-released-from-the-horizontal = Haste de um metro solta na horizontal
iftomm-technical-committee-for-multibody-dynamics-library-of-computational-benchmark-problems-a01-1-m = IFToMM Technical Committee for Multibody Dynamics, Library of Computational Benchmark Problems, A01: 1 m, a partir do repouso a 90°
published-positions-of-the-mass-good-to-six-digits-over-2000-s-follow-from-the-same-elliptic = As posições publicadas da massa, com seis algarismos corretos ao longo de 2000 s, decorrem das mesmas funções elípticas. Aos 10 s a massa está em x = −0,27509 m, do lado de onde foi solta, e à altura de −0,96142 m.
amplitude-close-to-180 = Amplitude próxima de 180°
abramowitz-and-stegun-handbook-of-mathematical-functions-table-17-1-k-m-0-99-3-695637362989875 = Abramowitz e Stegun, Handbook of Mathematical Functions, tabela 17.1: K(m = 0,99) = 3,695637362989875
sin-2-0-99-1-rad-s = sen²(θ₀/2) = 0,99; ω₀ = 1 rad/s.
t-2-l-g-1-16 = T = 2π√(L/g) (1 + θ₀²/16)

# logarithmic_decrement.toml
torsional-pendulum-in-a-viscous-fluid = Pêndulo de torção num fluido viscoso
successive-amplitudes-of-9-6-and-4-degrees-the-period-is-that-in-the-fluid-the-printed-frequency-is = Amplitudes sucessivas de 9, 6 e 4 graus. O período é o medido no fluido; a frequência impressa é a do movimento no ar. O texto impresso dá c em N·m/rad; o correto é N·m·s/rad.
the-three-amplitudes-by-least-squares = As três amplitudes por mínimos quadrados
n-9-6-and-4-of-grover-s-ex-3-4-1-are-an-exact-geometric-series-ln-1-5 = 9°, 6° e 4° do ex. 3.4.1 de Grover formam uma progressão geométrica exata: δ = ln 1,5
machine-of-4000-lb-with-a-measured-decrement = Máquina de 4000 lb com decremento medido
problem-without-a-printed-answer-tutorsglobe-question-51418516 = Problema sem resposta impressa (TutorsGlobe, questão 51418516)
w-4000-lbf-on-10-000-lbf-in-0-314-measured-period-0-2025-s-from-mass-and-stiffness-31-068-rad-s-from = W = 4000 lbf sobre 10 000 lbf/in, δ = 0,314, período medido de 0,2025 s. Pela massa e pela rigidez ωₙ = 31,068 rad/s; pelo período medido, 31,067: os dois concordam. Os ciclos e o tempo são os de um decaimento de 0,1 in a 0,01 in, com o período dado pela massa e pela rigidez.
the-printed-value-uses-the-measured-period-0-2025-s-the-computed-value-uses-that-of-mass-and = o valor impresso usa o período medido, 0,2025 s; o calculado, o da massa e da rigidez
the-machine-by-its-period-alone = A máquina só pelo seu período
problem-without-a-printed-answer-tutorsglobe-question-51418516-t-n-t-d-n-ln-10 = Problema sem resposta impressa (TutorsGlobe, questão 51418516): t = n T_d, n = ln 10/δ
decrement-of-a-damping-ratio-of-0-316 = Decremento de um fator de amortecimento de 0,316
n-25-4-rad-s-the-decrement-does-not-depend-on-it = ωₙ = 25,4 rad/s; o decremento não depende dela.
the-printed-solution-multiplies-rounded-numbers-t-d-with-a-rounded-period = a solução impressa multiplica números arredondados: ζ ωₙ T_d com um período arredondado
seven-amplitudes-15-1-at-180-cycles-a-minute = Sete amplitudes na razão 15:1 a 180 ciclos por minuto
lists-06-08-list-08-question-4-with-ln-15-6 = Listas 06–08, lista 08, questão 4, com δ = (ln 15)/6
seven-successive-amplitudes-span-six-cycles-the-stiffness-is-that-of-the-spring-network-in-the = Sete amplitudes sucessivas abrangem seis ciclos; a rigidez é a da associação de molas da questão.
a-mass-and-a-period = Uma massa e um período
k-m-2-t-d-1-with-0-6 = k = m (2π/T_d)²/(1 − ζ²) com ζ = 0,6
a-motion-that-does-not-oscillate = Um movimento que não oscila
the-decrement-is-undefined-for-1-and-above = O decremento não é definido para ζ = 1 ou maior
amplitudes-that-grow = Amplitudes que crescem
in-a-decay-the-amplitudes-decrease = Num decaimento as amplitudes diminuem

# mass_on_shaft.toml
flywheel-between-two-fixed-shaft-ends = Volante entre duas extremidades fixas de um eixo
a-half-ton-flywheel-on-a-2-in-shaft-both-parts-of-the-shaft-support-it = Um volante de meia tonelada num eixo de 2 in; as duas partes do eixo o sustentam.
the-printed-value-is-computed-from-a-rounded-static-deflection = o valor impresso é calculado a partir de uma deflexão estática arredondada
weight-at-the-free-end-of-a-cantilever-shaft = Peso na extremidade livre de um eixo em balanço
the-printed-solution-takes-as-3-147-and-f-as-0-4985 = a solução impressa toma π como 3,147 e f como 0,4985/√δ
body-on-a-simply-supported-shaft = Corpo num eixo biapoiado
flywheel-on-a-shaft-fixed-at-both-ends = Volante num eixo engastado nas duas extremidades
the-printed-solution-takes-as-3-147 = a solução impressa toma π como 3,147
bearing-at-the-far-end = Mancal na extremidade oposta
k-768-e-i-7-l-at-the-middle-along-and-about-the-axis-only-the-clamped-half-contributes = k = 768 E I/(7 L³) no meio; ao longo da linha de centro e em torno dela só a metade engastada contribui
e-i-200e9-0-04-64-25132-7-n-m-l-1-m-k-2757420-n-m = E I = 200e9·π·0,04⁴/64 = 25132,7 N·m², L = 1 m: k = 2757420 N/m.
a-hollow-shaft = Eixo oco
a-bore-of-half-the-diameter-removes-a-sixteenth-of-e-i-and-a-quarter-of-e-a = Um furo com metade do diâmetro retira um dezesseis avos de E I e um quarto de E A
a-bore-wider-than-the-shaft = Furo mais largo que o eixo
no-such-shaft-exists = Um eixo assim não existe

# modal_analysis.toml
eight-masses-and-nine-springs-between-walls = Oito massas e nove molas entre paredes
code-aster-validation-manual-v2-test-sdld02 = Manual de validação do Code_Aster, V2, teste SDLD02
two-equal-masses-and-three-equal-springs = Duas massas iguais e três molas iguais
w-t-thomson-theory-of-vibration-with-applications-problem-5-2-answer-p-529 = W. T. Thomson, Theory of Vibration with Applications, problema 5-2, resposta na p. 529
the-book-answers-k-m-with-both-masses-in-step-and-3k-m-with-the-masses-opposed-here-with-k-1-n-m-and = O livro responde ω₁² = k/m com as duas massas em fase e ω₂² = 3k/m com as massas em oposição; aqui com k = 1 N/m e m = 1 kg. A figura do livro não estava disponível: a disposição é inferida da resposta.
two-masses-on-a-stretched-string = Duas massas em uma corda tracionada
w-t-thomson-theory-of-vibration-with-applications-problem-5-13-answer-p-529 = W. T. Thomson, Theory of Vibration with Applications, problema 5-13, resposta na p. 529
given-as-multiples-of-t-ml-here-t-1-n-l-1-m-m-1-kg-the-masses-2m-and-m-are-inferred-from-the = Dado como múltiplos de √(T/ml); aqui T = 1 N, l = 1 m, m = 1 kg. As massas 2m e m são inferidas da ortogonalidade das formas impressas. O valor exato é ω² = (3 ∓ √3)/2.
the-exact-ratio-is-1-3-2-1-36603-the-book-truncated-one-digit-too-early = a razão exata é (1 + √3)/2 = 1,36603; o livro truncou um algarismo antes da hora
damping-that-couples-the-modes-of-two-masses = Amortecimento que acopla os modos de duas massas
vibration-toolbox-test-of-mdof-modes-system-non-proportional-damping = vibration_toolbox, teste de mdof.modes_system (amortecimento não proporcional)
two-free-masses-and-a-spring = Duas massas livres e uma mola
k-1-m-1-m-the-first-mode-rigid-node-at-the-common-centre-of-mass = ω² = k (1/m₁ + 1/m₂), com o primeiro modo de corpo rígido; nó no centro de massa comum
a-mass-on-its-dampers-proportional-damping = Uma massa nos seus amortecedores: amortecimento proporcional
c-k-2-with-k-m-3-5-2 = C = β K: ζᵣ = β ωᵣ/2, com ω² = k/m (3 ∓ √5)/2
rayleigh-damping-of-5-at-2-hz-and-3-at-8-hz = Amortecimento de Rayleigh de 5 % a 2 Hz e 3 % a 8 Hz
n-2-2-at-the-frequencies-k-m-4-rad-s-and-3k-m-of-two-masses-rao-5th-ed-6-15 = ζ = α/(2ω) + βω/2 nas frequências √(k/m) = 4π rad/s e √(3k/m) de duas massas (Rao, 5ª ed., §6.15)
three-equal-masses-in-a-ring-of-two-equal-frequencies = Três massas iguais em anel, com duas frequências iguais
k-k-3-1-1-1-zero-once-and-3k-m-twice = K = k (3·1 − 1 1ᵀ): zero uma vez e 3k/m duas vezes
negative-stiffness = Rigidez negativa
an-indefinite-stiffness-matrix-has-no-stable-equilibrium-position = Uma matriz de rigidez indefinida não tem posição de equilíbrio estável
a-matrix-that-is-not-symmetric = Uma matriz que não é simétrica
maxwell-s-reciprocity = Reciprocidade de Maxwell
a-coordinate-without-mass = Uma coordenada sem massa
without-kinetic-energy-there-is-no-frequency = Sem energia cinética não há frequência

# multi_degree_response.toml
two-masses-under-a-pulse-on-the-free-one = Duas massas sob um pulso na que está livre
ansys-mechanical-apdl-verification-manual-vm182-vierck-vibration-analysis-5-8 = ANSYS Mechanical APDL Verification Manual, VM182 (Vierck, Vibration Analysis, §5-8)
the-free-mass-is-coordinate-2-here-y1-in-the-manual = A massa livre é aqui a coordenada 2, y1 no manual.
resonance-from-rest-without-damping = Ressonância a partir do repouso, sem amortecimento
x-f-t-sin-t-2m-rao-5th-ed-3-3-at-t-2-s-with-1-rad-s-4-m = x = F t sen(ωₙt)/(2mωₙ) (Rao, 5ª ed., §3.3): em t = π/2 s com ωₙ = 1 rad/s, π/4 m
two-free-masses-and-a-constant-force-with-the-rigid-body-motion = Duas massas livres e uma força constante, com o movimento de corpo rígido
x-f-t-2-m-m-and-a-relative-vibration-about-rest-at-a-whole-period-of-it-2-2k-m = x = F t²/(2(m₁ + m₂)) e uma vibração relativa em torno do repouso; ao fim de um período inteiro dela, 2π/√(2k/m)
m-1-kg-each-k-2-n-m-so-2-rad-s-and-the-period-is-s-f-4-n-on-the-first-4-4-9-869604-m-for-both = m = 1 kg cada uma, k = 2 N/m, portanto ω = 2 rad/s e o período é π s; F = 4 N na primeira: π²·4/4 = 9,869604 m para as duas.
a-damped-chain-with-a-start-and-three-kinds-of-force = Cadeia amortecida com condições iniciais e três tipos de força
taylor-series-of-the-equations-of-motion-step-by-step-as-a-second-method = Série de Taylor das equações de movimento, passo a passo, como segundo método
critical-damping-from-a-start = Amortecimento crítico a partir de condições iniciais
x-x-v-x-t-e-t-rao-5th-ed-2-6-2-rad-s-3-e-at-1-s = x = (x₀ + (v₀ + ωx₀) t) exp(−ωt) (Rao, 5ª ed., §2.6): ω = 2 rad/s, 3 e⁻² em 1 s
a-table-of-force-whose-times-go-back = Tabela de força cujos tempos retrocedem
time-cannot-run-backwards = O tempo não volta atrás

# multi_span_beam.toml
four-equal-spans-on-pins = Quatro vãos iguais sobre apoios simples
r-d-blevins-formulas-for-natural-frequency-and-mode-shape-ch-8-multispan-beams = R. D. Blevins, Formulas for Natural Frequency and Mode Shape, cap. 8 (vigas de vários vãos)
of-one-span-is-a-quarter-of-the-computed-value-3-1416-3-3932-3-9266-4-4633-then-2-the-rotational = O β de um vão é um quarto do valor calculado: 3,1416; 3,3932; 3,9266; 4,4633; depois 2π; as rigidezes rotacionais de um vão satisfazem próxima + distante · cos(jπ/4) = 0 nos apoios internos.
three-equal-spans-between-clamped-ends = Três vãos iguais entre extremidades engastadas
near-far-cos-j-3-0-for-j-2-and-1-then-cos-cosh-1 = próxima + distante · cos(jπ/3) = 0 para j = 2 e 1, depois cos β cosh β = 1
the-third-frequency-is-that-of-a-span-clamped-at-both-ends-the-slopes-at-the-pins-are-zero = A terceira frequência é a de um vão biengastado: as inclinações nos apoios são nulas.
clamped-intermediate-support-two-independent-beams = Engaste intermediário: duas vigas independentes
roots-of-tan-tanh-each-of-them-twice = Raízes de tan β = tanh β, cada uma delas duas vezes
a-clamp-uncouples-the-spans-2-3-926602 = Um engaste desacopla os vãos: 2 · 3,926602.
stepped-beam-with-equal-sections = Viga escalonada de seções iguais
cantilever-in-three-parts-roots-of-cos-cosh-1-rao-5th-ed-8-5 = Viga em balanço em três partes: raízes de cos β cosh β = −1 (Rao, 5ª ed., §8.5)
the-joints-between-the-spans-carry-no-load-and-have-no-effect = As junções entre os vãos não suportam carga e não têm efeito.
two-spans-of-one-pinned-beam-on-an-elastic-foundation = Dois vãos de uma viga biapoiada sobre base elástica
ei-n-l-n-n-l-k-m-of-a-beam-pinned-at-both-ends = ω² = (EI(nπ/L)⁴ + N(nπ/L)² + k)/m̄ de uma viga biapoiada
an-unsupported-joint-at-0-7-m-2-m-long = Uma junção sem apoio a 0,7 m; 2 m de comprimento.
free-free-shaft-in-two-segments-of-one-diameter = Eixo livre-livre em dois trechos de mesmo diâmetro
roots-of-cos-cosh-1-of-a-free-beam-rao-5th-ed-8-5 = Raízes de cos β cosh β = 1 de uma viga livre (Rao, 5ª ed., §8.5)
the-two-rigid-body-modes-are-not-counted = Os dois modos de corpo rígido não são contados.
too-much-compression = Compressão demais
two-pinned-spans-of-1-m-buckle-at-ei-l-19-74-kn = Dois vãos articulados de 1 m flambam com π²EI/L² = 19,74 kN

# overhung_disc.toml
overhung-disc-of-10-kg = Disco em balanço de 10 kg
the-example-calls-4071-8-and-19509-rpm-critical-speeds-its-frequency-equation-uses-i-d-so-they-are = O exemplo chama 4071,8 e 19509 rpm de velocidades críticas; a sua equação das frequências usa + I_d, portanto são as frequências naturais do disco sem rotação. Com o efeito giroscópico, a velocidade crítica excitada pelo desbalanceamento é 4866 rpm, e é a única: I_p é maior que I_d.
the-same-disc-synchronous-whirl = O mesmo disco, precessão síncrona
the-frequency-equation-with-i-d-i-p-and-i-d-i-p-in-the-place-of-i-d-den-hartog-6-6 = A equação das frequências com I_d − I_p e I_d + I_p no lugar de I_d (Den Hartog, §6.6)
disc-of-negligible-size = Disco de dimensões desprezíveis
mass-at-the-tip-of-a-cantilever-3ei-ml-here-3-200e9-1e-7-10-1-6000-s = Massa na ponta de uma viga em balanço, ω² = 3EI/(mL³); aqui 3·200e9·1e-7/(10·1) = 6000 s⁻²
long-disc-between-two-equal-bearings = Disco longo entre dois mancais iguais
deflection-and-slope-uncoupled-0-1-m-and-the-tilting-mode-has-1-i-d-i-p-forward-1-i-d-i-p-backward = Deflexão e inclinação desacopladas, β = 0: ω = 1/√(α m), e o modo de inclinação tem ω² = 1/(γ (I_d − I_p)) direta, 1/(γ (I_d + I_p)) retrógrada
n-1e-6-m-n-m-25-kg-200-rad-s-1e-4-rad-n-m-i-d-i-p-0-04-kg-m-and-i-d-i-p-0-16-kg-m-500-and-250-rad-s = α = 1e-6 m/N, m = 25 kg: 200 rad/s. γ = 1e-4 rad/(N m), I_d − I_p = 0,04 kg m² e I_d + I_p = 0,16 kg m²: 500 e 250 rad/s. Em repouso I_d = 0,1 kg m²: 316,228 rad/s.
influence-coefficients-that-no-shaft-has = Coeficientes de influência que nenhum eixo tem
the-elastic-energy-is-positive-for-any-load = A energia elástica é positiva para qualquer carga: α γ > β²

# pendulum_absorber.toml
four-pendulums-against-the-third-order = Quatro pêndulos contra a terceira ordem
r-r-n-and-t-4-m-r-r-r-with-n = r = R/n² e T = 4 m r (R + r) ω₀² φ, com ω₀ = nΩ
at-the-tuned-order-the-rotor-is-at-rest-and-the-pendulums-oscillate-at-their-limit = Na ordem sintonizada o rotor fica em repouso e os pêndulos oscilam no seu limite.
a-pendulum-below-its-tuned-order-acts-like-a-flywheel = Abaixo da sua ordem sintonizada, um pêndulo age como um volante
j-e-m-r-r-1-n-r-r-t-j-j-e = J_e = m (R + r)²/(1 − n² r/R), Θ = −T/((J + J_e) ω²)
a-solid-roller-of-order-four-and-a-half = Rolete maciço de ordem quatro e meio
n-r-r-1-a-a-2 = n² = R/(r (1 + κ²/a²)), κ² = a²/2
a-ring-needs-a-shorter-arm-than-a-bifilar-weight = Um anel exige um braço mais curto que um peso bifilar
n-r-2-r-for-a-ring = n² = R/(2 r) para um anel
three-bodies-on-a-rotor-below-their-tuned-order = Três corpos em um rotor, abaixo da sua ordem sintonizada
m-j-nm-r-r-m-nm-r-r-r-m-nm-r-k-nmrr-steady-state-amplitudes-and-natural-frequency-of-the-2-2-matrices = M₁₁ = J + Nm((R + r)² + κ²), M₁₂ = Nm(r(R + r) + κ²), M₂₂ = Nm(r² + κ²), K₂₂ = NmRrΩ²: amplitudes em regime permanente e frequência natural das matrizes 2 × 2
a-body-whose-arm-is-the-larger-root = Corpo cujo braço é a raiz maior
r-75-r-900-0-in-mm-r-60-mm-or-15-mm-from-n-r-r-r = r² − 75 r + 900 = 0 em mm: r = 60 mm ou 15 mm, por n² = R r/(r² + κ²)
rotor-on-a-shaft-torque-of-the-second-order = Rotor num eixo, torque de segunda ordem
roots-and-steady-state-amplitudes-of-the-2-2-matrices-of-the-small-motions = Raízes e amplitudes em regime permanente das matrizes 2 × 2 dos pequenos movimentos
floor-kept-at-rest-by-a-weight-on-a-string = Piso mantido imóvel por um peso num fio
l-g-m-f-l-roots-of-the-2-2-matrices-of-the-small-motions = l = g/ω², m = F₀/(l ω² φ), raízes das matrizes 2 × 2 dos pequenos movimentos
body-with-moment-of-inertia-below-a-point-mass = Corpo com momento de inércia abaixo de uma massa pontual
g-l-l-and-the-2-2-matrices-of-the-small-motions = ω₀ = √(g l/(l² + κ²)) e as matrizes 2 × 2 dos pequenos movimentos
a-body-too-large-for-its-order = Corpo grande demais para a sua ordem
r-2-h-r-has-no-real-root-for-h = r² − 2 h r + κ² não tem raiz real para κ > h
a-limited-swing-without-a-torque = Oscilação limitada sem torque
the-mass-follows-from-the-absorbed-torque = A massa decorre do torque que é absorvido

# periodic_excitation.toml
square-wave-at-a-third-of-the-natural-frequency = Onda quadrada a um terço da frequência natural
u-4-sin-n-t-n-over-odd-n-undamped-r-0-3-x-4f-n-k-1-n-r = u = (4/π) Σ sen(nωt)/n para n ímpar; sem amortecimento, r = 0,3: |Xₙ| = 4F₀/(nπk |1 − n²r²|)
the-third-harmonic-lies-at-0-9-of-the-natural-frequency-and-is-the-largest = O terceiro harmônico fica a 0,9 da frequência natural e é o maior.
cam-with-a-sawtooth-lift = Came com elevação em dente de serra
sawtooth-y-y-t-t-on-spring-and-damper-mean-y-2-harmonics-y-n-transmissibility-and-lag-of-each-mean = Dente de serra y = Y t/T sobre mola e amortecedor: média Y/2, harmônicos Y/(nπ), transmissibilidade e atraso de cada um; valor quadrático médio pela soma de todos
slow-triangular-force = Força triangular lenta
far-below-the-natural-frequency-the-displacement-is-force-over-stiffness-rms-value-1-3-of-the-height = Muito abaixo da frequência natural o deslocamento é a força sobre a rigidez: valor eficaz igual a 1/√3 da altura
half-rectified-sine-with-damping = Seno de meia onda com amortecimento
f-f-2-f-2f-n-1-for-even-n-and-the-magnification-and-lag-of-each = F₁ = F₀/2, Fₙ = 2F₀/((n² − 1)π) para n par, e a amplificação e o atraso de cada um
pulses-of-a-quarter-of-the-period = Pulsos de um quarto do período
f-2f-sin-n-d-n-the-fourth-harmonic-is-missing = Fₙ = 2F₀ |sen nπd|/(nπ): falta o quarto harmônico
rectified-sine-on-critically-damped-springs = Seno retificado sobre molas com amortecimento crítico
f-4f-4n-1-magnification-1-1-n-r = Fₙ = 4F₀/((4n² − 1)π), amplificação 1/(1 + n²r²)
square-wave-as-a-table = Onda quadrada como tabela
the-square-wave-again-typed-point-by-point-at-a-third-of-a-period = A onda quadrada outra vez, digitada ponto a ponto, em um terço do período
undamped-under-a-constant-force-the-motion-is-a-cosine-about-the-deflection-of-that-half-period-x-f-k = Sem amortecimento e sob força constante, o movimento é um cosseno em torno da deflexão desse meio período: x = (F₀/k)(1 − cos(ωₙ(t − T/4))/cos(ωₙT/4)).
undamped-with-the-third-harmonic-at-resonance = Sem amortecimento e com o terceiro harmônico na ressonância
a-square-wave-has-odd-harmonics = Uma onda quadrada tem harmônicos ímpares

# piecewise_spring.toml
saturating-spring = Mola com saturação
w-t-thomson-vibration-theory-and-applications-fig-5-6-1-ansys-mechanical-apdl-verification-manual = W. T. Thomson, Vibration Theory and Applications, fig. 5.6-1; ANSYS Mechanical APDL Verification Manual, VM79
two-stops-with-clearance = Dois batentes com folga
t-4y-v-2-m-k-free-flight-between-the-stops-and-half-an-oscillation-at-each = T = 4y/v + 2π√(m/k): percurso livre entre os batentes e meia oscilação em cada um
amplitude-below-the-breakpoint-linear = Amplitude abaixo do ponto de quebra, linear
t-2-m-k-a-x-m-v-k = T = 2π√(m/k), A = √(x₀² + m v₀²/k)
stiffer-stop = Batente mais rígido
m-v-k-y-k-y-d-k-d-8-j-2-j-80-d-100-d-d-0-06904158-m = ½ m v² = ½ k₁ y² + k₁ y d + ½ k₂ d²: 8 J = 2 J + 80 d + 100 d², d = 0,06904158 m
at-rest-within-the-clearance = Em repouso dentro da folga
limit-nothing-moves = Limite: nada se move

# plate_and_membrane.toml
circular-drum = Tambor circular
zeros-of-j-n-abramowitz-stegun-table-9-5 = Zeros de J_n (Abramowitz & Stegun, tabela 9.5)
the-first-of-them-are-j-j-j-j-j-j = Os primeiros deles são j₀₁, j₁₁, j₂₁, j₀₂, j₃₁, j₁₂.
rectangular-membrane = Membrana retangular
c-m-a-n-b-rao-5th-ed-8-6 = ω = πc√((m/a)² + (n/b)²) (Rao, 5ª ed., §8.6)
clamped-circular-plate = Placa circular engastada
a-w-leissa-vibration-of-plates-nasa-sp-160-table-2-1 = A. W. Leissa, Vibration of Plates, NASA SP-160, tabela 2.1
of-the-mode-shapes-with-0-1-2-nodal-diameters-then-of-that-with-one-nodal-circle = λ² das formas modais com 0, 1, 2 diâmetros nodais, depois da forma com uma circunferência nodal.
simply-supported-circular-plate = Placa circular simplesmente apoiada
roots-of-j-n-1-j-n-i-n-1-i-n-2-1-with-0-3 = Raízes de Jₙ₊₁/Jₙ + Iₙ₊₁/Iₙ = 2λ/(1 − ν) com ν = 0,3
n-2-2215-for-the-first-of-them-often-printed-as-4-935-leissa-s-table-of-1969-has-4-977 = λ = 2,2215 para a primeira delas; muitas vezes impresso como λ² = 4,935 (a tabela de Leissa de 1969 tem 4,977).
free-circular-plate = Placa circular livre
a-w-leissa-vibration-of-plates-nasa-sp-160-table-2-5-0-33 = A. W. Leissa, Vibration of Plates, NASA SP-160, tabela 2.5 (ν = 0,33)
two-nodal-diameters-one-nodal-circle-three-nodal-diameters = Dois diâmetros nodais, uma circunferência nodal, três diâmetros nodais.
the-roots-of-the-determinant-are-5-2620-9-0689-and-12-2439-reproduced-by-the-energies-of-the-mode = As raízes do determinante são 5,2620; 9,0689 e 12,2439, reproduzidas pelas energias das formas modais com nove algarismos; a tabela, compilada de antigos cálculos à mão, erra no terceiro ou no quarto algarismo.
free-circular-plate-with-0-3 = Placa circular livre com ν = 0,3
later-tables-5-358-for-two-nodal-diameters-9-003-for-one-nodal-circle-12-439 = Tabelas posteriores: λ² = 5,358 para dois diâmetros nodais; 9,003 para uma circunferência nodal; 12,439
simply-supported-on-all-edges = Simplesmente apoiada em todas as bordas
navier-m-na-b = Navier: Λ = π²(m² + (na/b)²)
a-b-1-5 = a/b = 1,5.
two-edges-simply-supported-two-clamped = Duas bordas simplesmente apoiadas, duas engastadas
a-w-leissa-the-free-vibration-of-rectangular-plates-j-sound-vib-31-1973-257-293-square-plate-0-3 = A. W. Leissa, The free vibration of rectangular plates, J. Sound Vib. 31 (1973), 257–293: placa quadrada, ν = 0,3
three-edges-simply-supported-one-clamped = Três bordas simplesmente apoiadas, uma engastada
three-edges-simply-supported-one-free = Três bordas simplesmente apoiadas, uma livre
two-edges-simply-supported-one-clamped-one-free = Duas bordas simplesmente apoiadas, uma engastada, uma livre
two-edges-simply-supported-two-free = Duas bordas simplesmente apoiadas, duas livres
plate-with-an-added-mass-of-twice-its-own = Placa com massa adicional igual ao dobro da sua
frequencies-decrease-by-3 = As frequências diminuem por um fator √3
the-first-number-is-2-for-a-square-plate = O primeiro número é 2π² para uma placa quadrada.
a-strip = Uma faixa
one-side-is-200-times-the-other = Um lado é 200 vezes o outro

# random_chain.toml
two-masses-on-a-base-with-random-vibration-from-10-to-100-hz = Duas massas sobre uma base com vibração aleatória de 10 a 100 Hz
r-k-vierck-vibration-analysis-2nd-ed-ch-7-target-of-the-verification-problem-vm68-of-ansys-mechanical = R. K. Vierck, Vibration Analysis, 2ª ed., cap. 7; valor de referência do problema de verificação VM68 do Ansys Mechanical APDL
one-sigma-accelerations-relative-to-the-base-in-multiples-of-386-4-in-s = Acelerações de um sigma relativas à base, em múltiplos de 386,4 in/s².
the-printed-value-comes-from-modal-sums-in-steps-of-frequency = o valor impresso vem de somas modais em passos de frequência
a-chain-of-one-mass-under-white-noise = Cadeia de uma só massa sob ruído branco
z-s-4-a-s-1-4-4-with-s-per-rad-s = σ_z² = π S/(4ζωₙ³), σ_a² = π S ωₙ(1 + 4ζ²)/(4ζ) com S por rad/s
same-as-the-50-hz-mount-in-the-random-response-of-one-mass = Igual ao coxim de 50 Hz na resposta aleatória de uma só massa.
the-variance-of-undamped-modes-under-noise-grows-with-time = A variância de modos sem amortecimento sob ruído cresce com o tempo

# random_response.toml
white-acceleration-on-a-lightly-damped-mount = Aceleração branca sobre um coxim pouco amortecido
z-s-4-a-s-1-4-4-with-s-per-rad-s-miles-formula-2-f-q-s = σ_z² = π S/(4ζωₙ³), σ_a² = π S ωₙ(1 + 4ζ²)/(4ζ) com S por rad/s; fórmula de Miles √(π/2 fₙ Q S)
n-50-hz-q-10-0-04-g-hz-miles-gives-5-605-g = 50 Hz; Q = 10; 0,04 g²/Hz: Miles dá 5,605 g.
a-band-about-the-resonance = Faixa em torno da ressonância
partial-fractions-of-h-over-20-to-2000-hz = Frações parciais de |H|² de 20 a 2000 Hz
the-same-band-by-its-table = A mesma faixa pela sua tabela
a-table-of-two-equal-points-is-equivalent-to-the-band = Uma tabela de dois pontos iguais equivale à banda
a-test-specification-with-slopes = Especificação de ensaio com rampas
simpson-s-rule-with-180-000-steps-over-the-log-log-lines = Regra de Simpson com 180 000 passos sobre as retas log-log
n-3-db-octave-up-to-80-hz-constant-up-to-350-hz-3-db-octave-to-2000-hz = +3 dB/oitava até 80 Hz, constante até 350 Hz, −3 dB/oitava até 2000 Hz.
white-force-on-a-mass = Força branca sobre uma massa
x-s-2-k-c-with-s-per-rad-s-v-s-2-m-c = σ_x² = π S/(2 k c) com S por rad/s; σ_v² = π S/(2 m c)
force-in-a-band-far-below-the-resonance = Força numa faixa muito abaixo da ressonância
nearly-static-x-s-f-k = Quase estático: σ_x = √(S Δf)/k
the-mean-square-is-larger-than-the-static-one-by-2-f-f-some-0-01 = O valor quadrático médio é maior que o estático em 2(f/fₙ)², cerca de 0,01 %.
the-variance-of-an-undamped-oscillator-under-white-noise-grows-with-time = A variância de um oscilador sem amortecimento sob ruído branco cresce com o tempo

# rayleigh_damping.toml
n-5-at-0-3-hz-and-2-at-1-2-hz = 5 % a 0,3 Hz e 2 % a 1,2 Hz
technical-note-nts-02-on-rayleigh-damping = Nota técnica NTS-02 sobre amortecimento de Rayleigh
its-closed-forms-and-its-program-are-right-its-printed-formula-for-the-damping-at-a-frequency-lacks-a = As suas formas fechadas e o seu programa estão certos; na fórmula impressa para o amortecimento em uma frequência falta um fator de um meio no termo da massa.
the-printed-formula-uses-2-f-in-4-f-f-at-1-hz-the-two-known-modes-give-0-02107 = A fórmula impressa usa α/(2π f) em ζ = α/(4π f) + β π f; a 1 Hz os dois modos conhecidos dão 0,02107.
the-same-damping-at-both-frequencies = O mesmo amortecimento nas duas frequências
n-2-2-2 = α = 2ζω₁ω₂/(ω₁ + ω₂), β = 2ζ/(ω₁ + ω₂), ζ₀ = 2ζ√(ω₁ω₂)/(ω₁ + ω₂)
two-modes-of-one-frequency = Dois modos de uma mesma frequência
limit-the-two-equations-are-the-same = Limite: as duas equações são a mesma

# response_spectrum.toml
beam-on-two-supports-that-follow-one-displacement-spectrum = Viga sobre dois apoios que seguem um mesmo espectro de deslocamento
j-m-biggs-introduction-to-structural-dynamics-p-262-target-of-the-verification-problem-vm70-of-ansys = J. M. Biggs, Introduction to Structural Dynamics, p. 262; valor de referência do problema de verificação VM70 do Ansys Mechanical APDL
the-first-mode-alone-0-2-lbf-s-in-of-mass-for-each-inch-of-length-273-9726-in-of-0-00073-lbf-s-in = Somente o primeiro modo; 0,2 lbf s²/in de massa por polegada de comprimento (273,9726 in² de 0,00073 lbf s²/in⁴).
the-printed-stress-is-truncated-20158-55 = a tensão impressa está truncada: 20158,55
the-same-beam-with-three-modes = A mesma viga com três modos
n-4-n-alternating-in-sign-e-c-n-l-y-cqc-with-of-each-pair-of-modes = Γφ = 4/(nπ), de sinal alternado; σ = E c (nπ/L)² y; CQC com ρ de cada par de modos
at-a-constant-displacement-the-higher-modes-add-little-to-the-deflection-and-much-to-the-stress = Com deslocamento constante, os modos superiores acrescentam pouco à deflexão e muito à tensão.
two-masses-under-a-constant-acceleration = Duas massas sob aceleração constante
two-equal-links-3-5-2-k-m-from-the-eigenvectors-1-1-5-2 = Dois elos iguais: ω² = (3 ∓ √5)/2 k/m, Γφ pelos autovetores (1, (1 ± √5)/2)
two-modes-near-each-other = Dois modos próximos um do outro
cqc-with-8-1-r-r-r-1-r-4-r-1-r = CQC com ρ = 8ζ²(1 + r)r√r/((1 − r²)² + 4ζ²r(1 + r)²)
the-modes-act-in-opposition-srss-overestimates-the-response = Os modos atuam em oposição: a SRSS superestima a resposta.
a-mode-outside-the-table = Um modo fora da tabela
a-spectrum-is-not-defined-outside-its-range = Um espectro não é definido fora da sua faixa

# rod_impact.toml
bar-suddenly-stopped-at-one-end = Barra parada subitamente em uma extremidade
s-timoshenko-vibration-problems-in-engineering-p-305-target-of-the-verification-problem-vm85-of-ansys = S. Timoshenko, Vibration Problems in Engineering, p. 305; valor de referência do problema de verificação VM85 do Ansys Mechanical APDL
a-bar-of-10000-in-at-100-in-s-density-0-00073-lbf-s-in = Uma barra de 10000 in a 100 in/s; massa específica de 0,00073 lbf·s²/in⁴.
steel-rod-at-one-metre-a-second = Barra de aço a um metro por segundo
c-v-v-l-c-contact-2-l-c-timoshenko-ch-5 = σ = ρ c v, δ = v L/c, contato 2 L/c (Timoshenko, cap. 5)
c-200-10-8000-5000-m-s-8000-5000-1-40-mpa-1-5000-m-0-4-ms-1-cm-carries-4-kn-250-mpa-are-reached-at-6 = c = √(200·10⁹/8000) = 5000 m/s: σ = 8000·5000·1 = 40 MPa, δ = 1/5000 m, 0,4 ms; 1 cm² leva 4 kN; chega-se a 250 MPa com 6,25 m/s.
impact-faster-than-the-wave-speed = Impacto mais rápido que a velocidade da onda
the-strain-v-c-would-reach-one = A deformação v/c chegaria a um

# rod_under_sudden_force.toml
a-bar-of-48000-in-and-2-in-under-6000-lbf-density-0-0007202-lbf-s-in-at-t-l-c = Uma barra de 48000 in e 2 in² sob 6000 lbf; massa específica 0,0007202 lbf·s²/in⁴, em t = L/c.
a-place-beyond-the-rod = Uma posição além da barra
a-place-that-the-wave-has-not-reached = Uma posição à qual a onda não chegou
bar-suddenly-loaded-at-one-end = Barra carregada subitamente numa extremidade
free-end-after-the-wave-has-reached-it = Extremidade livre depois da chegada da onda
s-timoshenko-vibration-problems-in-engineering-p-311-target-of-the-verification-problem-vm84-of-ansys = S. Timoshenko, Vibration Problems in Engineering, p. 311; valor de referência do problema de verificação VM84 do Ansys Mechanical APDL
steel-rod-after-the-wave-has-returned = Barra de aço depois do retorno da onda
the-place-must-be-on-the-rod = A posição tem de estar na barra
c-200-10-8000-5000-m-s-2l-c-0-4-ms-4-kn-on-1-cm-40-mpa-v-1-m-s-at-0-5-ms-u-0-5-0-1-0-1-mm-and-m-0-8 = c = √(200·10⁹/8000) = 5000 m/s, 2L/c = 0,4 ms; 4 kN em 1 cm²: 40 MPa, v = 1 m/s; em 0,5 ms u = 0,5 + 0,1 + 0,1 mm, e m = 0,8 kg dá F t²/(2m) = 0,625 mm.
u-2-v-t-l-c-at-the-free-end-for-l-c-t-3l-c = u = 2 v (t − L/c) na extremidade livre para L/c < t < 3L/c
u-g-f-t-2m-ahead-of-the-wavefront-the-rod-is-at-rest = u_G = F t²/(2m); à frente da frente de onda a barra está em repouso
v-f-c-a-u-v-t-v-t-2l-c-v-t-2l-c-at-the-loaded-end-for-2l-c-t-4l-c = v = F/(ρ c A), u = v t + v (t − 2L/c) + v (t − 2L/c) na extremidade carregada para 2L/c < t < 4L/c

# rotating_beam.toml
flapwise-at-1 = Em batimento, com η = 1
a-d-wright-c-e-smith-r-w-thresher-and-j-l-c-wang-j-appl-mech-49-1982-uniform-blade-without-a-hub = A. D. Wright, C. E. Smith, R. W. Thresher e J. L. C. Wang, J. Appl. Mech. 49 (1982): pá uniforme sem cubo
flapwise-at-2 = Em batimento, com η = 2
flapwise-at-5 = Em batimento, com η = 5
flapwise-at-12 = Em batimento, com η = 12
at-rest-a-cantilever = Em repouso, uma viga em balanço
roots-of-cos-cosh-1-squared-rao-5th-ed-8-5 = Raízes de cos β cosh β = −1, ao quadrado (Rao, 5ª ed., §8.5)
lagwise-at-5 = Em avanço e recuo, com η = 5
f-with-the-flapwise-6-4495-of-wright-and-others = ω² = ω_f² − Ω² com o valor 6,4495 de Wright e outros, em batimento
n-6-4495-25-4-0739 = √(6,4495² − 25) = 4,0739.
computed-from-the-printed-6-4495 = calculado a partir do valor impresso 6,4495
at-45-degrees = A 45 graus
f-2 = ω² = ω_f² − Ω²/2
n-6-4495-12-5-5-3938 = √(6,4495² − 12,5) = 5,3938.
speed-too-high = Rotação alta demais
a-blade-without-stiffness-is-a-string = Uma pá sem rigidez é uma corda
blade-with-hub-and-tip-mass-at-30-degrees = Pá com cubo e massa na ponta, a 30 graus
closed-form-w-t-w-w-by-power-series-in-60-digits-with-the-mass-at-the-tip-f-sin = forma fechada: w'''' − η²(T w')' = Λ² w por séries de potências com 60 algarismos, com a massa na ponta; ω² = ω_f² − Ω² sen² ψ
southwell-s-coefficients-are-with-4-00751-and-t-w-dx-over-w-dx-w-1-of-the-mode-shapes-at-rest = Os coeficientes de Southwell são (Λ² − Λ₀²)/η² com η = 4,00751, e ∫T w'² dx sobre ∫w² dx + μ w(1)² das formas modais em repouso.

# rotating_unbalance.toml
fan-on-a-cantilever = Ventilador sobre viga em balanço
lists-06-08-list-07-question-2 = Listas 06–08, lista 07, questão 2
the-damping-is-known-only-from-the-maximum-steady-state-amplitude-at-any-speed-20-3-mm = O amortecimento é conhecido apenas pela amplitude máxima em regime permanente em qualquer rotação, 20,3 mm.
the-peak-ratio-is-m-x-max-m-e-8-12-the-printed-solution-uses-20-3e-3-m-instead-finds-no-real-root-and = A razão do pico é Λ = m X_max/(m₀e) = 8,12; a solução impressa usa 20,3e-3 m em seu lugar, não encontra raiz real e supõe 0,707. A raiz é ζ = 0,06169.
follows-from-the-assumed-0-707-with-the-damping-determined-by-the-stated-20-3-mm-x-19-456-mm = Decorre da hipótese ζ = 0,707. Com o amortecimento que os 20,3 mm do enunciado determinam, X = 19,456 mm.
fan-on-a-cantilever-corrected = Ventilador em uma viga em balanço, corrigido
lists-06-08-list-07-question-2-with-the-smaller-root-of-4-1-1 = Listas 06–08, lista 07, questão 2, com a menor raiz de 4Λ²ζ²(1 − ζ²) = 1
the-fan-with-the-assumed-damping = O ventilador com o amortecimento adotado
lists-06-08-list-07-question-2-with-0-707-as-the-printed-solution-assumes = Listas 06–08, lista 07, questão 2, com ζ = 0,707, como supõe a solução impressa
the-printed-amplitude-follows-from-the-assumption-only-the-assumption-is-wrong = A amplitude impressa decorre da hipótese; só a hipótese está errada.
exhaust-fan-on-undamped-springs = Exaustor sobre molas sem amortecimento
exhaust-fan-problem-with-printed-answers-edu-com-question-1058325 = Problema do exaustor com respostas impressas (edu.com, questão 1058325)
the-springs-are-specified-by-their-static-deflection-of-45-mm-k-m-g-with-g-9-81-m-s = As molas são definidas pela sua deflexão estática de 45 mm: k = m g/δ com g = 9,81 m/s².
the-printed-force-is-computed-from-rounded-numbers = a força impressa é calculada com números arredondados
motor-with-up-to-a-tenth-of-critical-damping = Motor com até um décimo do amortecimento crítico
the-stiffness-gives-a-resonance-at-2210-rpm-1-kg-rotates-at-60-mm-from-the-axis-the-amplitude-lies = A rigidez corresponde a uma ressonância a 2210 rpm; 1 kg gira a 60 mm do eixo de rotação. A amplitude fica entre a com um décimo do amortecimento crítico e a sem amortecimento.
engine-with-a-piston = Motor com um pistão
the-piston-of-2-kg-with-a-stroke-of-80-mm-is-equivalent-to-an-unbalance-of-2-kg-times-40-mm = O pistão de 2 kg com curso de 80 mm equivale a um desbalanceamento de 2 kg vezes 40 mm.
exciter-at-its-natural-frequency = Excitador na sua frequência natural
w-t-thomson-theory-of-vibration-with-applications-2nd-printing-ex-3-3-1-target-of-the-verification = W. T. Thomson, Theory of Vibration with Applications, 2ª impressão, ex. 3.3-1; valor de referência do problema de verificação VM88 do Ansys Mechanical APDL
two-counter-rotating-weights-the-unbalance-is-the-force-of-2-4-lbf-at-5-415947-hz-over-the-square-of = Dois pesos que giram em sentidos opostos; o desbalanceamento é a força de 2,4 lbf a 5,415947 Hz sobre o quadrado dessa frequência.
the-exciter-far-above-its-natural-frequency = O excitador muito acima da sua frequência natural
shaft-on-two-bearings-with-a-light-disc = Eixo em dois mancais com um disco leve
turbine-disc-problem-of-rao-ch-9-amplitude-e-r-1-r-2-r-at-6000-rpm = Problema do disco de turbina de Rao, cap. 9: amplitude e r²/√((1 − r²)² + (2ζr)²) a 6000 rpm
e-207-gpa-is-assumed = Supõe-se E = 207 GPa.
allowed-amplitude-below-m-e-m = Amplitude admissível abaixo de m₀e/M
the-peak-is-never-below-m-e-m-rao-5th-ed-3-7 = O pico nunca é menor que m₀e/m (Rao, 5ª ed., §3.7)
machine-with-a-known-damping-coefficient = Máquina com coeficiente de amortecimento conhecido
closed-form-x-m-e-k-m-i-c-f-k-i-c-x-the-peak-m-e-2m-1-at-1-2-c-2-km = forma fechada: X = m₀e ω²/|k − mω² + iωc|, F = |k + iωc| X; o pico m₀e/(2mζ√(1 − ζ²)) em ωₙ/√(1 − 2ζ²), ζ = c/(2√(km))

# rotor_dynamics.toml
two-discs-on-isotropic-bearings-at-4000-rpm = Dois discos em mancais isotrópicos a 4000 rpm
m-i-friswell-et-al-dynamics-of-rotating-machines-ex-5-9-1-as-the-program-ross-asserts-it = M. I. Friswell et al., Dynamics of Rotating Machines, ex. 5.9.1, como o verifica o programa ROSS
six-timoshenko-elements-ross-also-lists-650-41-rad-s-a-torsional-mode-not-a-lateral-one-the-unbalance = Seis elementos de Timoshenko. O ROSS lista também 650,41 rad/s: um modo torcional, não lateral. O desbalanceamento foi escolhido aqui.
the-same-rotor-at-rest = O mesmo rotor em repouso
the-computed-value-is-716-786-at-the-rounding-limit-of-the-last-printed-digit = o valor calculado é 716,786, no limite de arredondamento da última casa impressa
two-discs-on-softer-bearings-along-y = Dois discos em mancais mais flexíveis ao longo de y
m-i-friswell-et-al-dynamics-of-rotating-machines-ex-5-9-3-as-the-program-ross-asserts-it = M. I. Friswell et al., Dynamics of Rotating Machines, ex. 5.9.3, como o verifica o programa ROSS
ross-divides-these-values-by-2-and-compares-them-with-a-tolerance-of-100-interpreted-as-hertz-they = O ROSS divide estes valores por 2π e os compara com uma tolerância de 100 %; interpretados como hertz, estão corretos.
the-printed-value-was-computed-with-another-mesh-78-745-with-six-elements = o valor impresso foi calculado com outra malha: 78,745 com seis elementos
the-printed-value-was-computed-with-another-mesh-120-33-with-six-elements = o valor impresso foi calculado com outra malha: 120,33 com seis elementos
two-discs-on-cross-coupled-bearings-as-labelled = Dois discos em mancais com acoplamento cruzado, conforme indicado
m-i-friswell-et-al-dynamics-of-rotating-machines-ex-5-9-4-as-the-program-ross-asserts-it = M. I. Friswell et al., Dynamics of Rotating Machines, ex. 5.9.4, como o verifica o programa ROSS
the-second-value-14-80-hz-is-14-79-hz-at-4000-rpm = O segundo valor, 14,80 Hz, é 14,79 Hz a 4000 rpm.
at-4000-rpm-the-value-is-11-652-hz-the-printed-list-is-given-for-that-speed-but-is-that-of-the-rotor = A 4000 rpm o valor é 11,652 Hz; a lista impressa traz essa rotação, mas é a do rotor em repouso, com quatro algarismos.
at-4000-rpm-the-value-is-33-155-hz-the-printed-list-is-given-for-that-speed-but-is-that-of-the-rotor = A 4000 rpm o valor é 33,155 Hz; a lista impressa traz essa rotação, mas é a do rotor em repouso, com quatro algarismos.
at-4000-rpm-the-value-is-49-686-hz-the-printed-list-is-given-for-that-speed-but-is-that-of-the-rotor = A 4000 rpm o valor é 49,686 Hz; a lista impressa traz essa rotação, mas é a do rotor em repouso, com quatro algarismos.
at-4000-rpm-the-value-is-89-401-hz-the-printed-list-is-given-for-that-speed-but-is-that-of-the-rotor = A 4000 rpm o valor é 89,401 Hz; a lista impressa traz essa rotação, mas é a do rotor em repouso, com quatro algarismos.
at-4000-rpm-the-value-is-133-721-hz-the-printed-list-is-given-for-that-speed-but-is-that-of-the-rotor = A 4000 rpm o valor é 133,721 Hz; a lista impressa traz essa rotação, mas é a do rotor em repouso, com quatro algarismos.
two-discs-on-cross-coupled-bearings-at-rest = Dois discos em mancais com acoplamento cruzado, em repouso
the-printed-list-is-labelled-4000-rpm-it-holds-at-rest = A lista impressa está rotulada como de 4000 rpm; ela vale em repouso.
the-printed-value-was-computed-with-another-mesh-97-944-with-six-elements = o valor impresso foi calculado com outra malha: 97,944 com seis elementos
the-printed-value-was-computed-with-another-mesh-126-568-with-six-elements = o valor impresso foi calculado com outra malha: 126,568 com seis elementos
example-rotor-of-ross-at-100-rad-s = Rotor de exemplo do ROSS a 100 rad/s
ross-2-3-0-rotor-example = ROSS 2.3.0, rotor_example
damped-rotor-of-thirty-elements-with-its-unbalance-response = Rotor amortecido de trinta elementos, com a sua resposta ao desbalanceamento
ross-2-3-0-1-5-m-two-equal-discs-30-elements-at-400-rad-s = ROSS 2.3.0: 1,5 m, dois discos iguais, 30 elementos, a 400 rad/s
stepped-rotor-of-18-stations-synchronous-whirl = Rotor escalonado de 18 estações, precessão síncrona
h-d-nelson-and-j-m-mcvaugh-1976-targets-of-the-verification-problem-vm247-of-ansys-mechanical-apdl = H. D. Nelson e J. M. McVaugh (1976); valores de referência do problema de verificação VM247 do Ansys Mechanical APDL
the-stations-are-those-of-the-input-file-of-vm247-shear-is-neglected-the-first-third-and-fifth-modes = As estações são as do arquivo de entrada do VM247; o cisalhamento é desprezado. O primeiro, o terceiro e o quinto modos têm precessão retrógrada.
the-paper-reduces-its-model-before-it-solves-one-beam-element-a-station-without-reduction-gives-15486 = o artigo reduz o seu modelo antes de resolvê-lo; um elemento de viga por estação, sem redução, dá 15486 rpm
the-paper-reduces-its-model-before-it-solves-one-beam-element-a-station-without-reduction-gives-17148 = o artigo reduz o seu modelo antes de resolvê-lo; um elemento de viga por estação, sem redução, dá 17148 rpm
the-paper-reduces-its-model-before-it-solves-one-beam-element-a-station-without-reduction-gives-46749 = o artigo reduz o seu modelo antes de resolvê-lo; um elemento de viga por estação, sem redução, dá 46749 rpm
the-paper-reduces-its-model-before-it-solves-one-beam-element-a-station-without-reduction-gives-50128 = o artigo reduz o seu modelo antes de resolvê-lo; um elemento de viga por estação, sem redução, dá 50128 rpm
the-paper-reduces-its-model-before-it-solves-one-beam-element-a-station-without-reduction-gives-64858 = o artigo reduz o seu modelo antes de resolvê-lo; um elemento de viga por estação, sem redução, dá 64858 rpm
the-paper-reduces-its-model-before-it-solves-one-beam-element-a-station-without-reduction-gives-95883 = o artigo reduz o seu modelo antes de resolvê-lo; um elemento de viga por estação, sem redução, dá 95883 rpm
stepped-rotor-of-18-stations-whirl-at-four-times-the-spin-speed = Rotor escalonado de 18 estações, precessão a quatro vezes a rotação
the-paper-reduces-its-model-before-it-solves-one-beam-element-a-station-without-reduction-gives-4016 = o artigo reduz o seu modelo antes de resolvê-lo; um elemento de viga por estação, sem redução, dá 4016,8 rpm
the-paper-reduces-its-model-before-it-solves-one-beam-element-a-station-without-reduction-gives-4120 = o artigo reduz o seu modelo antes de resolvê-lo; um elemento de viga por estação, sem redução, dá 4120,5 rpm
the-paper-reduces-its-model-before-it-solves-one-beam-element-a-station-without-reduction-gives-12025 = o artigo reduz o seu modelo antes de resolvê-lo; um elemento de viga por estação, sem redução, dá 12025 rpm
the-paper-reduces-its-model-before-it-solves-one-beam-element-a-station-without-reduction-gives-12236 = o artigo reduz o seu modelo antes de resolvê-lo; um elemento de viga por estação, sem redução, dá 12236 rpm
the-paper-reduces-its-model-before-it-solves-one-beam-element-a-station-without-reduction-gives-18189 = o artigo reduz o seu modelo antes de resolvê-lo; um elemento de viga por estação, sem redução, dá 18189 rpm
the-paper-reduces-its-model-before-it-solves-one-beam-element-a-station-without-reduction-gives-20130 = o artigo reduz o seu modelo antes de resolvê-lo; um elemento de viga por estação, sem redução, dá 20130 rpm
shaft-with-internal-viscous-damping-above-its-first-critical-speed = Eixo com amortecimento viscoso interno acima da sua primeira velocidade crítica
e-s-zorzi-and-h-d-nelson-1976-targets-of-the-verification-problem-vm261-of-ansys-mechanical-apdl = E. S. Zorzi e H. D. Nelson (1976); valores de referência do problema de verificação VM261 do Ansys Mechanical APDL
five-elements-over-the-length-bending-only-the-decrement-is-printed-without-its-sign = Cinco elementos ao longo do comprimento, somente flexão. O decremento está impresso sem o sinal.
the-reference-is-read-off-a-campbell-diagram-forward-whirl-meets-the-line-at-5000-rpm = a referência é lida de um diagrama de Campbell; a precessão direta encontra a reta a 5000 rpm
the-reference-is-read-off-a-campbell-diagram-forward-whirl-meets-the-line-at-10525-rpm = a referência é lida de um diagrama de Campbell; a precessão direta encontra a reta a 10525 rpm
read-off-a-figure-the-decrement-of-the-first-forward-mode-at-539-25-rad-s-is-0-0038-the-sign = Lido de uma figura. O decremento do primeiro modo direto a 539,25 rad/s é −0,0038; o sinal, instabilidade acima da primeira velocidade crítica, é o mesmo.
the-same-shaft-above-its-second-critical-speed = O mesmo eixo acima da sua segunda velocidade crítica
read-off-a-figure-the-decrement-of-the-second-forward-mode-at-1444-rad-s-is-0-0166-the-sign = Lido de uma figura. O decremento do segundo modo direto a 1444 rad/s é −0,0166; o sinal, instabilidade acima da velocidade crítica, é o mesmo.
uniform-shaft-on-rigid-bearings = Eixo uniforme em mancais rígidos
a-1-ik-a-2-ik-eik-with-k-n-l-critical-at-eik-a-1-ik-a-forward-1-3ik-a-backward = ρA(1 + Ik²/A)ω² ∓ 2ρIk²Ωω = EIk⁴ com k = nπ/L; crítica em ω² = EIk⁴/(ρA(1 ∓ Ik²/A)) na precessão direta, 1 + 3Ik²/A na retrógrada
twelve-elements = doze elementos
internal-damping-onset-of-instability-of-a-shaft-on-rigid-bearings-at-its-critical-speed = Amortecimento interno, início da instabilidade de um eixo em mancais rígidos na velocidade crítica
with-v-alone-the-whirl-frequency-is-at-the-damping-stability-limit-where-at-the-forward-critical = Só com η_v, a frequência de precessão ω está no limite de estabilidade do amortecimento onde ω = Ω: na velocidade crítica direta, 4714,72 rpm
bearings-with-stiffness-rising-with-speed = Mancais com rigidez crescente com a rotação
short-stiff-shaft-on-two-bearings-m-2k-with-and-k-10-kn-m-390-kn-m-3000-rpm-m-12-3308-kg = Eixo curto e rígido sobre dois mancais: mω² = 2k(Ω) com ω = Ω e k = 10 kN/m + Ω·390 kN/m/(3000 rpm); m = 12,3308 kg
the-shaft-is-not-quite-rigid = o eixo não é totalmente rígido
the-same-bearings-their-table-from-500-rpm-on = Os mesmos mancais, com a tabela a partir de 500 rpm
the-same-shaft-along-x-half-of-that-linear-stiffness-speed-relation-along-y-all-of-it = O mesmo eixo; na direção x, metade dessa relação linear entre rigidez e rotação; na direção y, toda ela
the-diagrams-start-at-the-first-point-of-the-tables = Os diagramas começam no primeiro ponto das tabelas.
diagrams-beyond-the-table-of-a-bearing = Diagramas além da tabela de um mancal
no-bearing-data-are-available-beyond-the-last-row-of-its-table = Não há dados de um mancal além da última linha da sua tabela
a-disc-beside-the-shaft = Disco fora do eixo
a-disc-must-be-located-on-the-shaft = Um disco deve estar sobre o eixo
a-shaft-compressed-beyond-buckling = Eixo comprimido além da flambagem
euler-ei-l-248-05-kn = Euler: π²EI/L² = 248,05 kN
disc-on-a-light-shaft-in-anisotropic-bearings-backward-whirl = Disco num eixo leve em mancais anisotrópicos, precessão retrógrada
closed-form-1-d-a-b-3eil-b-l-k-sc-a-l-k-sc-of-shaft-and-bearings-along-x-and-along-y-d-s-ms-0-and-x-u = forma fechada: 1/D = a²b²/(3EIL) + b²/(L²(k₁ + sc₁)) + a²/(L²(k₂ + sc₂)) de eixo e mancais ao longo de x e ao longo de y; D(s) + ms² = 0, e X = U Ω² e^(iα)/(D − mΩ²), Y com −i, em s = iΩ
at-2000-rpm-the-shaft-rotates-between-its-two-critical-speeds-and-the-whirl-is-backward = A 2000 rpm o eixo gira entre as suas duas velocidades críticas, e a precessão é retrógrada.

# shaft_clearance.toml
francis-turbine-with-a-damping-ratio-of-0-30 = Turbina Francis com fator de amortecimento de 0,30
lists-06-08-list-08-question-3 = Listas 06–08, lista 08, questão 3
length-and-young-s-modulus-are-those-of-the-figure-of-rao-s-example-2-m-and-207-gpa-with-0-30-the = O comprimento e o módulo de elasticidade são os da figura do exemplo de Rao, 2 m e 207 GPa. Com ζ = 0,30 a amplitude nunca passa de 0,035 mm, de modo que todo diâmetro é permitido.
the-printed-solution-uses-the-damping-ratio-in-place-of-the-coefficient-c-0-3-n-s-m-which-is-almost = A solução impressa usa o fator de amortecimento no lugar do coeficiente, c = 0,3 N·s/m, o que é quase nenhum amortecimento, considera apenas a maior rotação e omite a operação supercrítica. Com ζ = 0,30 a amplitude máxima de qualquer eixo é 0,0349 mm, contra uma folga de 5 mm: todo diâmetro é permitido.
francis-turbine-with-a-damping-ratio-of-0-30-corrected = Turbina Francis com fator de amortecimento de 0,30, corrigida
lists-06-08-list-08-question-3-with-the-peak-e-2-1 = Listas 06–08, lista 08, questão 3, com o pico e/(2ζ√(1 − ζ²))
the-turbine-without-damping = A turbina sem amortecimento
lists-06-08-list-08-question-3-with-k-m-m-e-r-at-480-and-7200-rpm = Listas 06–08, lista 08, questão 3, com k = (m ∓ m₀e/R)ω² a 480 e 7200 rpm
between-supercritical-and-subcritical-operation-the-critical-speed-falls-within-the-range = Entre a operação supercrítica e a subcrítica, a velocidade crítica cai dentro da faixa.
the-turbine-with-30-read-as-0-3-n-s-m = A turbina com 30 % lido como 0,3 N·s/m
lists-06-08-list-08-question-3-with-the-coefficient-of-the-printed-solution = Listas 06–08, lista 08, questão 3, com o coeficiente da solução impressa
the-printed-stiffness-and-diameter-are-those-of-subcritical-operation-supercritical-operation-is = A rigidez e o diâmetro impressos são os da operação subcrítica; falta a supercrítica.
supercritical-operation-is-missing-diameters-up-to-113-4-mm-also-keep-the-rotor-clear-above-its = Falta a operação supercrítica: diâmetros de até 113,4 mm também mantêm o rotor sem contato, acima da sua velocidade crítica.
the-turbine-of-the-textbook-without-damping-and-margins = A turbina do livro, sem amortecimento nem margens
s-s-rao-mechanical-vibrations-4th-ed-ex-3-5 = S. S. Rao, Mechanical Vibrations, 4ª ed., ex. 3.5
the-printed-solution-solves-m-e-k-m-r-at-600-rpm-which-there-is-the-subcritical-side-of-the-resonance = A solução impressa resolve m₀eω²/(k − mω²) = R a 600 rpm, que ali é o lado subcrítico da ressonância. Um eixo de 127,0 mm tem a sua velocidade crítica em 601 rpm, dentro da faixa. Os eixos supercríticos terminam em 126,74 mm, os subcríticos começam em 401,6 mm.
the-turbine-of-the-textbook-corrected = A turbina do livro, corrigida
s-s-rao-mechanical-vibrations-4th-ed-ex-3-5-with-k-m-m-e-r-at-600-and-6000-rpm = S. S. Rao, Mechanical Vibrations, 4ª ed., ex. 3.5, com k = (m ∓ m₀e/R)ω² a 600 e 6000 rpm
the-turbine-with-negligible-damping = A turbina com amortecimento desprezível
k-m-1-2-m-e-m-r-4-1-with-0-001-the-peak-e-2-1-at-1-2 = k/(m ω²) = 1 − 2ζ² ∓ √((m₀e/(m R))² − 4ζ²(1 − ζ²)) com ζ = 0,001; o pico e/(2ζ√(1 − ζ²)) em ωₙ/√(1 − 2ζ²)
the-undamped-turbine-with-shafts-from-150-to-400-mm-only = A turbina sem amortecimento, só com eixos de 150 a 400 mm
the-permitted-diameters-up-to-113-4-mm-or-from-439-9-mm-include-none-of-these = Os diâmetros permitidos, de até 113,4 mm ou a partir de 439,9 mm, não incluem nenhum destes
a-shaft-on-two-bearings = Eixo em dois mancais
d-64-k-l-48-e-with-k-m-m-e-r = d = ⁴√(64 k L³/(48 π E)) com k = (m ∓ m₀e/R)ω²
speeds-in-the-wrong-order = Rotações na ordem errada
a-range-begins-with-its-lowest-speed = Uma faixa começa pela sua menor rotação
stiffness-of-the-textbook-turbine = Rigidez da turbina do livro
largest-unbalance-of-a-damped-rotor-that-runs-through-its-resonance = Maior desbalanceamento de um rotor amortecido que atravessa a sua ressonância
the-peak-e-2-1-is-the-clearance-e-2-0-05-1-0-05-5-mm = O pico e/(2ζ√(1 − ζ²)) é a folga: e = 2·0,05·√(1 − 0,05²)·5 mm
largest-eccentricity-of-an-undamped-rotor-below-its-critical-speed = Maior excentricidade de um rotor sem amortecimento abaixo da sua velocidade crítica
e-r-1-r-r-with-r-m-k-at-half-the-critical-speed-3r = e = R(1 − r²)/r² com r² = ω²m/k; na metade da velocidade crítica, 3R
no-admissible-eccentricity = Nenhuma excentricidade admissível
an-undamped-rotor-with-its-critical-speed-within-the-range-rao-5th-ed-9-5 = Um rotor sem amortecimento com a velocidade crítica dentro da faixa (Rao, 5ª ed., §9.5)
speeds-of-the-textbook-turbine-on-its-shaft-of-127-mm = Rotações da turbina do livro no seu eixo de 127 mm
s-s-rao-mechanical-vibrations-4th-ed-ex-3-5-with-r-r-e = S. S. Rao, Mechanical Vibrations, 4ª ed., ex. 3.5, com ω = ωₙ√(R/(R ± e))
the-range-of-600-to-6000-rpm-begins-inside-the-forbidden-range-the-shaft-of-the-book-touches-the = A faixa de 600 a 6000 rpm começa dentro da faixa proibida: o eixo do livro toca o estator assim que passa de 600 rpm.
every-speed-of-the-damped-turbine = Qualquer rotação da turbina amortecida
the-peak-e-2-1-is-below-the-clearance-from-0-002-on = O pico e/(2ζ√(1 − ζ²)) fica abaixo da folga a partir de ζ = 0,002
stiffnesses-of-the-textbook-turbine-up-to-50-mn-m = Rigidezes da turbina do livro até 50 MN/m
s-s-rao-mechanical-vibrations-4th-ed-ex-3-5-subcritical-operation-begins-at-99-09-mn-m = S. S. Rao, Mechanical Vibrations, 4ª ed., ex. 3.5: a operação subcrítica começa em 99,09 MN/m

# shaft_with_discs.toml
three-loads-on-a-shaft-of-3-m = Três cargas num eixo de 3 m
the-companion-uses-the-second-load-2000-n-in-place-of-the-third-1000-n-with-the-loads-of-the = O complemento usa a segunda carga, 2000 N, no lugar da terceira, 1000 N. Com as cargas do enunciado a fórmula de Dunkerley dá 4,276 Hz; com 2000 N duas vezes dá 4,076 Hz.
the-three-loads-with-the-error-of-the-companion = As três cargas com o erro do material de apoio
the-printed-frequency-follows-from-the-error-the-companion-takes-as-3-147-and-f-as-0-4985 = A frequência impressa decorre do erro; o complemento toma π como 3,147 e f como 0,4985/√δ.
one-load-and-a-heavy-shaft = Uma carga e um eixo pesado
the-density-of-40000-kg-m-is-that-of-the-statement-the-exact-value-is-that-of-the-dynamic-stiffness = A massa específica de 40000 kg/m³ é a do enunciado. O valor exato é o da rigidez dinâmica.
the-companion-takes-as-3-147-and-f-as-0-4985 = o complemento toma π como 3,147 e f como 0,4985/√δ
three-masses-and-the-weight-of-the-shaft = Três massas e o peso do eixo
the-companion-calls-1962-the-weight-of-the-shaft-in-n-its-formula-and-the-density-of-steel-imply-1962 = O complemento chama 1962 de peso do eixo em N; a sua fórmula e a massa específica do aço implicam 1962 N por metro.
one-disc-at-the-middle = Um disco no meio
n-48ei-l-m-rao-5th-ed-2-2-with-one-disc-all-methods-are-exact = ω² = 48EI/(L³m) (Rao, 5ª ed., §2.2): com um só disco todos os métodos são exatos
e-i-4-kn-m-48-4000-10-138-564-rad-s = E I = 4 kN·m²: ω = √(48·4000/10) = 138,564 rad/s.
shaft-with-a-disc-of-negligible-mass = Eixo com um disco de massa desprezível
ei-m-l-with-the-static-deflection-rayleigh-s-quotient-gives-1-00144-times-that-rao-5th-ed-8-5-8-7 = ω = π²√(EI/(m̄L⁴)); com a deflexão estática, Rayleigh dá π²√(1,00144…) disso (Rao, 5ª ed., §§8.5, 8.7)
e-i-4-kn-m-m-4-kg-m-312-104-rad-s-rayleigh-s-quotient-with-the-deflection-under-self-weight-wy-m-y = E I = 4 kN·m², m̄ = 4 kg/m: 312,104 rad/s. Quociente de Rayleigh com a deflexão sob o peso próprio: ω² = (∫wy)/(∫m̄y²) = 3024/31·EI/(m̄L⁴), 312,327 rad/s.
e-i-y-by-singularity-functions-unit-loads-one-after-the-other-a-2-66667-a-3-33333-a-2-m-n-det-a-m-1-0 = E I y'' por funções de singularidade, uma carga unitária de cada vez: a₁₁ = 2,66667, a₂₂ = 3,33333, a₁₂ = −2 µm/N; det(A M − 1/ω²) = 0
disc-on-an-overhang = Disco num trecho em balanço
n-3ei-c-l-c-m-shigley-table-a-9 = ω² = 3EI/(c²(l + c)m) (Shigley, tabela A-9)
l-0-8-m-c-0-2-m-e-i-4-kn-m-5-kg-3-4000-0-04-1-5-244-949-rad-s = l = 0,8 m, c = 0,2 m, E I = 4 kN·m², 5 kg: ω = √(3·4000/(0,04·1·5)) = 244,949 rad/s.
l-0-8-m-c-0-2-m-e-i-4-kn-m-the-weight-of-one-disc-lifts-the-other-rayleigh-s-quotient-with-the-static = l = 0,8 m, c = 0,2 m, E I = 4 kN·m². O peso de um disco levanta o outro: o quociente de Rayleigh com a forma estática erra muito.
cantilever-with-two-discs-and-its-own-mass = Eixo em balanço com dois discos e a sua massa própria
dynamic-stiffness-verified-with-the-strain-and-kinetic-energy-of-the-mode-shape = Rigidez dinâmica; verificada com as energias de deformação e cinética da forma modal
a-disc-beyond-the-shaft = Disco além do eixo
the-disc-must-stand-on-the-shaft = O disco tem de estar sobre o eixo
density-without-the-area-of-the-section = Massa específica sem a área da seção
e-i-4-kn-m-m-10-kg-antisymmetric-mode-1-2-m-l-768ei = E I = 4 kN·m², m = 10 kg: modo antissimétrico 1/ω² = 2 m L³/768EI.
i-24-100-12-mm-2-10-m-e-i-400-kn-m-48-400000-1000-138-564-rad-s = I = 24·100³/12 mm⁴ = 2·10⁻⁶ m⁴, E I = 400 kN·m²: ω = √(48·400000/1000) = 138,564 rad/s.
rectangular-bar-with-a-mass-at-the-middle = Barra retangular com uma massa no meio
the-mass-per-unit-length-is-the-density-times-the-area = A massa por unidade de comprimento é a massa específica vezes a área
three-equal-discs-at-the-quarters = Três discos iguais nos quartos do vão
a-9-a-11-a-7-a-16-l-768ei-1-m-l-768ei-16-11-2-and-2-34-by-dunkerley-and-2902-92-by-rayleigh = a₁₁ = 9, a₁₂ = 11, a₁₃ = 7, a₂₂ = 16 (L³/768EI): 1/ω² = m L³/768EI × (16 ± 11√2) e 2; 34 por Dunkerley e 2902/92 por Rayleigh
heavy-shaft-with-one-disc-off-the-middle = Eixo pesado com um disco fora do meio
heavy-cantilever-with-two-unequal-discs = Eixo pesado em balanço com dois discos desiguais
heavy-shaft-with-discs-between-the-bearings-and-on-the-overhang = Eixo pesado com discos entre os mancais e no trecho em balanço
closed-form-roots-of-the-beam-equation-by-transfer-matrices-rayleigh-s-quotient-m-gy-dx-mgy-m-y-dx-my = forma fechada: raízes da equação da viga por matrizes de transferência; quociente de Rayleigh (∫m̄gy dx + Σmgy)/(∫m̄y² dx + Σmy²) da deflexão por funções de singularidade; Dunkerley 1/ω² = Σma + 1/ω_s²
in-the-first-mode-the-discs-move-in-opposite-directions-while-their-weights-act-in-the-same-direction = No primeiro modo os discos se movem em sentidos opostos, enquanto os seus pesos atuam no mesmo sentido: o quociente de Rayleigh da deflexão estática fica 47 % alto demais.

# shock_response_spectrum.toml
half-sine-pulse-on-undamped-oscillators = Pulso de meia-onda senoidal em osciladores sem amortecimento
shock-spectrum-of-a-half-sine-pulse-1-77-at-t-d-t-0-81-quoted-in-many-texts-among-them-c-m-harris-and = Espectro de choque de um pulso de meia-onda senoidal, 1,77 em t_d/T = 0,81: citado em muitos textos, entre eles C. M. Harris e A. G. Piersol, Harris' Shock and Vibration Handbook, cap. 8
the-same-to-more-digits = O mesmo, com mais algarismos
the-maximum-primary-response-to-the-half-sine-sin-2-r-1-r-1-r-with-r-t-2t-d-over-r = A resposta primária máxima à meia-onda senoidal, sen(2π r/(1 + r))/(1 − r) com r = T/(2t_d), sobre r
at-100-hz-the-pulse-lasts-1-1-periods-the-residual-is-4n-cos-n-1-4n = A 100 Hz o pulso dura 1,1 período; o residual é 4n cos(πn)/(1 − 4n²).
amplification-2-sin-n-up-to-n-1-2-2-from-there-on-rao-5th-ed-4-6 = Amplificação 2 sen(πn) até n = 1/2, 2 a partir daí (Rao, 5ª ed., §4.6)
terminal-peak-sawtooth-with-a-twentieth-of-critical-damping = Dente de serra de pico final com um vigésimo do amortecimento crítico
runge-kutta-integration-of-the-motion-relative-to-the-base = Integração de Runge–Kutta do movimento relativo à base
acceleration-record-by-a-table = Registro de aceleração por uma tabela
the-table-of-a-rectangle-reproduces-the-rectangle-2-sin-n = A tabela de um retângulo reproduz o retângulo: 2 sen(πn)
range-of-zero-width = Faixa de largura nula
a-spectrum-needs-a-range = Um espectro precisa de uma faixa

# spring_network.toml
mass-on-a-rubber-pad-above-a-felt-pad = Massa sobre um coxim de borracha acima de um coxim de feltro
the-book-combines-the-springs-in-series-and-the-dampers-in-series-the-exact-root-of-the-third-order = O livro associa as molas em série e os amortecedores em série; a raiz exata da equação de terceira ordem é dada ao lado.
the-two-pads-exactly = Os dois coxins com exatidão
m-c-c-s-m-k-k-c-c-s-k-c-k-c-s-k-k-0 = m (c₁ + c₂) s³ + (m (k₁ + k₂) + c₁ c₂) s² + (k₁ c₂ + k₂ c₁) s + k₁ k₂ = 0
for-a-kelvin-voigt-element-in-series-with-another-only-the-form-k-cs-is-exact-treating-spring-and = Para um elemento de Kelvin–Voigt em série com outro só a forma k + cs é exata; tratar mola e amortecedor separadamente dá aqui um erro de 0,03 % na frequência.
bridge-of-springs = Ponte de molas
balanced-bridge-the-cross-spring-carries-no-force-and-two-series-pairs-are-in-parallel = Ponte equilibrada: a mola transversal não transmite força, e dois pares em série ficam em paralelo
n-3-and-6-kn-m-in-series-are-2-kn-m-6-and-12-kn-m-in-series-are-4-kn-m = 3 e 6 kN/m em série são 2 kN/m, 6 e 12 kN/m em série são 4 kN/m.
spring-in-parallel-with-a-spring-and-damper-in-series = Mola em paralelo com mola e amortecedor em série
standard-linear-solid-k-i-k-k-i-c-k-i-c = Sólido linear padrão: k(iω) = k₁ + k₂ iωc/(k₂ + iωc)
at-k-c-the-branch-gives-k-1-i-2 = Em ω = k₂/c o ramo dá k₂ (1 + i)/2.
two-masses-in-series = Duas massas em série
equal-masses-and-springs-one-end-fixed-2-k-m-sin-10-and-sin-3-10 = Massas e molas iguais, uma extremidade fixa: ω = 2 √(k/m) sen(π/10) e sen(3π/10)
unsupported-node = Nó sem apoio
no-such-equilibrium-exists = Um equilíbrio assim não existe
mass-excited-at-its-natural-frequency = Massa excitada na sua frequência natural

# string_rod_shaft.toml
guitar-string = Corda de violão
r-d-blevins-formulas-for-natural-frequency-and-mode-shape-table-7-1-target-of-the-verification = R. D. Blevins, Formulas for Natural Frequency and Mode Shape, tabela 7-1; valor de referência do problema de verificação VM76 do Ansys Mechanical APDL
a-string-of-0-71-m-under-84-n-fixed-at-both-ends = Uma corda de 0,71 m sob 84 N, fixa nas duas extremidades.
stretched-wire = Fio esticado
w-t-thomson-vibration-theory-and-applications-art-8-2-target-of-the-verification-problem-vm53-of = W. T. Thomson, Vibration Theory and Applications, art. 8.2; valor de referência do problema de verificação VM53 do Ansys Mechanical APDL
n-100-in-under-500-lbf-fixed-at-both-ends-the-density-is-0-00073-lbf-s-in = 100 in sob 500 lbf, fixa nas duas extremidades; a massa específica é 0,00073 lbf·s²/in⁴.
drill-pipe-with-a-collar = Tubo de perfuração com um comando
w-t-thomson-vibration-theory-and-applications-ex-8-4-5-target-of-the-verification-problem-vm57-of = W. T. Thomson, Vibration Theory and Applications, ex. 8.4-5; valor de referência do problema de verificação VM57 do Ansys Mechanical APDL
n-5000-ft-of-tube-fixed-at-the-top-the-collar-of-29-3-lbf-ft-s-at-its-lower-end-density-15-2174-slug = 5000 ft de tubo, fixo no topo, com o colar de 29,3 lbf·ft·s² na extremidade inferior; massa específica de 15,2174 slug/ft³.
free-rod = Barra livre
w-t-thomson-vibration-theory-and-applications-ex-8-3-1-target-of-the-verification-problem-vm61-of = W. T. Thomson, Vibration Theory and Applications, ex. 8.3-1; valor de referência do problema de verificação VM61 do Ansys Mechanical APDL
n-800-in-of-steel-free-at-both-ends-the-source-counts-the-rigid-body-motion-as-the-first-mode-its = 800 in de aço, livre nas duas extremidades. A fonte conta o movimento como corpo rígido como primeiro modo; a segunda e a terceira frequências dela são aqui a primeira e a segunda.
tower-of-thin-walls-in-shear = Torre de paredes finas em cisalhamento
r-d-blevins-formulas-for-natural-frequency-and-mode-shape-target-of-the-verification-problem-vm202-of = R. D. Blevins, Formulas for Natural Frequency and Mode Shape; valor de referência do problema de verificação VM202 do Ansys Mechanical APDL
a-square-tube-10-m-wide-and-30-m-high-clamped-at-its-base = Um tubo quadrado, de 10 m de largura e 30 m de altura, engastado na base.
the-frequencies-of-a-shear-beam-clamped-at-one-end-are-in-the-ratio-1-3-5-so-that-the-first-target-17 = As frequências de uma viga de cisalhamento engastada numa extremidade estão na razão 1 : 3 : 5, de modo que o primeiro valor de referência, 17,375 Hz, dá 52,126 Hz para o segundo.
deep-square-beam-in-torsion = Viga alta de seção quadrada em torção
nafems-test-fv5-torsional-modes-target-in-the-verification-problem-vmp09-t5-of-ansys-mechanical-apdl = NAFEMS, teste FV5, modos torcionais; valor de referência no problema de verificação VMP09-T5 do Ansys Mechanical APDL
n-10-m-long-and-2-m-by-2-m-torsion-is-restrained-at-one-end-only = 10 m de comprimento e 2 m por 2 m; a torção é impedida em uma só extremidade.
the-target-takes-the-torsion-constant-of-the-square-as-0-1406-a-saint-venant-s-series-gives-0-140577 = o valor de referência toma a constante de torção do quadrado como 0,1406 a⁴; a série de Saint-Venant dá 0,140577 a⁴
deep-square-beam-in-torsion-with-the-constant-of-the-tables = Viga alta de seção quadrada em torção com a constante das tabelas
the-torsion-constant-is-0-1406-a = A constante de torção é 0,1406 a⁴.
deep-square-beam-axial = Viga alta de seção quadrada, axial
nafems-test-fv5-axial-mode-target-in-the-verification-problem-vmp09-t5-of-ansys-mechanical-apdl = NAFEMS, teste FV5, modo axial; valor de referência no problema de verificação VMP09-T5 do Ansys Mechanical APDL
short-beam-axial = Viga curta, axial
code-aster-validation-manual-v2-test-sdll01-axial-modes = Manual de validação do Code_Aster, V2, teste SDLL01, modos axiais
axially-fixed-at-one-end-only = Fixo axialmente em uma só extremidade.
rod-with-its-own-mass-at-its-end = Barra com a sua própria massa na extremidade
tan-1-for-a-mass-equal-to-that-of-the-rod-rao-5th-ed-8-3 = β tan β = 1 para uma massa igual à da barra (Rao, 5ª ed., §8.3)
a-spring-as-stiff-as-the-rod = Mola tão rígida quanto a barra
tan-for-a-rod-fixed-at-one-end-with-a-spring-ea-l-at-the-other = tan β = −β para uma barra fixa numa extremidade, com uma mola EA/L na outra
a-light-rod-between-two-masses = Barra leve entre duas massas
two-masses-on-a-spring-ea-l-ea-l-1-m-1-m-where-the-mass-of-the-rod-is-negligible = Duas massas sobre uma mola EA/L: ω² = (EA/L)(1/m₁ + 1/m₂), quando a massa da barra é desprezível
weight-of-a-cable = Peso de um cabo
c-t-g-w-f-c-2l = c = √(T g/w), f = c/(2L)
a-cable-of-20-n-m-under-50-kn-c-50000-9-81-20-156-605-m-s = Um cabo de 20 N/m sob 50 kN: c = √(50000·9,81/20) = 156,605 m/s.
a-density-without-an-area = Massa específica sem área
the-mass-per-unit-length-is-density-times-area = A massa por unidade de comprimento é a massa específica vezes a área

# swing_test.toml
connecting-rod-on-a-knife-edge = Biela sobre um cutelo
g-t-4-j-o-m-s-j-m-s-s = λ = g T²/(4π²), J_O = m s λ, J = m s (λ − s)
fifty-oscillations-in-85-70-s = Cinquenta oscilações em 85,70 s.
uniform-bar-to-check-its-moment-of-inertia = Barra uniforme, para conferir o seu momento de inércia
j-m-l-12-with-l-1-2-m-t-2-s-g-s-with-s-0-5-m = J = m L²/12 com L = 1,2 m, T = 2π √((κ² + s²)/(g s)) com s = 0,5 m
the-rod-with-an-amplitude-of-60 = A biela com amplitude de 60°
t-t-agm-1-cos-2 = T₀ = T agm(1, cos θ₀/2)
if-treated-as-small-these-oscillations-would-give-a-moment-of-inertia-more-than-50-too-large = Tomadas como pequenas, estas oscilações dariam um momento de inércia maior em mais da metade.
a-weight-in-pounds = Um peso em libras
g-t-4-j-m-s-s-m-w-g = λ = g T²/(4π²), J = m s (λ − s), m = W/g
two-points-the-centre-of-mass-between-them = Dois pontos, com o centro de massa entre eles
h-l-l-2l-h-h-periods-of-0-2-m-at-0-3-m-and-0-15-m-to-0-1-ms = h₁ = L (L − λ₂)/(2L − λ₁ − λ₂), κ² = h₁ (λ₁ − h₁); períodos para κ = 0,2 m a 0,3 m e 0,15 m, com precisão de 0,1 ms
two-points-on-one-side-of-the-centre-of-mass = Dois pontos de um mesmo lado do centro de massa
h-l-l-2l-periods-of-0-2-m-at-0-3-m-and-0-12-m-to-0-1-ms = h₁ = L (L + λ₂)/(2L − λ₁ + λ₂); períodos para κ = 0,2 m a 0,3 m e 0,12 m, com precisão de 0,1 ms
on-a-trifilar-platform = Numa plataforma trifilar
j-m-m-g-r-t-4-l-m-g-r-t-4-l = J = (m + m₀) g r² T²/(4π² l) − m₀ g r² T₀²/(4π² l)
bifilar-the-wires-wider-at-the-top = Bifilar, com os fios mais afastados em cima
j-m-g-r-r-t-4-h-h-l-r-r = J = m g r R T²/(4π² h), h² = l² − (R − r)²
a-torsion-wire-and-a-known-ring = Fio de torção e um anel conhecido
j-j-a-t-t-a-t-k-t-4-j-a-t-a-t = J = J_a T²/(T_a² − T²), k_t = 4π² J_a/(T_a² − T²)
a-torsion-wire-of-known-stiffness = Fio de torção de rigidez conhecida
j-k-t-t-4 = J = k_t T²/(4π²)
a-known-body-instead-on-the-same-wire = Um corpo conhecido no lugar, no mesmo fio
wheel-rolling-with-its-journals-on-curved-rails = Roda que rola com os munhões em trilhos curvos
g-t-4-r-1 = κ² = ρ² (g T²/(4π² (R − ρ)) − 1)
wheel-rolling-down-inclined-rails = Roda que rola por trilhos inclinados
g-sin-t-2-s-1 = κ² = ρ² (g sen α t²/(2 s) − 1)
a-period-too-short-for-its-distance = Período curto demais para a sua distância
s-for-every-body = λ > s para todo corpo
a-reversible-pendulum = Pêndulo reversível
l-leaves-the-centre-of-mass-indeterminate = λ₁ = λ₂ = L deixa indeterminado o centro de massa

# tapered_beam.toml
triangular-plate-spring = Mola de lâmina triangular
s-timoshenko-vibration-problems-in-engineering-art-62-target-of-the-verification-problem-vm62-of = S. Timoshenko, Vibration Problems in Engineering, art. 62; valor de referência do problema de verificação VM62 do Ansys Mechanical APDL
a-cantilever-16-in-long-4-in-wide-at-the-root-and-tapering-to-a-point-1-in-thick-density-0-000728-lbf = Uma viga em balanço de 16 in, com 4 in de largura na raiz e terminada em ponta, de 1 in de espessura; massa específica de 0,000728 lbf·s²/in⁴.
the-converged-frequency-number-is-7-1565-which-gives-260-72-hz-rayleigh-ritz-an-upper-bound-and-the = O número de frequência convergido é 7,1565, o que dá 260,72 Hz: Rayleigh–Ritz, um limite superior, e o quociente dos momentos concordam em nove algarismos. O valor de referência está 0,6 % abaixo.
triangular-plate-spring-corrected = Mola de lâmina triangular, corrigida
finite-elements-260-716-hz-frequency-number-7-156 = Elementos finitos, 260,716 Hz (número de frequência 7,156)
double-taper-breadth-ratio-4 = Afilamento duplo, razão de larguras 4
h-h-mabie-and-c-b-rogers-j-acoust-soc-am-51-1972-code-aster-validation-manual-test-sdll09-v2-02-009 = H. H. Mabie e C. B. Rogers, J. Acoust. Soc. Am. 51 (1972); manual de validação do Code_Aster, teste SDLL09 (V2.02.009)
a-cantilever-whose-height-tapers-to-a-quarter-and-whose-width-to-a-quarter-the-frequency-numbers-are = Uma viga em balanço cuja altura se reduz a um quarto e cuja largura se reduz a um quarto; os números de frequência são ωL²√(12ρ/E)/h₁ com a altura h₁ da extremidade livre, que aqui é a esquerda.
the-printed-table-is-0-013-below-the-converged-value-23-2921 = a tabela impressa fica 0,013 % abaixo do valor convergido 23,2921
the-printed-table-is-0-024-below-the-converged-value-73-918 = a tabela impressa fica 0,024 % abaixo do valor convergido 73,918
the-printed-table-is-0-032-below-the-converged-value-165-283 = a tabela impressa fica 0,032 % abaixo do valor convergido 165,283
the-printed-table-is-0-025-below-the-converged-value-299-77 = a tabela impressa fica 0,025 % abaixo do valor convergido 299,77
the-printed-table-is-0-015-below-the-converged-value-478-17 = a tabela impressa fica 0,015 % abaixo do valor convergido 478,17
double-taper-breadth-ratio-5 = Afilamento duplo, razão de larguras 5
a-cantilever-whose-height-tapers-to-a-quarter-and-whose-width-to-a-fifth-the-frequency-numbers-are-l = Uma viga em balanço cuja altura se reduz a um quarto e cuja largura se reduz a um quinto; os números de frequência são ωL²√(12ρ/E)/h₁ com a altura h₁ da extremidade livre, que aqui é a esquerda.
the-printed-table-is-0-012-below-the-converged-value-24-3110 = a tabela impressa fica 0,012 % abaixo do valor convergido 24,3110
the-printed-table-is-0-022-below-the-converged-value-75-577 = a tabela impressa fica 0,022 % abaixo do valor convergido 75,577
the-printed-table-is-0-023-below-the-converged-value-167-249 = a tabela impressa fica 0,023 % abaixo do valor convergido 167,249
the-printed-table-is-0-012-below-the-converged-value-480-46 = a tabela impressa fica 0,012 % abaixo do valor convergido 480,46
double-taper-between-two-bounds = Afilamento duplo entre dois limites
rayleigh-ritz-from-above-and-the-quotient-of-the-moments-from-below-which-agree-to-twelve-digits = Rayleigh–Ritz por cima e o quociente dos momentos por baixo, que concordam em doze algarismos
wedge = Cunha
kirchhoff-5-315-ei-a-l-for-a-clamped-wedge-timoshenko-art-62-the-number-is-z-4-with-j-z-i-z-j-z-i-z-0 = Kirchhoff: ω = 5,315 √(EI₀/(ρA₀L⁴)) para uma cunha engastada (Timoshenko, art. 62); o número é z²/4 com J₁(z)I₂(z) + J₂(z)I₁(z) = 0
kirchhoff-8-719-ei-a-l-for-a-clamped-cone-timoshenko-art-62-the-number-is-z-4-with-j-z-i-z-j-z-i-z-0 = Kirchhoff: ω = 8,719 √(EI₀/(ρA₀L⁴)) para um cone engastado (Timoshenko, art. 62); o número é z²/4 com J₂(z)I₃(z) + J₃(z)I₂(z) = 0
no-taper = Sem afilamento
uniform-cantilever-roots-of-cos-cosh-1-rao-5th-ed-8-5 = Viga em balanço uniforme: Λ = β², raízes de cos β cosh β = −1 (Rao, 5ª ed., §8.5)
support-at-a-pointed-end = Apoio em uma extremidade pontiaguda
a-section-without-area-carries-no-load = Uma seção sem área não suporta carga

# torsional_train.toml
three-rotors-on-one-shaft = Três rotores num mesmo eixo
w-r-is-printed-in-long-tons-times-ft-g-32-2-ft-s = W R² está impresso em toneladas longas vezes ft²; g = 32,2 ft/s².
the-printed-value-follows-from-node-positions-read-to-three-figures = o valor impresso decorre de posições dos nós lidas com três algarismos
two-rotors-on-a-shaft-of-five-steps = Dois rotores em um eixo de cinco trechos
w-r-is-printed-in-lb-times-ft-g-32-2-ft-s = W R² está impresso em lb vezes ft²; g = 32,2 ft/s².
the-companion-program-uses-integer-division-so-that-3-5-and-3-7-become-zero-and-the-steps-of-5-in-and = O programa complementar usa divisão inteira, de modo que (3/5)⁴ e (3/7)⁴ se tornam zero e os trechos de 5 in e 7 in desaparecem; com eles a frequência é 22,26 Hz.
two-rotors-on-a-shaft-of-five-steps-corrected = Dois rotores em um eixo de cinco trechos, corrigido
k-j-j-j-j-1-k-32-l-g-d-g-32-2-ft-s = ω = √(k (J₁ + J₂)/(J₁ J₂)), 1/k = Σ 32 l/(π G d⁴), g = 32,2 ft/s²
two-discs-on-a-long-shaft = Dois discos num eixo longo
n-58-16595-was-truncated-not-rounded = 58,16595 foi truncado, não arredondado
the-two-discs-with-half-of-the-shaft-of-twice-the-diameter = Os dois discos com metade do eixo com o dobro do diâmetro
printed-as-a-ratio-of-1-372-to-the-first-frequency-9-257-hz-12-70-hz = Impresso como razão de 1,372 para a primeira frequência, 9,257 Hz: 12,70 Hz.
two-equal-flywheels = Dois volantes iguais
motor-and-pump-through-a-gear-of-three-to-one = Motor e bomba por uma engrenagem de três para um
the-motor-runs-at-1500-rpm-three-times-the-speed-of-the-pump-the-inertia-of-the-gears-is-neglected = O motor gira a 1500 rpm, três vezes a rotação da bomba; a inércia das engrenagens é desprezada.
four-discs-under-a-harmonic-torque = Quatro discos sob um torque harmônico
n-10-kn-m-at-5-rad-s-on-the-second-disc = 10 kN·m a 5 rad/s no segundo disco.
the-printed-amplitudes-are-computed-with-four-significant-figures = as amplitudes impressas são calculadas com quatro algarismos significativos
the-torque-of-the-third-shaft-was-summed-without-that-of-the-first-disc-and-the-external-torque-the = O torque do terceiro eixo foi somado sem o do primeiro disco e sem o torque externo. Os quatro torques de inércia e os 10 kN·m equilibram-se com −1,9604 rad.
three-rotors-with-nodes = Três rotores com nós
a-branched-train-with-geared-sides = Trem ramificado com lados engrenados
three-equal-branches-on-a-hub-k-j-of-a-branch-double-root-and-k-1-j-3-j-h = Três ramos iguais num cubo: ω² = k/J de um ramo, raiz dupla, e k (1/J + 3/J_h)
the-third-branch-is-behind-2-1-gears-with-a-quarter-of-the-stiffness-and-inertia-reduced-it-is-like = O terceiro ramo fica após engrenagens 2:1, com um quarto da rigidez e da inércia: reduzido, é como os outros.
a-disc-between-two-walls-at-a-trial-frequency = Disco entre duas paredes, a uma frequência de tentativa
k-k-j-at-30-rad-s-the-walls-must-supply-900-n-m-rad-less-than-their-capacity-of-2500 = ω = √((k₁ + k₂)/J); em ω = 30 rad/s as paredes devem fornecer 900 N·m/rad a menos que a sua capacidade de 2500
torque-at-a-natural-frequency = Torque numa frequência natural
two-discs-of-1-kg-m-on-50-n-m-rad-10-rad-s = Dois discos de 1 kg·m² ligados por 50 N·m/rad: ω = 10 rad/s
shaft-that-closes-a-loop = Eixo que fecha uma malha
a-torsional-train-must-be-a-tree-no-closed-loops = Um trem torcional deve ser uma árvore (sem malhas fechadas)
motor-and-pump-through-gears-with-inertia = Motor e bomba por engrenagens com inércia
closed-form-det-k-m-0-in-the-angles-of-motor-pinion-and-pump-that-of-the-wheel-being-p-2-5-nodes = forma fechada: det(K − ω²M) = 0 nos ângulos de motor, pinhão e bomba, sendo θ_p/2,5 o da roda; nós onde θ, linear ao longo de cada eixo, se anula, k = πGd⁴/(32L)

# transient_response.toml
beam-with-a-load-that-rises-in-75-ms = Viga com carga que sobe em 75 ms
j-m-biggs-introduction-to-structural-dynamics-p-50-ex-e-target-of-the-verification-problem-vm77-of = J. M. Biggs, Introduction to Structural Dynamics, p. 50, ex. E; valor de referência do problema de verificação VM77 do Ansys Mechanical APDL
n-20-kip-on-the-mass-at-midspan-of-a-simply-supported-beam-the-printed-values-are-read-from-a-chart = 20 kip na massa no meio do vão de uma viga biapoiada. Os valores impressos são lidos de um ábaco.
the-printed-value-is-read-from-a-chart = o valor impresso é lido de um ábaco
it-follows-from-the-chart = decorre do ábaco
the-same-beam-by-the-closed-form-of-the-ramp = A mesma viga pela fórmula fechada da rampa
x-max-1-sin-t-r-t-t-r-t-ramp-with-constant-final-value-rao-5th-ed-4-6 = x_max = δ(1 + |sen(πt_r/T)|/(πt_r/T)), rampa com valor final constante (Rao, 5ª ed., §4.6)
impulse-without-damping = Impulso sem amortecimento
w-t-thomson-vibration-theory-and-applications-art-4-1-target-of-the-verification-problem-vm74-of = W. T. Thomson, Vibration Theory and Applications, art. 4.1; valor de referência do problema de verificação VM74 do Ansys Mechanical APDL
impulse-with-seven-tenths-of-critical-damping = Impulso com sete décimos do amortecimento crítico
step-without-damping = Degrau sem amortecimento
w-t-thomson-vibration-theory-and-applications-art-4-3-target-of-the-verification-problem-vm75-of = W. T. Thomson, Vibration Theory and Applications, art. 4.3; valor de referência do problema de verificação VM75 do Ansys Mechanical APDL
step-with-half-of-critical-damping = Degrau com metade do amortecimento crítico
unit-step-on-a-second-order-system = Degrau unitário num sistema de segunda ordem
c-m-close-and-d-k-frederick-modeling-and-analysis-of-dynamic-systems-p-314-target-of-the-verification = C. M. Close e D. K. Frederick, Modeling and Analysis of Dynamic Systems, p. 314; valor de referência do problema de verificação VME3 do Ansys Mechanical APDL
the-peak-is-required-as-a-multiple-of-the-final-value = O pico é pedido como múltiplo do valor final.
the-peak-is-printed-as-1-5 = o pico está impresso como 1,5
triangular-impulse = Impulso triangular
w-t-thomson-theory-of-vibration-with-applications-prob-4-20 = W. T. Thomson, Theory of Vibration with Applications, probl. 4-20
no-answer-is-printed-the-triangle-is-symmetric-g-386-in-s-the-value-is-the-sum-of-three-ramps = Nenhuma resposta é impressa. O triângulo é simétrico; g = 386 in/s². O valor é a soma de três rampas.
the-same-impulse-applied-instantaneously = O mesmo impulso aplicado instantaneamente
x-max-i-m-w-t-thomson-theory-of-vibration-with-applications-prob-4-20-taken-as-an-ideal-impulse = x_max = I/(m ωₙ): W. T. Thomson, Theory of Vibration with Applications, probl. 4-20, tomado como um impulso ideal
the-triangle-lasts-most-of-a-period-treating-it-as-an-impulse-overestimates-the-motion-by-two-thirds = O triângulo dura a maior parte de um período: tomá-lo como impulso superestima o movimento em dois terços.
half-sine-pulse-in-resonance = Pulso de meia-onda senoidal em ressonância
a-half-sine-pulse-of-half-the-natural-period-x-sin-t-t-cos-t-2-which-reaches-2-at-its-end = Um pulso de meia-onda senoidal com a duração de meio período natural: x = δ(sen ωt − ωt cos ωt)/2, que chega a πδ/2 no seu fim
the-usual-formula-with-1-r-in-the-denominator-fails-here = A fórmula usual, com 1 − r² no denominador, falha aqui.
blast-a-triangle-with-its-peak-at-the-start = Explosão: triângulo com o pico no início
t-m-2-arctan-t-d-x-1-cos-t-sin-t-t-d-t-t-d-for-a-blast-as-long-as-the-period = t_m = 2 arctan(ω t_d)/ω, x = δ(1 − cos ωt + sen ωt/(ω t_d) − t/t_d), para uma explosão com a duração do período
rectangular-pulse-shorter-than-half-a-period = Pulso retangular mais curto que meio período
x-max-2-sin-t-d-t-reached-after-the-pulse-rao-5th-ed-4-6 = x_max = 2δ sen(π t_d/T), atingido depois do pulso (Rao, 5ª ed., §4.6)
overdamped-step = Degrau com superamortecimento
x-1-s-e-s-t-s-e-s-t-s-s-with-2 = x = δ(1 − (s₂e^(−s₁t) − s₁e^(−s₂t))/(s₂ − s₁)) com ζ = 2
critically-damped-after-an-impulse = Amortecimento crítico após um impulso
x-max-i-m-e-at-t-1 = x_max = I/(m ωₙ e) em t = 1/ωₙ
exponential-force = Força exponencial
x-e-t-cos-t-sin-t-1-1-its-first-peak = x = δ(e^(−t/τ) − cos ωt + sen(ωt)/(ωτ))/(1 + 1/(ωτ)²), o seu primeiro pico
fifty-g-for-eleven-milliseconds-on-a-damped-20-hz-mount = Cinquenta g durante onze milissegundos sobre um coxim amortecido de 20 Hz
half-sine-base-pulse-integrated-numerically-classical-runge-kutta-400-000-steps-a-second = Pulso de meia-onda senoidal na base, integrado numericamente (Runge–Kutta clássico, 400 000 passos por segundo)
triangular-pulse-by-a-table = Pulso triangular por uma tabela
the-table-of-the-symmetric-triangle-reproduces-the-triangle = A tabela do triângulo simétrico reproduz o triângulo
same-as-the-triangle-of-prob-4-20-defined-by-three-points = Igual ao triângulo do probl. 4-20, definido por três pontos.
released-with-a-velocity = Solto com uma velocidade
free-vibration-x-x-v = Vibração livre: X = √(x₀² + (v₀/ωₙ)²)
x-t-sin-t-t-r-unbounded-but-known-at-every-time = x = δ(t − sen(ωt)/ω)/t_r: ilimitado, mas conhecido em qualquer instante
force-on-an-unknown-mass = Força em uma massa desconhecida
a-force-moves-a-mass = Uma força move uma massa
damped-rotor-after-an-angular-impulse = Rotor amortecido após um impulso angular
closed-form-i-j-d-e-t-sin-d-t-largest-where-tan-d-t-1-largest-torque-where-the-derivative-of-k-t-c-t = forma fechada: θ = I/(Jω_d) e^(−ζωₙt) sen ω_d t, máximo onde tan ω_d t = √(1 − ζ²)/ζ; torque máximo onde se anula a derivada de k_t θ + c_t θ̇

# vibration_absorber.toml
machine-of-1500-kg-below-its-resonance = Máquina de 1500 kg abaixo da sua ressonância
exercise-on-a-machine-of-1500-kg-physicsforums-com-368412-by-k-a-f-x-a-m-a-k-a-and-the-frequency = Exercício sobre uma máquina de 1500 kg (physicsforums.com 368412), por k_a = F₀/X_a, m_a = k_a/ω² e pela equação das frequências
the-thread-has-no-answer-the-force-of-200-n-acts-at-80-of-the-natural-frequency-and-the-absorber-may = A discussão não tem resposta. A força de 200 N atua a 80 % da frequência natural, e o absorvedor pode mover-se 10 mm.
rotor-with-a-torsional-absorber-on-four-springs = Rotor com absorvedor torcional em quatro molas
both-resonances-must-be-at-least-20-away-from-the-speed-the-lower-one-governs-the-book-numbers-the = As duas ressonâncias devem ficar a pelo menos 20 % da rotação; a inferior é a determinante. O livro dá ao absorvedor o número 2: J₂, b₂.
trial-absorber-of-1-kg-then-a-new-design = Absorvedor de ensaio de 1 kg, depois um novo projeto
tuned-to-220-cpm-the-trial-absorber-splits-the-resonance-into-188-and-258-cpm-with-the-new-one-there = Sintonizado em 220 cpm, o absorvedor de ensaio divide a ressonância em 188 e 258 cpm; com o novo não deve haver ressonância de 150 a 310 cpm. O livro toma a média de duas razões de massas; o complemento chama o segundo par de sistema principal, mas é o novo absorvedor.
the-same-trial-from-both-resonances-at-once = O mesmo ensaio, pelas duas ressonâncias ao mesmo tempo
m-a-and-1-p-p-1-on-the-numbers-of-g-k-grover-ex-5-7-2-k-m-a-m-a-a-at-150-cpm-for-the-new-absorber = ω_m = Ω₁Ω₂/ω_a e μ = (1 − p₁²)(p₂² − 1), com os números de G. K. Grover, ex. 5.7.2; (k − mω²)(ω_a² − ω²) = m_a ω_a² ω² a 150 cpm para o novo absorvedor
two-resonances-give-two-unknowns-mass-and-stiffness-the-main-system-has-220-47-cpm-and-not-220 = Duas ressonâncias dão duas incógnitas: massa e rigidez. O sistema principal tem 220,47 cpm e não 220.
a-mass-ratio-of-one-quarter-tuned-to-resonance = Razão de massas de um quarto, sintonizada na ressonância
g-2-25g-1-0-g-4-25-0-5-2 = g⁴ − 2,25g² + 1 = 0: g = (√4,25 ∓ 0,5)/2
detuned-absorber = Absorvedor dessintonizado
two-equations-by-hand-k-300-k-a-200-m-m-a-1-at-100-400-100-200-0-is-a-resonance-at-400-100-200-200 = Duas equações à mão: k = 300, k_a = 200, m = m_a = 1 em ω² = 100: Δ = 400·100 − 200² = 0 é uma ressonância; em ω² = 400, Δ = 100·(−200) − 200² = −60000
a-disc-absorber-of-known-inertia = Absorvedor em disco de inércia conhecida
j-a-j-4-tuned-to-resonance-g-4-25-0-5-2-k-ta-j-a = J_a = J/4 sintonizado na ressonância: g = (√4,25 ∓ 0,5)/2; k_ta = J_a ω²
resonances-on-one-side-of-the-absorber-frequency = Ressonâncias de um só lado da frequência do absorvedor
interlacing-the-natural-frequency-of-an-undamped-absorber-lies-between-the-two-resonances = Entrelaçamento: a frequência natural de um absorvedor sem amortecimento fica entre as duas ressonâncias
stroke-limit-without-an-excitation = Limite de curso sem excitação
k-a-f-x-a-needs-f = k_a = F₀/X_a precisa de F₀
new-disc-absorber-from-a-trial-disc-for-a-range-of-speeds = Novo absorvedor em disco a partir de um disco de ensaio, para uma faixa de rotações
closed-form-k-t-j-a-j-a-a-at-both-ends-of-the-range-and-j-a-j-q-1-q-2-by-the-mean-the-larger-j-a = forma fechada: (k_t − Jω²)(ω_a² − ω²) = J_a ω_a² ω² nas duas extremidades da faixa, e J_a/J = q² + 1/q² − 2 pela média: o maior J_a
the-upper-end-of-the-range-decides = A extremidade superior da faixa é a determinante.

# vibration_instrument.toml
vibrometer-and-its-peak-to-peak-record = Vibrômetro e o seu registro de pico a pico
s-s-rao-mechanical-vibrations-ch-10-vibrometer-with-4-rad-s-and-0-2 = S. S. Rao, Mechanical Vibrations, cap. 10: vibrômetro com ωₙ = 4 rad/s e ζ = 0,2
the-source-writes-2z-0-0008-m-and-goes-on-with-z-0-004-m-the-record-is-8-mm-from-peak-to-peak = A fonte escreve 2Z = 0,0008 m e continua com Z = 0,004 m; o registro é de 8 mm de pico a pico.
undamped-vibrometer-at-twice-its-natural-frequency = Vibrômetro sem amortecimento no dobro da sua frequência natural
accelerometer-far-above-its-natural-frequency = Acelerômetro muito acima da sua frequência natural
accelerometer-far-above-its-natural-frequency-corrected = Acelerômetro muito acima da sua frequência natural, corrigido
r-from-1-r-4-r-1-1-01-factor-and-phase-in-closed-form-the-peak-1-2-1-at-1-2-and-for-a-peak-of-1-01 = r por (1 − r²)² + 4ζ²r² = 1/1,01²; fator e fase em forma fechada; o pico 1/(2ζ√(1 − ζ²)) em √(1 − 2ζ²), e ζ para um pico de 1,01
vibrometer-given-by-its-damped-and-undamped-natural-frequencies = Vibrômetro dado pelas frequências naturais amortecida e não amortecida
the-same-vibrometer-corrected = O mesmo vibrômetro, corrigido
u-2-1-2-u-1-1-1-02-in-u-f-f-peak-1-2-1-at-f-1-2-and-for-a-peak-of-1-02 = u² − 2(1 − 2ζ²)u + 1 = 1/1,02² em u = (fₙ/f)²; pico 1/(2ζ√(1 − ζ²)) em fₙ/√(1 − 2ζ²), e ζ para um pico de 1,02
flattest-accelerometer = Acelerômetro de resposta mais plana
with-1-2-the-reading-is-1-1-r = Com ζ = 1/√2 a leitura é 1/√(1 + r⁴)
n-1-is-reached-at-r-1-0-99-1-at-r-0-2-the-reading-is-1-1-0016 = 1 % é atingido em r⁴ = 1/0,99² − 1; em r = 0,2 a leitura é 1/√1,0016.
two-tones-on-an-accelerometer-of-seven-tenths-of-critical-damping = Dois tons num acelerômetro com sete décimos do amortecimento crítico
factor-1-1-r-2-r-and-delay-of-each-tone = Fator 1/√((1 − r²)² + (2ζr)²) e atraso φ/ω de cada tom
with-0-7-the-phase-lag-is-nearly-proportional-to-the-frequency-the-delays-at-20-hz-and-40-hz-differ = Com ζ = 0,7 o atraso de fase é quase proporcional à frequência: os atrasos de 20 Hz e 40 Hz diferem pouco.
vibrometer-used-for-acceleration = Vibrômetro usado para aceleração
a-vibrometer-reads-displacements = Um vibrômetro lê deslocamentos

# vibration_isolation.toml
radio-in-an-aircraft = Rádio num avião
w-t-thomson-theory-of-vibration-with-applications-prob-3-24-by-st-g-1-1-t = W. T. Thomson, Theory of Vibration with Applications, probl. 3-24, por δ_st = g (1 + 1/T)/ω²
the-book-gives-no-answer-the-engine-runs-between-1600-and-2200-rpm-85-isolation-at-the-lowest-speed = O livro não dá resposta. O motor gira entre 1600 e 2200 rpm; 85 % de isolamento na menor rotação, sem amortecimento, com g = 9,81 m/s².
refrigeration-unit-on-three-springs = Unidade de refrigeração sobre três molas
w-t-thomson-theory-of-vibration-with-applications-prob-3-25-and-answers = W. T. Thomson, Theory of Vibration with Applications, probl. 3-25 e respostas
machine-with-a-transmissibility-of-one-twelfth = Máquina com transmissibilidade de um doze avos
machine-with-an-unbalance-on-springs-of-known-deflection = Máquina com desbalanceamento sobre molas de deflexão conhecida
w-t-thomson-theory-of-vibration-with-applications-prob-3-26-by-f-t-m-e-r-1 = W. T. Thomson, Theory of Vibration with Applications, probl. 3-26, por F_T = m₀e ω²/(r² − 1)
the-book-gives-no-answer-g-9-81-m-s = O livro não dá resposta. g = 9,81 m/s².
the-same-machine-on-a-concrete-block = A mesma máquina sobre um bloco de concreto
w-t-thomson-theory-of-vibration-with-applications-prob-3-27-by-x-m-e-r-m-r-1 = W. T. Thomson, Theory of Vibration with Applications, probl. 3-27, por X = m₀e r²/(m (r² − 1))
the-book-gives-no-answer-the-1136-kg-block-leaves-the-static-deflection-unchanged-the-same-force-on = O livro não dá resposta. O bloco de 1136 kg não altera a deflexão estática: a mesma força no piso, e menos movimento.
machine-on-damped-isolators = Máquina sobre isoladores amortecidos
exercise-on-a-machine-of-100-kg-tutorsglobe-com-5285870-by-the-closed-form-expressions-of = Exercício sobre uma máquina de 100 kg (tutorsglobe.com 5285870), pelas expressões em forma fechada da transmissibilidade e da amplitude
the-page-gives-no-answer = A página não dá resposta.
engine-with-a-piston-on-rubber = Motor com um pistão sobre borracha
run-up-through-resonance-on-damped-mounts = Partida com passagem pela ressonância sobre coxins amortecidos
maximum-transmissibility-at-r-1-8-1-4-with-0-5-that-is-3-1-and-tr-1-1-r = Transmissibilidade máxima em r² = (√(1 + 8ζ²) − 1)/(4ζ²); com ζ = 0,5 isso é √3 − 1, e TR² = 1/(1 − r⁴)
the-speeds-range-from-far-below-to-far-above-the-natural-frequency-of-100-rad-s-80-isolation-with = As rotações vão de muito abaixo a muito acima da frequência natural de 100 rad/s; 80 % de isolamento com este amortecimento exige r² = 13 + √193.
instrument-in-a-dropped-case = Instrumento numa caixa que cai
v-2gh-k-between-m-v-d-and-m-a-v = v₀ = √(2gh), k entre m v₀²/d² e m A²/v₀²
undamped-mounts-resonance-within-the-speed-range = Coxins sem amortecimento, ressonância dentro da faixa de rotações
without-damping-there-is-no-steady-state-at-the-natural-frequency = Sem amortecimento não há regime permanente na frequência natural
run-up-of-a-lightly-damped-machine-to-just-above-resonance = Partida de uma máquina pouco amortecida até logo acima da ressonância
maximum-of-r-1-4-r-1-r-4-r-within-the-speed-range-by-golden-section-search = Máximo de r⁴(1 + 4ζ²r²)/((1 − r²)² + 4ζ²r²) na faixa de rotações, por seção áurea
damped-mounts-for-90-isolation = Coxins amortecidos para 90 % de isolamento
r-b-b-1-t-1-with-b-1-2-2-t = r² = b + √(b² + 1/T² − 1) com b = 1 − 2ζ² + 2ζ²/T²
with-0-15-a-transmissibility-of-0-1-needs-r-4-0990-and-not-11-3-3166 = Com ζ = 0,15, uma transmissibilidade de 0,1 exige r = 4,0990 e não √11 = 3,3166.
single-damped-mount-for-75-isolation = Um único coxim amortecido para 75 % de isolamento
closed-form-1-4-r-1-r-4-r-t-and-k-m-r-force-m-e-t-and-amplitude-m-e-k-m-i-c-at-the-lowest-speed = forma fechada: (1 + 4ζ²r²)/((1 − r²)² + 4ζ²r²) = T² e k = m(ω₁/r)²; força m₀eω²T e amplitude m₀eω²/|k − mω² + iωc| na menor rotação

# whirling_shaft.toml
turbine-disc-above-its-critical-speed = Disco de turbina acima da sua velocidade crítica
s-s-rao-mechanical-vibrations-ch-9-problem-of-the-turbine-disc = S. S. Rao, Mechanical Vibrations, cap. 9, problema do disco de turbina
the-book-prints-no-answer-e-207-gpa-is-assumed-checked-against-a-e-r-1-r-2-r-k-a-m-g-on-two-bearings = O livro não imprime resposta; supõe-se E = 207 GPa. Conferido com A = e r²/√((1 − r²)² + (2ζr)²), com k A + m g sobre dois mancais e com a tensão 6 E d (A + δ)/L².
the-turbine-disc-at-its-critical-speed = O disco de turbina na sua velocidade crítica
s-s-rao-mechanical-vibrations-ch-9-problem-of-the-turbine-disc-with-a-e-2 = S. S. Rao, Mechanical Vibrations, cap. 9, problema do disco de turbina, com A = e/(2ζ)
a-quarter-of-the-span-no-shaft-withstands-this-which-is-the-conclusion = Um quarto do vão: nenhum eixo suporta isso, e essa é a conclusão.
the-turbine-disc-at-one-and-a-half-times-its-critical-speed = O disco de turbina a uma vez e meia a sua velocidade crítica
forbidden-band-of-a-vertical-shaft-under-a-stress-limit = Faixa proibida de um eixo vertical sob um limite de tensão
n-15-kg-at-midspan-of-a-15-mm-shaft-clamped-at-both-ends-the-companion-takes-the-critical-frequency = 15 kg no meio do vão de um eixo biengastado de 15 mm. O complemento toma a frequência crítica como 0,4985/√δ em metros e π como 3,147; as suas rotações ficam todas 0,09 % acima.
the-printed-solution-rounds-g-2-to-0-4985 = a solução impressa arredonda √g/(2π) para 0,4985
the-same-band-without-intermediate-rounding = A mesma faixa sem arredondamentos intermediários
b-k-sarkar-theory-of-machines-ch-11-ill-13-with-r-r-e-and-r-l-12ed-at-500-rpm-a-er-1-r-ka-2-and-12eda = B. K. Sarkar, Theory of Machines, cap. 11, il. 13, com ω = ωₙ√(R/(R ± e)) e R = σL²/(12Ed); a 500 rpm, A = er²/(1 − r²), kA/2 e 12EdA/L²
rotor-of-60-kg-at-operating-speed-and-during-run-up = Rotor de 60 kg, na rotação de operação e durante a partida
tutorsglobe-com-question-51533194 = tutorsglobe.com, questão 51533194
no-answer-is-printed-checked-against-a-e-r-1-r-2-r-and-its-peak-e-2-1 = Nenhuma resposta é impressa. Conferido com A = e r²/√((1 − r²)² + (2ζr)²) e com o seu pico e/(2ζ√(1 − ζ²)).
the-same-rotor-its-damping-read-from-the-run-up = O mesmo rotor, com o amortecimento lido na partida
n-1-1-e-a-2-of-the-peak-a-20-02505-mm-er-r-1-r-4-r-at-both-ends-of-the-band = ζ = √((1 − √(1 − (e/A)²))/2) pelo pico A = 20,02505 mm; er² = R√((1 − r²)² + 4ζ²r²) nas duas extremidades da faixa
damping-so-high-that-the-limit-is-never-reached = Amortecimento tão alto que o limite nunca é atingido
the-peak-e-2-1-with-0-3-is-1-747-e = O pico e/(2ζ√(1 − ζ²)) com ζ = 0,3 é 1,747 e
a-limit-below-the-eccentricity = Limite abaixo da excentricidade
far-above-its-critical-speed-a-rotor-rotates-about-its-centre-of-mass-the-shaft-deflects-by-e-r-r-e = Muito acima da sua velocidade crítica um rotor gira em torno do seu centro de massa: a deflexão do eixo é e. ω = ωₙ√(R/(R + e)) com R = e/2 é ωₙ/√3
an-undamped-rotor-at-its-critical-speed = Rotor sem amortecimento na sua velocidade crítica
the-whirl-grows-in-proportion-to-the-time-rao-5th-ed-9-5 = A precessão cresce em proporção ao tempo (Rao, 5ª ed., §9.5)
a-stress-limit-on-a-shaft-without-dimensions = Limite de tensão num eixo sem dimensões
a-stiffness-alone-does-not-determine-a-stress = Uma rigidez sozinha não determina uma tensão
the-least-squares-solution-satisfies-its-normal-equations = a solução de mínimos quadrados satisfaz as suas equações normais
the-frequencies-of-the-density-must-ascend-with-two-rows-at-one-frequency-for-a-step-put-the-rows-of = as frequências da densidade devem crescer, com duas linhas em uma mesma frequência para um degrau: ponha as linhas da tabela em ordem
two-rows-at-the-same-frequency-define-a-step = Duas linhas na mesma frequência definem um degrau.
interpolation = Interpolação
how-the-pseudo-acceleration-is-interpolated-between-two-points = Como a pseudoaceleração é interpolada entre dois pontos.
linear-in-period = Linear no período
linear-in-frequency = Linear na frequência
linear-in-log-log-scale = Linear em escala log-log
pseudo-acceleration-of-this-mode-row-row-of-the-spectrum = Pseudoaceleração deste modo: linha { $row } do espectro
frequency-of-row-row-of-the-spectrum = Frequência da linha { $row } do espectro
pseudo-acceleration-of-row-row-of-the-spectrum = Pseudoaceleração da linha { $row } do espectro
period-of-this-mode = Período deste modo
period-of-the-row-below-it-in-frequency = Período da linha abaixo dele em frequência
period-of-the-row-above-it-in-frequency = Período da linha acima dele em frequência
pseudo-acceleration-of-this-mode-linear-in-period-between-two-rows = Pseudoaceleração deste modo, linear no período entre duas linhas
pseudo-acceleration-of-this-mode-linear-in-frequency-between-two-rows = Pseudoaceleração deste modo, linear na frequência entre duas linhas
pseudo-acceleration-of-this-mode-linear-on-log-log-axes-between-two-rows = Pseudoaceleração deste modo, linear em escala log-log entre duas linhas
straight-between-the-points-zero-before-the-first-and-after-the-last-the-displacement-is-relative-to = Linear entre os pontos, zero antes do primeiro e depois do último. O deslocamento é relativo à base.
k-m-and-x-f-c-for-the-data-of-the-test-sdld106-of-code-aster = ωₙ = √(k/m) e X = F/(c ω), para os dados do teste SDLD106 do Code_Aster
n-1-1-r-2-r-of-an-accelerometer-of-1-khz = 1/√((1 − r²)² + (2ζr)²) de um acelerômetro de 1 kHz
r-1-r-2-r-1-02-above-the-resonance-with-1-0-8 = r²/√((1 − r²)² + (2ζr)²) = 1,02 acima da ressonância, com ζ = √(1 − 0,8²)
tip-of-an-overhang = Ponta de um balanço
k-3ei-a-l-a-by-the-energy-of-bending = k = 3EI/(a²(L + a)), pela energia de flexão
leaf-spring-of-six-leaves = Feixe de seis molas
k-8nebt-3l-from-the-bending-energy-of-a-lozenge-of-width-nb = k = 8nEbt³/(3L³), pela energia de flexão de um losango de largura nb
tapered-bar-in-tension = Barra cônica em tração
k-e-d-d-4l-by-the-integral-of-dx-ea = k = πE d₁d₂/(4L), pela integral de dx/(EA)
k-ga-h-of-a-pad = k = GA/h de um coxim
gas-spring-of-a-piston = Mola a gás de um pistão
k-npa-v-by-differences-of-p-p-v-v = k = npA²/V, por diferenças de p = p₀(V₀/V)ⁿ
taut-string-displaced-laterally = Corda tensa deslocada lateralmente
k-t-a-t-b-by-statics-of-the-deflected-string = k = T/a + T/b, pela estática da corda defletida
bob-of-a-pendulum-displaced-laterally = Massa de um pêndulo deslocada lateralmente
k-mg-l-of-a-pendulum = k = mg/l de um pêndulo
pontoon-heaving-in-sea-water = Flutuador que oscila na água do mar
k-ga-by-the-potential-energy-of-the-displaced-liquid = k = ρgA, pela energia potencial do líquido deslocado
mercury-in-a-u-tube = Mercúrio em um tubo em U
k-2-ga-by-the-potential-energy-gaz-of-the-columns = k = 2ρgA, pela energia potencial ρgAz² das colunas
k-3-e-i-l-a-b-3-e-i-l-a-b-with-b-l-a = k = 3 E I L/(a² b²) + 3 E I L³/(a³ b³) com b = L − a
tapered-shaft-in-torsion = Eixo cônico em torção
k-t-by-the-integral-of-dx-gj-of-a-shaft-that-tapers = k_t pela integral de dx/(GJ) de um eixo cônico
k-t-ei-dn-of-the-wire = k_t = EI/(πDn) do arame
hairspring-of-1-5-m = Mola espiral de 1,5 m
k-t-ei-l-of-the-strip = k_t = EI/L da fita
wedge-on-two-pins = Cunha sobre dois pinos
rayleigh-ritz-with-14-powers-of-x-times-1-x-in-60-digits-by-mpmath = Rayleigh–Ritz com 14 potências de x vezes 1 − x, com 60 dígitos por mpmath
torsional-absorber-with-a-limited-amplitude = Absorvedor torcional com amplitude limitada
t-k-a-a-k-a-j-a-j-wr-g-and-both-roots-of-the-frequency-equation = T = k_a θ_a, k_a = J_a ω², J = WR²/g, e as duas raízes da equação das frequências
torsional-absorber-with-resonances-outside-a-speed-range = Absorvedor torcional com ressonâncias fora de uma faixa de rotações
j-a-j-r-1-with-r-k-j-the-larger-of-both-ends = J_a/J = (R − λ)(1 − λ)/λ com R = k/(J ω²), λ = (Ω/ω)², o maior dos dois extremos
torsional-absorber-of-a-quarter-of-the-inertia = Absorvedor torcional de um quarto da inércia
k-k-a-j-k-a-j-a-k-a-with-k-a-j-a = (k + k_a − J Ω²)(k_a − J_a Ω²) = k_a² com k_a = J_a ω²
detuned-torsional-absorber = Absorvedor torcional dessintonizado
both-roots-of-the-frequency-equation-t-k-a-j-a-a-t-k-a = as duas raízes da equação das frequências; θ = T (k_a − J_a ω²)/Δ, θ_a = T k_a/Δ
resonances-at-least-20-away-from-the-operating-speed = Ressonâncias a pelo menos 20 % da rotação de operação
m-a-m-r-1-with-r-k-m-the-larger-of-both-ends = m_a/m = (R − λ)(1 − λ)/λ com R = k/(m ω²), λ = (Ω/ω)², o maior dos dois extremos
resonances-outside-a-speed-range = Ressonâncias fora de uma faixa de rotações
absorber-of-12-kg-tuned-to-the-speed = Absorvedor de 12 kg sintonizado na velocidade
k-k-a-m-k-a-m-a-k-a-with-k-a-m-a = (k + k_a − m Ω²)(k_a − m_a Ω²) = k_a² com k_a = m_a ω²
rotor-identified-by-a-trial-disc = Rotor identificado por um disco de teste
a-m-and-m-1-j-t-j-a-the-mean-of-j-t-j-p-1-p-2-of-both-resonances = Ω₁ Ω₂ = ω_a ω_m e Ω₁² + Ω₂² = ω_m² + (1 + J_t/J) ω_a²; a média de J_t/J = p² + 1/p² − 2 das duas ressonâncias
rotor-with-a-known-damping-coefficient = Rotor com coeficiente de amortecimento conhecido
e-r-1-r-2-r-with-c-2-k-m = e r²/√((1 − r²)² + (2 ζ r)²) com ζ = c/(2√(k m))
absorber-by-its-own-frequency-damping-by-that-of-the-main-system = Absorvedor pela sua frequência, amortecimento pela do sistema principal
x-k-f-of-the-two-equations-of-motion-with-k-a-m-a-a-c-a-2-m-a-m = X k/F₀ das duas equações de movimento com k_a = m_a ω_a², c_a = 2 m_a ω_m γ
viscous-damper-without-a-spring-damping-given = Amortecedor viscoso sem mola, amortecimento dado
x-k-f-of-the-two-equations-of-motion-with-k-a-0-c-a-2-m-a-m = X k/F₀ das duas equações de movimento com k_a = 0, c_a = 2 m_a ω_m γ
disc-by-its-dimensions-on-a-cantilever = Disco pelas suas dimensões em uma viga em balanço
n-1-are-the-roots-of-m-j-m-j-0-j-i-d-at-rest-and-i-d-i-p-for-forward-and-backward-whirl = 1/ω² são as raízes de λ² − (α m + γ J) λ + (α γ − β²) m J = 0, J = I_d em repouso e I_d ∓ I_p para precessão direta e retrógrada
two-discs-on-a-clamped-tube = Dois discos em um tubo engastado
a-3-x-a-6-e-i-dunkerley-m-exact-the-larger-root-of-its-characteristic-equation = δ = a² (3 x − a)/(6 E I): Dunkerley Σ m δ, exata a maior raiz da sua equação característica
torsional-pendulum-of-a-known-damping-ratio = Pêndulo de torção de fator de amortecimento conhecido
n-2-1-c-2-k-j-t-2-1 = δ = 2πζ/√(1 − ζ²), c = 2 ζ √(k J), T = 2π/(ωₙ √(1 − ζ²))
spectral-density-of-force-in-straight-lines = Densidade espectral de força em segmentos de reta
s-f-h-f-df-with-straight-lines-through-4-12-and-20-hz-by-quadrature-in-30-digits = √∫S(f)|H(f)|² df com linhas retas por 4, 12 e 20 Hz, por quadratura com 30 dígitos
velocity-in-a-uniform-chain-on-a-wall = Velocidade em uma cadeia uniforme em uma parede
k-i-c-m-x-f-for-three-masses-velocity-i-x-by-the-sine-formula-of-a-uniform-chain = (K + iωC − ω²M) X = F para três massas, velocidade iωX; ωₙ pela fórmula dos senos de uma cadeia uniforme
velocity-in-a-free-uniform-chain = Velocidade em uma cadeia uniforme livre
round-shaft-against-a-torsion-spring = Eixo redondo contra uma mola de torção
cos-g-j-l-k-sin-0 = β cos β G J/L + k sen β = 0
round-shaft-against-a-disc-on-a-torsion-spring = Eixo redondo contra um disco em uma mola de torção
cos-g-j-l-k-j-d-sin-0 = β cos β G J/L + (k − J_d ω²) sen β = 0
shear-beam-with-a-mass-on-a-spring-at-its-end = Viga de cisalhamento com uma massa sobre mola na ponta
cos-g-a-l-k-m-sin-0-l-g-0-7 = β cos β κ G A/L + (k − m ω²) sen β = 0, ω = (β/L) √(κ G/ρ), κ = 0,7
shear-beam-thin-round-tube = Viga de cisalhamento, tubo redondo fino
n-2-1-4-3-with-0-3-g-r-cowper-1966-f-g-2-l-between-fixed-ends = κ = 2(1 + ν)/(4 + 3ν) com ν = 0,3 (G. R. Cowper, 1966); f = √(κ G/ρ)/(2 L) entre extremidades fixas
shear-beam-rectangle = Viga de cisalhamento, retângulo
n-10-1-12-11-with-0-3-g-r-cowper-1966-f-g-2-l-between-fixed-ends = κ = 10(1 + ν)/(12 + 11ν) com ν = 0,3 (G. R. Cowper, 1966); f = √(κ G/ρ)/(2 L) entre extremidades fixas
shear-beam-round = Viga de cisalhamento, redonda
n-6-1-7-6-with-0-3-g-r-cowper-1966-f-g-2-l-between-fixed-ends = κ = 6(1 + ν)/(7 + 6ν) com ν = 0,3 (G. R. Cowper, 1966); f = √(κ G/ρ)/(2 L) entre extremidades fixas
short-pinned-beam-with-cowper-s-coefficient = Viga curta sobre pinos com o coeficiente de Cowper
short-pinned-tube-with-cowper-s-coefficient = Tubo curto apoiado com o coeficiente de Cowper
i-g-a-i-1-e-g-k-ei-k-0-k-n-l-10-1-12-11 = ρ²I ω⁴/(κG) − (ρA + ρI(1 + E/κG)k²) ω² + EI k⁴ = 0, k = nπ/L, κ = 10(1 + ν)/(12 + 11ν), vigas curtas
pinned-beam-with-both-springs-at-its-middle = Viga sobre pinos com as duas molas no meio
n-1-k-l-tan-2-tanh-2-4-e-i-0-and-1-k-t-l-coth-2-cot-2-4-e-i-0 = 1 + k L³ (tan β/2 − tanh β/2)/(4 E I β³) = 0 e 1 + k_t L (coth β/2 − cot β/2)/(4 E I β) = 0
beam-between-a-pin-and-a-guide = Viga entre um pino e uma guia
n-2n-1-2-half-of-a-symmetric-mode-of-twice-the-length = β = (2n − 1)π/2: metade de um modo simétrico do dobro do comprimento
clamped-beam-with-a-spring-at-its-end = Viga engastada com uma mola na ponta
n-1-k-l-sin-cosh-cos-sinh-e-i-1-cos-cosh-0 = 1 + k L³ (sen β cosh β − cos β senh β)/(E I β³ (1 + cos β cosh β)) = 0
rectangular-cantilever-with-a-point-mass = Viga retangular em balanço com massa pontual
n-1-cos-cosh-m-m-l-sin-cosh-cos-sinh-in-both-planes = 1 + cos β cosh β = (M/m L) β (sen β cosh β − cos β senh β) nos dois planos
tubular-cantilever-with-a-point-mass = Viga tubular em balanço com massa pontual
n-1-cos-cosh-m-m-l-sin-cosh-cos-sinh-the-same-in-both-planes = 1 + cos β cosh β = (M/m L) β (sen β cosh β − cos β senh β), igual nos dois planos
stout-rectangular-cantilever-with-two-eccentric-masses-by-timoshenko = Viga retangular curta em balanço com duas massas excêntricas, por Timoshenko
timoshenko-s-bending-in-both-planes-axial-motion-and-torsion-by-matrix-exponentials-scipy-joined-to = Flexão de Timoshenko nos dois planos, movimento axial e torção por exponenciais de matriz (SciPy), ligados ao corpo rígido na ponta; κ = 10(1 + ν)/(12 + 11ν), J pela série de Saint-Venant
tubular-cantilever-with-two-eccentric-masses-by-timoshenko = Viga tubular em balanço com duas massas excêntricas, por Timoshenko
timoshenko-s-bending-axial-motion-and-torsion-of-a-tube-by-the-same-matrix-exponentials-6-1-1-m-7-6-1 = Flexão de Timoshenko, movimento axial e torção de um tubo, pelas mesmas exponenciais de matriz: κ = 6(1 + ν)(1 + m²)²/((7 + 6ν)(1 + m²)² + (20 + 12ν)m²), J = π(D⁴ − d⁴)/32
stout-cantilever-with-a-point-mass-by-timoshenko = Viga curta em balanço com massa pontual, por Timoshenko
determinant-of-the-four-exponentials-of-timoshenko-s-equations-with-6-1-7-6-in-30-digits = determinante das quatro exponenciais das equações de Timoshenko com κ = 6(1 + ν)/(7 + 6ν), com 30 dígitos
two-separate-cranks-a-tube-and-a-given-shaft = Duas manivelas separadas, um tubo e um eixo dado
eigenvalues-of-k-j-of-five-discs-with-k-g-d-d-32-l-and-g-i-t-l-by-mpmath = autovalores de K − ω²J de cinco discos com k = G π(D⁴ − d⁴)/(32 L) e G I_t/L, por mpmath
throw-by-its-equivalent-length = Manivela pelo seu comprimento equivalente
k-g-d-e-32-l-e-2-k-j-of-two-equal-cranks = k = G π D_e⁴/(32 L_e), ω = √(2 k/J) de duas manivelas iguais
throw-by-carter = Manivela por Carter
k-g-32-l-j-0-8-t-d-j-0-75-l-c-d-c-1-5-r-t-w = k = (π G/32)/((L_j + 0,8 t)/D_j⁴ + 0,75 L_c/D_c⁴ + 1,5 R/(t W³))
throw-by-ker-wilson = Manivela por Ker Wilson
k-g-32-l-j-0-4-d-j-d-j-l-c-0-4-d-c-d-c-r-0-2-d-j-d-c-t-w = k = (π G/32)/((L_j + 0,4 D_j)/D_j⁴ + (L_c + 0,4 D_c)/D_c⁴ + (R − 0,2(D_j + D_c))/(t W³))
clamped-clamped-beam-clamped-pinned-beam-and-column-in-parallel = Viga biengastada, viga engastada-apoiada e coluna em paralelo
k-192-768-7-12-e-i-l-m-k-g = k = (192 + 768/7 + 12) E I/L³, m = k δ/g
bars-of-four-cross-sections-in-tension = Barras de quatro seções em tração
torsion-bar-with-a-lever-beside-an-inclined-spring-springs-with-mass = Barra de torção com alavanca ao lado de uma mola inclinada, molas com massa
k-g-i-t-l-a-k-cos-m-33-140-m-17-35-m-13-35-m-0-4-m-m-3 = k = G I_t/(L a²) + k₁ cos² α; m + 33/140 m₁ + 17/35 m₂ + 13/35 m₃ + 0,4 m₄ + m₅/3
beams-rotated-at-their-ends-springs-at-an-arm-and-a-pendulum = Vigas giradas nas pontas, molas em um braço e um pêndulo
k-1-3-4-e-i-l-2-k-r-m-g-l-j-k = k = (1 + 3 + 4) E I/L + 2 k₁ r² + m g l; J = k/ω²
damping-from-a-decay = Amortecimento a partir de um decaimento
ln-8-3-4-x-m-e-m-r-1-r-2-r = δ = ln 8/3, ζ = δ/√(4π² + δ²), X = (m₀e/m) r²/√((1 − r²)² + (2ζr)²), do decaimento
velocity-shock = Choque de velocidade
a-v-k-m-travel-v-a = ωₙ = A/v₀, k = m ωₙ², curso v₀²/A
tubular-beam-at-a-constant-pseudo-velocity = Viga tubular sob pseudo-velocidade constante
y-4-s-v-e-c-l-y-l-e-i-m = y = (4/π) S_v/ω₁, σ = E c (π/L)² y, ω₁ = (π/L)² √(E I/m̄)
spectrum-straight-over-the-frequency = Espectro reto sobre a frequência
s-a-2-3-3-1-5-1-m-s-at-3-hz-y-s-a-2-f-and-m-s-a = S_a = 2 + 3 · (3 − 1)/(5 − 1) m/s² em 3 Hz, y = S_a/(2πf)² e m S_a
spectrum-straight-in-a-log-log-diagram = Espectro reto em um diagrama log-log
s-a-2-2-5-ln-3-ln-5-m-s-at-3-hz-y-s-a-2-f-and-m-s-a = S_a = 2 · 2,5^(ln 3/ln 5) m/s² em 3 Hz, y = S_a/(2πf)² e m S_a
ramp-on-one-of-two-masses-a-damping-ratio-for-each-mode = Rampa em uma de duas massas, um fator de amortecimento para cada modo
two-modes-1-1-with-k-m-3-k-m-each-is-the-ramp-t-2-e-t-minus-the-same-ramp-delayed-by-t-r = dois modos (1; ±1) com ω² = k/m, 3 k/m; cada um é a rampa t − 2ζ/ω + e^(−ζωt)(…) menos a mesma rampa atrasada de t_r
triangle-on-one-of-two-masses-rayleigh-damping = Triângulo em uma de duas massas, amortecimento de Rayleigh
n-2-of-both-modes-the-triangle-is-a-ramp-of-0-2-s-minus-one-of-0-3-s = ζ = (α/ω + β ω)/2 dos dois modos; o triângulo é uma rampa de 0,2 s menos uma de 0,3 s
base-acceleration-by-a-table = Aceleração da base por uma tabela
z-2-z-z-a-a-ramp-to-2-m-s-in-0-3-s-then-constant-closed-form-at-0-8-s = z″ + 2ζωz′ + ω²z = −a, uma rampa até 2 m/s² em 0,3 s, depois constante: forma fechada em 0,8 s
rotor-on-a-shaft-clamped-and-pinned = Rotor em um eixo engastado e apoiado
n-768-e-i-7-l-m-11-16-of-k-a-on-the-clamped-bearing-and-the-moment-3-k-a-l-16 = ω = √(768 E I/(7 L³ m)); 11/16 de k A no mancal engastado, e o momento 3 k A L/16
friction-by-a-normal-force = Atrito por uma força normal
f-n-x-f-k-1-4f-f-1-r-exact-f-k-v-f-f-u-u-sin-r-r-1-cos-r-relative-error-of-the-former = F = µ N; X = (F₀/k) √(1 − (4F/πF₀)²)/|1 − r²|; exata (F₀/k) √(V² − (F/F₀)² U²), U = sen(π/r)/(r(1 + cos(π/r))); erro relativo da primeira
mass-with-a-known-damping-ratio = Massa de fator de amortecimento conhecido
x-e-t-x-cos-d-t-v-x-d-sin-d-t-c-2-km = x = e^(−ζωt)(x₀ cos ω_d t + (v₀ + ζωx₀)/ω_d sen ω_d t), c = 2ζ√(km)
rotor-with-a-known-damping-ratio-released = Rotor de fator de amortecimento conhecido, solto
e-t-cos-d-t-d-sin-d-t-c-2-k-j = θ = θ₀ e^(−ζωt)(cos ω_d t + ζω/ω_d sen ω_d t), c = 2ζ√(k J)
circular-membrane-by-the-mass-of-its-area = Membrana circular pela massa da sua área
f-j-2-r-t-with-the-zeros-of-j-j-j-j-by-mpmath = f = j/(2πR) √(T/μ) com os zeros de J₀, J₁, J₂, J₀ por mpmath
j-n-i-n-1-i-n-j-n-1-0-at-f-2-r-d-h = J_n I_(n+1) + I_n J_(n+1) = 0 em λ; f = λ²/(2πR²) √(D/ρh)
receptance-by-amplitude-and-phase = Receptância por amplitude e fase
i-q-k-m-ic-with-m-4-kg-20-hz-and-0-03-to-six-digits = (iω)^q/(k − mω² + icω) com m = 4 kg, 20 Hz e ζ = 0,03, com seis algarismos
mobility-by-its-parts = Mobilidade pelas suas partes
accelerance-by-amplitude-and-phase = Acelerância por amplitude e fase
disc-on-a-light-shaft-clamped-at-both-ends = Disco em um eixo leve biengastado
n-192-e-i-l-m-in-both-planes = ω = √(192 E I/(L³ m)) nos dois planos
absorber-and-its-damping-by-its-own-frequency = Absorvedor e o seu amortecimento pela sua frequência
x-k-f-of-the-two-equations-of-motion-with-k-a-m-a-a-c-a-2-m-a-a-a = X k/F₀ das duas equações de movimento com k_a = m_a ω_a², c_a = 2 m_a ω_a ζ_a
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-4-4-3 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 4.4.3
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-4-4-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 4.4.1
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-2-5-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 2.5.1
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-4-11-4 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 4.11.4
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-3-6-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 3.6.1
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-example-5-3-2 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, exemplo 5.3.2
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-2-4-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 2.4.1
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-4-6-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 4.6.1
fossee-python-companion-to-w-g-mclean-and-e-w-nelson-schaum-s-engineering-mechanics-prob-19-28 = Complemento FOSSEE em Python a W. G. McLean e E. W. Nelson, Schaum's Engineering Mechanics, probl. 19-28
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-example-6-8-2 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, exemplo 6.8.2
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-3-3-3 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 3.3.3
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-4-5-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 4.5.1
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-1-5-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 1.5.1
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-1-7-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 1.7.1
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-3-4-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 3.4.1
fossee-python-companion-to-t-bevan-the-theory-of-machines-ch-15-ex-2 = Complemento FOSSEE em Python a T. Bevan, The Theory of Machines, cap. 15, ex. 2
fossee-python-companion-to-b-k-sarkar-theory-of-machines-ch-11-ill-1 = Complemento FOSSEE em Python a B. K. Sarkar, Theory of Machines, cap. 11, il. 1
fossee-python-companion-to-b-k-sarkar-theory-of-machines-ch-11-ill-2 = Complemento FOSSEE em Python a B. K. Sarkar, Theory of Machines, cap. 11, il. 2
fossee-python-companion-to-b-k-sarkar-theory-of-machines-ch-11-ill-3 = Complemento FOSSEE em Python a B. K. Sarkar, Theory of Machines, cap. 11, il. 3
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-8-6-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 8.6.1
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-4-3-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 4.3.1
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-4-10-2 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 4.10.2
fossee-python-companion-to-b-k-sarkar-theory-of-machines-ch-11-ill-6 = Complemento FOSSEE em Python a B. K. Sarkar, Theory of Machines, cap. 11, il. 6
fossee-python-companion-to-b-k-sarkar-theory-of-machines-ch-11-ill-6-with-2000-n-in-the-third-place = Complemento FOSSEE em Python a B. K. Sarkar, Theory of Machines, cap. 11, il. 6, com 2000 N também na terceira posição
fossee-python-companion-to-b-k-sarkar-theory-of-machines-ch-11-ill-10 = Complemento FOSSEE em Python a B. K. Sarkar, Theory of Machines, cap. 11, il. 10
fossee-python-companion-to-b-k-sarkar-theory-of-machines-ch-11-ill-11 = Complemento FOSSEE em Python a B. K. Sarkar, Theory of Machines, cap. 11, il. 11
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-3-3-2 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 3.3.2
fossee-python-companion-to-t-bevan-the-theory-of-machines-ch-15-ex-9 = Complemento FOSSEE em Python a T. Bevan, The Theory of Machines, cap. 15, ex. 9
fossee-python-companion-to-t-bevan-the-theory-of-machines-ch-15-ex-8 = Complemento FOSSEE em Python a T. Bevan, The Theory of Machines, cap. 15, ex. 8
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-5-3-3 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 5.3.3
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-5-3-3-second-part = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 5.3.3, segunda parte
fossee-python-companion-to-b-k-sarkar-theory-of-machines-ch-11-ill-12 = Complemento FOSSEE em Python a B. K. Sarkar, Theory of Machines, cap. 11, il. 12
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-7-7-2 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 7.7.2
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-5-7-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 5.7.1
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-5-7-2 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 5.7.2
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-4-11-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 4.11.1
fossee-python-companion-to-w-g-mclean-and-e-w-nelson-engineering-mechanics-schaum-ch-19-prob-25 = Complemento FOSSEE em Python a W. G. McLean e E. W. Nelson, Engineering Mechanics (Schaum), cap. 19, probl. 25
fossee-python-companion-to-b-k-sarkar-theory-of-machines-ch-11-ill-13 = Complemento FOSSEE em Python a B. K. Sarkar, Theory of Machines, cap. 11, il. 13
fossee-python-companion-to-mclean-nelson-schaum-s-outline-of-engineering-mechanics-ch-19-prob-16 = Complemento FOSSEE em Python a McLean & Nelson, Schaum's Outline of Engineering Mechanics, cap. 19, prob. 16
fossee-python-companion-to-mclean-nelson-schaum-s-outline-of-engineering-mechanics-ch-19-prob-2 = Complemento FOSSEE em Python a McLean & Nelson, Schaum's Outline of Engineering Mechanics, cap. 19, prob. 2
fossee-python-companion-to-nelson-best-mclean-schaum-s-outline-of-engineering-mechanics-dynamics = Complemento FOSSEE em Python a Nelson, Best & McLean, Schaum's Outline of Engineering Mechanics: Dynamics, problema 19-20
fossee-python-companion-to-mclean-nelson-schaum-s-outline-of-engineering-mechanics-ch-19-prob-13 = Complemento FOSSEE em Python a McLean & Nelson, Schaum's Outline of Engineering Mechanics, cap. 19, prob. 13
j-j-j-k-j-j-j-k-j-j-j-k-k-j-j-j-0-for-a-problem-of-r-s-khurmi = J₁J₂J₃ω⁴ − (k₁J₃(J₁ + J₂) + k₂J₁(J₂ + J₃))ω² + k₁k₂(J₁ + J₂ + J₃) = 0 para um problema de R. S. Khurmi
the-amplitudes-are-1-1-j-k-and-k-k-j-of-it-the-nodes-divide-each-shaft-in-the-same-ratio = As amplitudes são 1, 1 − J₁ω²/k₁ e k₂/(k₂ − J₃ω²) dela; os nós dividem cada eixo na mesma razão.
disc-off-the-middle-of-a-clamped-shaft-with-hysteretic-damping = Disco fora do meio de um eixo biengastado com amortecimento histerético
four-roots-s-of-det-m-s-i-g-s-c-k-0-of-the-disc-c-1-i-1-by-zorzi-and-nelson-k-of-the-clamped-parts = quatro raízes s de det (M s² − i Ω G s + c K) = 0 do disco, c = (1 + η − iη)/√(1 + η²) por Zorzi e Nelson, K das partes engastadas
mode-shape-n-strain-energy-over-kinetic-energy-is = forma modal { $n }: energia de deformação sobre energia cinética é ω²
the-modes-are-orthogonal-with-respect-to-the-stiffness-k-k-r-r-0 = os modos são ortogonais em relação à rigidez, K₁₁ + K₂₂ r₁ r₂ = 0
at-that-order-the-inertia-of-the-rotor-the-effective-inertia-of-the-pendulums-and-the-shaft-are-in = nessa ordem a inércia do rotor, a inércia efetiva dos pêndulos e o eixo estão em equilíbrio
series-in-the-amplitude-from-that-of-the-elliptic-integral-in-the-modulus = série na amplitude a partir da série da integral elíptica no módulo
torque-of-the-equivalent-shaft-from-its-shear-stress-over-the-section-for-a-unit-twist = torque do eixo equivalente a partir da tensão de cisalhamento na seção, para uma torção unitária
work-of-that-damper-in-a-cycle-summed-over-equal-steps-friction-force-times-the-distance-4x = trabalho desse amortecedor em um ciclo, somado em passos iguais = força de atrito vezes a distância 4X
x-c-results-from-x-c-after-two-half-cycles-of-each-of-those-cycles = Xₐ + C resulta de X₁ + C após dois meios ciclos de cada um desses ciclos
critical-speed-n-vibrations-per-revolution-by-rayleigh-s-quotient-k-j = velocidade crítica: n vibrações em cada volta, pelo quociente de Rayleigh Σ k (Δβ)²/Σ J β²
force-on-the-floor-spring-and-damper-forces-for-the-motion-of-the-machine = força no piso: forças das molas e dos amortecedores para o movimento da máquina
from-one-maximum-of-the-amplitude-to-the-next-the-faster-vector-gains-one-revolution-on-the-slower = de um máximo da amplitude ao seguinte, o vetor mais rápido ganha uma volta sobre o mais lento
impulse-of-the-wall-it-reverses-the-momentum-of-the-rod = impulso da parede: inverte a quantidade de movimento da barra
kinetic-energy-at-that-speed-is-the-strain-energy-at-the-strength-per-unit-volume = a energia cinética nessa velocidade é a energia de deformação na tensão de resistência, por unidade de volume
maximum-amplitude-from-the-magnification-against-the-frequency-ratio = amplitude máxima pela amplificação em função da razão de frequências
maximum-power-at-the-instant-midway-between-the-extremes-of-force-and-velocity = potência máxima: no instante a meio caminho entre os extremos da força e da velocidade
maximum-shortening-by-d-alembert-s-solution = encurtamento máximo pela solução de d'Alembert
maximum-shortening-uniform-strain-in-the-whole-rod = encurtamento máximo: deformação uniforme em toda a barra
maximum-torque-inertia-torque-of-all-masses-before-it-j = torque máximo: torque de inércia de todas as massas antes dele, ω² Θ Σ J β
mean-power-half-the-real-part-of-force-times-conjugate-velocity-as-complex-amplitudes = potência média: metade da parte real da força vezes o conjugado da velocidade, como amplitudes complexas
moment-of-the-shear-stress-which-grows-with-the-radius-summed-over-the-section = momento da tensão de cisalhamento, que cresce com o raio, somado na seção
zero-velocity-at-that-turning-point-by-step-by-step-integration = velocidade nula nesse ponto de retorno, por integração passo a passo
with-the-rotor-at-rest-the-pendulums-at-their-limit-balance-the-torque-j = com o rotor parado, os pêndulos no seu limite equilibram o torque, J₁₂ ω₀² φ
the-energy-difference-between-the-two-amplitudes-is-the-friction-work-over-the-path-of-those-cycles = a diferença de energia entre as duas amplitudes é o trabalho do atrito no percurso desses ciclos
the-momentum-per-unit-area-is-absorbed-by-the-stress-until-the-rod-is-at-rest = a quantidade de movimento por unidade de área é absorvida pela tensão até a barra ficar em repouso
the-pendulum-frequency-equals-the-force-frequency = a frequência do pêndulo é igual à da força
the-pendulum-frequency-in-the-centrifugal-field-equals-the-frequency-of-the-order-n-s-r-r = a frequência do pêndulo no campo centrífugo é igual à frequência da ordem, n² s² = R r
the-contributions-of-all-modes-to-the-total-mass-sum-to-one = as contribuições de todos os modos à massa total somam um
time-of-rest-the-middle-of-the-last-stroke-backwards-from-its-end-and-by-step-by-step-integration = instante do repouso: o meio do último curso, para trás a partir do seu fim e por integração passo a passo desde o início
transmissibility-at-the-lowest-speed-from-the-dynamic-stiffness = transmissibilidade na menor rotação, pela rigidez dinâmica
travel-of-the-softest-mounts-the-amplitude-v-of-the-free-vibration = curso dos coxins mais macios: a amplitude v₀/ωₙ da vibração livre
tuned-order-of-that-arm = ordem sintonizada desse braço
two-motions-of-equal-amplitude-equal-one-beating-motion-at-the-mean-frequency-sin-t-sin-t-2-sin-m-t = dois movimentos de amplitudes iguais equivalem a um movimento com batimento na frequência média, sen ω₁t + sen ω₂t = 2 sen ω_m t cos(ω_b t/2)
with-the-mass-at-rest-the-pendulum-at-its-limit-balances-the-force-m = com a massa parada, o pêndulo no seu limite equilibra a força, M₁₂ ω₀² φ
work-of-a-cycle-by-numerical-integration = trabalho de um ciclo por integração numérica
four-amplitudes-that-scatter = Quatro amplitudes que se dispersam
least-squares-of-ln-x-by-hand-s-nx-s-nn-with-s-nn-5-s-4-s-2-s-nn = Mínimos quadrados de ln X à mão: δ = −S_nx/S_nn com S_nn = 5, ε = √(S/4), σ_δ = √(S/(2 S_nn))
after-these-cycles-the-envelope-e-t-has-decayed-to-one-half = depois desses ciclos a envoltória e^(−ζωₙt) decaiu à metade
bending-stress-from-the-moment-of-the-inertia-forces-at-the-middle = tensão de flexão pelo momento das forças de inércia no meio do vão
combined-separately-the-product-of-the-roots-is-k-m = associados separadamente: o produto das raízes é k/m
combined-separately-the-sum-of-the-roots-is-c-m = associados separadamente: a soma das raízes é −c/m
complete-quadratic-combination-as-the-length-of-a-sum-of-vectors-their-cosines-the-correlations = combinação quadrática completa como o comprimento de uma soma de vetores, cujos cossenos são as correlações
dampers-alone-power-dissipated-at-unit-velocity-is-c = só os amortecedores: a potência dissipada a uma velocidade unitária é c
damping-ratio-from-the-mode-shape-c-2-k-m-summed-over-all-elements = fator de amortecimento pela forma modal, c/2√(k m) somados sobre todos os elementos
modal-deflection-the-beam-carries-its-inertia-forces-e-i-y-m-s-d = deflexão modal: a viga suporta suas forças de inércia, E I β⁴ y = m̄ ω² Γφ S_d
standard-deviation-of-the-decrement-the-same-sum-of-squares-over-n-2-degrees-of-freedom = desvio-padrão do decremento: a mesma soma de quadrados sobre N − 2 graus de liberdade
displacements-of-a-mode-inertia-and-springs-balance-at-every-mass = deslocamentos de um modo: inércia e molas se equilibram em cada massa
energies-before-and-after-a-cycle-as-the-squares-of-the-amplitudes = energias antes e depois de um ciclo, como os quadrados das amplitudes
error-of-the-light-damping-formula-from-the-neglected-square-root-1-1-1 = erro da fórmula de amortecimento fraco pela raiz quadrada desprezada, 1/√(1 − ζ²) − 1
imaginary-part-of-the-dynamic-stiffness-from-the-power-of-the-dampers = parte imaginária da rigidez dinâmica pela potência dos amortecedores
for-the-mode-shape-the-frequency-satisfies-m-s-c-s-k-0-summed-over-all-elements = para a forma modal, a frequência satisfaz m s² + c s + k = 0, somados sobre todos os elementos
measured-frequency-with-the-same-relative-error-as-the-period = frequência medida, com o mesmo erro relativo do período
period-from-mass-stiffness-and-damping-d-c-2m-k-m = período por massa, rigidez e amortecimento, ω_d² + (c/2m)² = k/m
ratio-of-successive-amplitudes-from-the-envelope-e-t-over-a-period = razão de amplitudes sucessivas pela envoltória e^(−ζωₙt) em um período
real-part-of-the-dynamic-stiffness-from-the-energies-of-springs-and-masses = parte real da rigidez dinâmica pelas energias de molas e massas
scatter-sum-of-squares-from-the-orthogonality-of-the-residuals-to-the-fitted-line = dispersão: soma de quadrados pela ortogonalidade dos resíduos à reta ajustada
springs-alone-maximum-kinetic-energy-maximum-elastic-energy = só as molas: energia cinética máxima = energia elástica máxima
the-force-component-in-phase-with-the-motion-balances-spring-and-inertia-forces-f-x-cos-k-x-m-x = a componente da força em fase com o movimento equilibra as forças das molas e de inércia, F X cos φ = Σ k|Δx|² − ω² Σ m|x|²
the-loss-factor-is-the-tangent-of-the-phase-lag = o fator de perda é a tangente do atraso de fase
the-root-i-d-of-the-decay-has-modulus = a raiz −ζωₙ + iω_d do decaimento tem o módulo ωₙ
square-of-the-sum-of-absolute-values-sum-of-squares-plus-twice-all-products = quadrado da soma dos valores absolutos: soma dos quadrados mais o dobro de todos os produtos
the-squares-of-the-real-and-imaginary-parts-of-the-dynamic-stiffness-sum-to-the-square-of-its = os quadrados das partes real e imaginária da rigidez dinâmica somam o de seu módulo
torsional-stiffness-from-the-shear-strain-at-the-rim-16t-gd-over-the-radius = rigidez torcional pela distorção na periferia, 16T/(πGd³), sobre o raio
overdamped-the-body-approaches-its-rest-position-asymptotically-and-the-maximum-deflection-is-that = Superamortecido: o corpo tende assintoticamente ao repouso, e a deflexão máxima é a devida ao peso
the-damping-is-so-strong-that-the-body-approaches-rest-without-oscillating-the-maximum-deflection-is = o amortecimento é tão forte que o corpo tende ao repouso sem oscilar: a deflexão máxima é aproximada, mas nunca ultrapassada, e não tem instante
suddenly-applied-load-on-a-strongly-damped-cushion = Carga aplicada subitamente sobre um amortecedor de embalagem forte
overdamped-2-y-1-s-e-s-t-s-e-s-t-s-s-approaches-m-g-k-asymptotically-and-never-exceeds-it = Superamortecido, ζ = 2: y = δ (1 − (s₂ e^(−s₁t) − s₁ e^(−s₂t))/(s₂ − s₁)) tende assintoticamente a δ = m g/k e nunca o ultrapassa
newton-s-second-law-at-the-largest-force-f-t-m-t-g-m-t-a = segunda lei de Newton na maior força: F_T − m_t g = m_t aₘ
area-under-the-characteristic-up-to-the-maximum-displacement-equals-the-kinetic-energy-at-the = a área sob a característica até o deslocamento máximo é igual à energia cinética na posição de equilíbrio
at-contact-the-force-missing-in-the-spring-is-the-weight-of-the-body-m-g-m-t = no contato a força que falta à mola é o peso do corpo: ωₙ² δ = m g/m_t
energy-lost-that-of-the-speed-of-approach-in-the-reduced-mass-m-m-p-v-2-m-t = energia perdida: a da velocidade de aproximação na massa reduzida, m m_p v²/(2 m_t)
stiffness-of-the-element-stiffness-added-by-sticking-m = rigidez do elemento = rigidez acrescentada pela aderência, m (ω₁² − ω₂²)
distance-travelled-by-the-exact-recurrence = distância percorrida pela recorrência exata
distance-in-free-fall-the-drop-height-times-the-square-of-the-fraction-of-its-time = distância em queda livre: a altura de queda vezes o quadrado da fração de seu tempo
total-distance-free-fall-in-its-time-plus-the-deflection-by-the-exact-recurrence = distância total: queda livre em seu tempo, mais a deflexão pela recorrência exata
dunkerley-the-sum-of-the-squared-periods-of-all-modes-gives-the-same-value = Dunkerley: a soma dos quadrados dos períodos de todos os modos dá o mesmo valor
half-sine-pulse-of-three-half-periods = Pulso de meia-onda senoidal de três meios períodos
overdamped-after-an-impulse = Superamortecido após um impulso
ramp-on-a-damped-mass = Rampa sobre uma massa amortecida
rayleigh-the-first-step-of-matrix-iteration-from-equal-deflections = Rayleigh: o primeiro passo da iteração matricial, a partir de deflexões iguais
released-with-a-velocity-critically-damped = Solto com velocidade, amortecimento crítico
second-row-of-k-m-0-the-second-amplitude-over-the-first = Segunda linha de (K − λM) φ = 0: a segunda amplitude sobre a primeira
frequency-n-including-the-reduction-in-the-plane-of-rotation-from-the-same-balance = frequência { $n }: incluindo a redução no plano de rotação, pelo mesmo equilíbrio
just-below-the-buckling-load-all-squares-of-frequencies-are-positive-just-above-it-one-is-not = logo abaixo da carga de flambagem todos os quadrados das frequências são positivos, logo acima um não é
mode-shape-n-work-of-the-centrifugal-forces-through-the-shortening-of-the-blade-over-its-kinetic = forma modal { $n }: trabalho das forças centrífugas no encurtamento da pá, sobre a sua energia cinética
x-i-e-s-t-e-s-t-m-s-s-with-s-0-5-s-and-s-2-s = x = I(e^(−s₁t) − e^(−s₂t))/(m(s₂ − s₁)) com s₁ = 0,5 s⁻¹ e s₂ = 2 s⁻¹
x-sin-t-r-sin-t-1-r-with-r-1-3-at-t-150-and-t-450-0-1875 = x = δ(sen Ωt − r sen ωt)/(1 − r²) com r = 1/3, em Ωt = 150° e ωt = 450°: 0,1875 δ
x-t-2-1-g-h-t-r-g-and-h-the-free-motions-from-a-unit-displacement-and-a-unit-velocity = x = δ(t − 2ζ(1 − g)/ω − h)/t_r, com g e h as vibrações livres de deslocamento unitário e de velocidade unitária
bandwidth-of-a-mode-with-that-damping-ratio-from-its-half-power-frequencies-in-closed-form = largura de banda de um modo com esse fator de amortecimento, pelas suas frequências de meia potência em forma fechada
damping-ratio-from-the-upper-half-power-point-alone-a-quarter-of-the-circle-after-the-natural = fator de amortecimento só pelo ponto superior de meia potência, um quarto do círculo além da frequência natural
error-of-the-textbook-damping-from-the-peak-at-1-2-and-its-height-1-1-2-1 = erro do amortecimento dos livros, pelo pico em ωₙ√(1 − 2ζ²) e sua altura: √((1 − ζ²)/(1 − 2ζ²)) − 1
error-of-the-textbook-mass-from-the-peak-at-1-2-2-1-2 = erro da massa dos livros, do pico em ωₙ√(1 − 2ζ²): 2ζ²/(1 − 2ζ²)
maximum-amplitude-from-the-dynamic-stiffness-at-the-peak = amplitude máxima pela rigidez dinâmica no pico
scatter-the-relative-residuals-of-1-h-are-orthogonal-to-the-fit-so-that-d-d = dispersão: os resíduos relativos de 1/H² são ortogonais ao ajuste, de modo que Σd² = −Σd
square-of-the-radius-is-the-mean-square-of-the-distances-of-the-points-from-the-centre = o quadrado do raio é a média dos quadrados das distâncias dos pontos ao centro
the-complex-residuals-are-orthogonal-to-the-derivatives-of-the-fit-with-respect-to-each-of-its = os resíduos complexos são ortogonais às derivadas do ajuste em relação a cada um dos seus parâmetros
mass-stiffness-and-damping-reproduce-the-measured-receptance-at-the-lowest-frequency = massa, rigidez e amortecimento reproduzem a receptância medida na frequência mais baixa
hysteretic-mode-with-residual-terms-of-lower-and-higher-modes = Modo histerético com termos residuais dos modos inferiores e superiores
n-0-5-1-0-04i-2-10-0-05-with-10-hz-to-seven-digits-the-spread-of-the-three-readings-by-scipy = 0,5/(ωₙ²(1 + 0,04i) − ω²) + 2·10⁻⁵ − 0,05/ω² com 10 Hz, com sete algarismos; a dispersão das três leituras por SciPy
a-tenth-of-the-force-at-580-rpm-is-to-be-transmitted-by-three-equal-springs-the-stiffness-of-one-is-a = Um décimo da força a 580 rpm deve ser transmitido por três molas iguais; a rigidez de uma delas é uma definição incógnita.
a-weight-of-10-lbf-of-whose-mass-g-386-in-s-is-a-definition-the-ratio-is-asked-for = Um peso de 10 lbf; g = 386 in/s², que dá a sua massa, é uma definição; pergunta-se a razão.
ansys-mechanical-apdl-verification-manual-vm72-w-t-thomson-vibration-theory-and-applications-ex-2-3-1 = Manual de verificação do ANSYS Mechanical APDL, VM72 (W. T. Thomson, Vibration Theory and Applications, ex. 2.3-1)
ansys-mechanical-apdl-verification-manual-vm83-f-p-beer-and-e-r-johnston-vector-mechanics-for = Manual de verificação do ANSYS Mechanical APDL, VM83 (F. P. Beer e E. R. Johnston, Vector Mechanics for Engineers, 1962, p. 531)
block-and-pan-are-given-by-their-weights-the-displacement-of-the-pan-from-the-unloaded-spring-is = O bloco e o prato são dados pelos seus pesos; pergunta-se o deslocamento do prato a partir da mola sem carga.
block-dropped-on-a-pan-by-momentum-and-energy = Bloco que cai sobre um prato, por quantidade de movimento e energia
v-m-v-m-m-p-y-v-with-m-g-k-and-k-m-m-p-the-block-leaves-the-pan-where-g = v₀ = m v/(m + m_p), y = δ + √(δ² + v₀²/ωₙ²) com δ = m g/k e ωₙ² = k/(m + m_p); o bloco deixa o prato onde ÿ = g
block-dropped-on-the-pan-of-a-spring-scale = Bloco que cai sobre o prato de uma balança de mola
engine-on-springs-of-its-stroke-and-its-dashpot = Motor sobre molas, dado pelo curso e pelo amortecedor
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-3-6-2 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 3.6.2
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-4-10-3 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 4.10.3
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-4-3-2 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 4.3.2
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-8-3-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 8.3.1
force-and-power-of-a-shaker = Força e potência de um excitador
mass-on-five-springs-unknown = Massa incógnita sobre cinco molas
radio-on-four-isolators-to-more-digits = Rádio sobre quatro isoladores, com mais algarismos
x-y-k-ic-k-m-ic-z-x-y-and-f-m-x-in-complex-numbers = X/Y = (k + icω)/(k − mω² + icω), Z = X − Y e F = mω²X em números complexos
radio-on-four-isolators = Rádio sobre quatro isoladores
ratio-of-successive-peaks = Razão entre picos sucessivos
spring-stretched-in-all-by-126-mm = Mola esticada ao todo de 126 mm
springs-of-a-refrigerator-unknown = Molas incógnitas de um refrigerador
stiffness-and-damping-are-those-of-each-isolator-the-load-on-each-is-asked-for = A rigidez e o amortecimento são os de cada isolador; pergunta-se a carga em cada um.
stress-of-a-rotor-with-a-damper-and-its-power = Tensão e potência de um rotor com amortecedor
the-force-is-unknown-and-the-amplitude-of-15-mm-is-given-the-power-is-that-of-the-damper = A força é incógnita e a amplitude de 15 mm é dada; a potência é a do amortecedor.
the-mass-hangs-the-motion-is-about-the-static-extension-m-g-k-and-the-extension-that-remains-is-asked = A massa está pendurada: o movimento se dá em torno do alongamento estático m g/k, e pergunta-se o alongamento que resta.
the-mass-is-the-unknown-and-its-natural-frequency-of-10-hz-is-given = A massa é a incógnita e a sua frequência natural de 10 Hz é dada.
the-natural-frequency-of-the-reed-is-given-as-the-cycles-a-minute-that-it-is-to-show-the-mass-of-the = A frequência natural da lâmina é dada pelos ciclos por minuto que ela deve indicar; a massa da lâmina é desprezada.
the-reciprocating-mass-of-24-kg-with-a-stroke-of-150-mm-is-the-unbalance-the-springs-give-2-mm-under = A massa alternativa de 24 kg com curso de 150 mm é o desbalanceamento, as molas cedem 2 mm sob o peso, e o amortecedor resiste com 490 N a 0,3 m/s.
the-source-lets-the-shaft-carry-the-force-of-the-damper-too-the-stresses-are-those-at-mid-span = A fonte faz o eixo suportar também a força do amortecedor; as tensões são as do meio do vão.
weight-at-the-tip-of-a-reed-unknown = Peso incógnito na ponta de uma lâmina
displacement-from-the-unloaded-spring = deslocamento a partir da mola sem carga
final-extension = alongamento final
force-on-the-shaft = força no eixo
largest-stress = tensão máxima
load-on-each-isolator = carga em cada isolador
power-of-the-damper = potência do amortecedor
stress-under-dead-load = tensão sob a carga permanente
the-last-digit-of-the-source-is-rounded-up = o último algarismo da fonte está arredondado para cima
the-dampers-couple-the-modes-their-complex-modes-are-found-of-at-most-most-degrees-of-freedom-enter = os amortecedores acoplam os modos: os modos complexos são obtidos com no máximo { $most } graus de liberdade; dê fatores de amortecimento ou amortecimento de Rayleigh
chain-of-2000-equal-masses = Cadeia de 2000 massas iguais
j-2-k-m-sin-j-2-n-1-2-for-dampers-in-proportion-to-the-springs = ω_j = 2√(k/m) sen(jπ/(2(n + 1))), ζ = βω/2 para amortecedores proporcionais às molas
the-lowest-modes-are-found-from-the-bands-of-the-matrices = Os modos mais baixos são obtidos das bandas das matrizes.
a-long-ton-is-2240-lb-the-weight-is-given-and-g-32-2-ft-s = Uma tonelada longa tem 2240 lb; dá-se o peso, e g = 32,2 ft/s².
a-ring-on-a-torsional-spring-with-damping-on-a-shaft-that-oscillates-15-times-a-minute-the-ring-moves = Um anel sobre uma mola de torção com amortecimento, em um eixo que oscila 15 vezes por minuto; o anel se move 2° em relação ao eixo, cuja aceleração se pergunta.
acceleration-of-the-shaft = aceleração do eixo
at-900-rpm-the-amplitude-is-21-6-mm-and-the-unbalance-of-the-two-wheels-is-at-the-top-when-the = A 900 rpm a amplitude é 21,6 mm, e o desbalanceamento das duas rodas está no alto quando a estrutura passa pela posição de repouso: 90°. Rigidez e amortecimento são incógnitas; a resposta a 1200 rpm é uma configuração.
cantilever-shaft-with-100-kg-and-50-kg = Eixo em balanço com 100 kg e 50 kg
diesel-engine-at-6000-rpm-absorber-within-2-mm = Motor Diesel a 6000 rpm, absorvedor dentro de 2 mm
first-frequency-without-damping = primeira frequência sem amortecimento
first-frequency-without-damping-at-rest = primeira frequência sem amortecimento, em repouso
flywheel-of-three-tenths-of-a-ton-at-the-end-of-a-shaft = Volante de três décimos de tonelada na ponta de um eixo
fossee-python-companion-to-t-bevan-the-theory-of-machines-ch-15-ex-1 = Complemento FOSSEE em Python a T. Bevan, The Theory of Machines, cap. 15, ex. 1
fossee-python-companion-to-w-g-mclean-and-e-w-nelson-schaum-s-engineering-mechanics-ex-19-11 = Complemento FOSSEE em Python a W. G. McLean e E. W. Nelson, Schaum's Engineering Mechanics, ex. 19-11
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-4-11-3 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 4.11.3
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-7-2-1-7-3-1-7-4-1-and-8-4-1 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 7.2.1, 7.3.1, 7.4.1 e 8.4.1
fourth-frequency-without-damping = quarta frequência sem amortecimento
it-follows-from-187-8-cycles-per-minute-with-in-inches-60-2-386-4-in-s-is-187-71 = segue de 187,8/√δ ciclos por minuto com δ em polegadas; 60/(2π)·√(386,4 in/s²) é 187,71
it-follows-from-628-3-rad-s-for-6000-rpm-calculated-0-316629-kg = segue de 628,3 rad/s para 6000 rpm; calculado: 0,316629 kg
m-i-friswell-et-al-dynamics-of-rotating-machines-ex-5-9-5-as-the-program-ross-asserts-it = M. I. Friswell et al., Dynamics of Rotating Machines, ex. 5.9.5, como o verifica o programa ROSS
rayleigh-s-value-is-that-of-the-static-deflection-stodola-s-method-ends-at-the-exact-value = O valor de Rayleigh é o da deflexão estática; o método de Stodola termina no valor exato.
s-s-rao-mechanical-vibrations-ch-9-diesel-engine-of-3000-n-with-an-undamped-absorber = S. S. Rao, Mechanical Vibrations, cap. 9: motor Diesel de 3000 N com um absorvedor não amortecido
second-frequency-without-damping = segunda frequência sem amortecimento
steel-disc-on-a-wire-by-its-dimensions = Disco de aço em um arame, dado pelas dimensões
structure-identified-by-an-exciter-with-two-wheels = Estrutura identificada por um excitador de duas rodas
the-last-digit-is-cut-off-calculated-0-62426-rad-s = o último algarismo está truncado; calculado: 0,62426 rad/s²
the-mass-of-the-disc-is-that-of-200-mm-by-50-mm-of-steel-7850-kg-m = A massa do disco é a de 200 mm por 50 mm de aço, 7850 kg/m³.
the-mount-is-not-given-the-engine-is-taken-to-resonate-at-its-speed-mass-and-stiffness-of-the = O coxim não é dado: supõe-se o motor em ressonância na sua rotação. A massa e a rigidez do absorvedor não dependem disso.
the-rotor-at-rest-is-a-configuration-the-frequencies-without-damping-are-s-2-of-the-eigenvalues-s = O rotor em repouso é uma configuração. As frequências sem amortecimento são |s|/(2π) dos autovalores s: as do movimento amortecido divididas por √(1 − ζ²).
third-frequency-without-damping = terceira frequência sem amortecimento
third-frequency-without-damping-at-rest = terceira frequência sem amortecimento, em repouso
torsiograph-that-reads-two-degrees = Torsiógrafo que indica dois graus
two-discs-on-damped-bearings-at-rest-and-at-4000-rpm = Dois discos sobre mancais amortecidos, em repouso e a 4000 rpm
w-t-thomson-theory-of-vibration-with-applications-ch-3-counter-rotating-exciter-on-a-structure-of-181 = W. T. Thomson, Theory of Vibration with Applications, cap. 3: excitador de massas contrarrotativas sobre uma estrutura de 181,4 kg
without-the-damping-away-from-the-resonance-it-is-2-321-mm-calculated-2-3135-mm = sem o amortecimento, longe da ressonância, é 2,321 mm; calculado: 2,3135 mm
a-harmonic-requires-at-least-three-ordinates-in-the-period-add-some = um harmônico exige pelo menos três ordenadas no período: acrescente algumas
accelerations = Acelerações
amplitude-of-the-elastic-vibration-with-this-velocity = Amplitude da vibração elástica com essa velocidade
amplitude-of-the-harmonic = Amplitude do harmônico
ansys-mechanical-apdl-verification-manual-vm80-after-j-m-biggs-introduction-to-structural-dynamics-p = ANSYS Mechanical APDL Verification Manual, VM80, segundo J. M. Biggs, Introduction to Structural Dynamics, p. 69
of-one-period-at-0-t-n-2t-n-and-so-on-the-ordinate-at-the-end-of-the-period-is-the-first-of-the-next = De um período, em 0, T/N, 2T/N e assim por diante; a ordenada no fim do período é a primeira do seguinte e fica de fora.
at-most-half-the-number-of-ordinates = No máximo metade do número de ordenadas.
beam-that-yields-under-a-sudden-force = Viga que escoa sob uma força súbita
blow-that-yields-the-spring = Choque que faz a mola escoar
constant-force-suddenly-applied = Força constante, aplicada subitamente
cosine-coefficient-2-n-y-j-cos-360-n-j-1-n-of-the-last-harmonic-n-n-2-half-as-much = Coeficiente do cosseno: 2/N Σ y_j cos (360° n (j − 1)/N); do último harmônico, n = N/2, a metade
cosine-coefficient-of-harmonic = Coeficiente do cosseno do harmônico
count-ordinates-determine-most-harmonics-at-most-ask-for-fewer-or-give-more-ordinates = { $count } ordenadas determinam no máximo { $most } harmônicos: peça menos, ou dê mais ordenadas
deceleration-while-the-spring-yields = Desaceleração enquanto a mola escoa
displacements = Deslocamentos
ductility-ratio = Ductilidade
ductility-ratio-maximum-displacement-over-yield-displacement = Ductilidade: deslocamento máximo sobre o deslocamento de escoamento
elastic-response-twice-the-static-displacement = Resposta elástica: o dobro do deslocamento estático
elastoplastic-spring = Mola elastoplástica
energy-dissipated-in-yielding = Energia dissipada no escoamento
energy-dissipated-the-work-of-the-load-less-the-elastic-energy-of-the-spring = energia dissipada: o trabalho do carregamento menos a energia elástica da mola
force-of-the-spring = força da mola
force-of-the-spring-against-displacement = Força da mola em função do deslocamento
fossee-scilab-companion-to-g-k-grover-mechanical-vibrations-ex-1-8-2 = Complemento FOSSEE em Scilab a G. K. Grover, Mechanical Vibrations, ex. 1.8.2
fourier-coefficients-amplitudes-and-phases-of-the-harmonics-of-a-curve-from-its-ordinates-at-equal = Coeficientes de Fourier, amplitudes e fases dos harmônicos de uma curva a partir de ordenadas a intervalos iguais: um momento torçor, uma pressão, a elevação de um came, uma vibração medida.
fraction-of-the-period-as-an-angle = fração do período como ângulo
frequency-of-the-first-harmonic = Frequência do primeiro harmônico
frequency-of-the-first-harmonic-that-of-the-n-th-is-n-times-as-large = Frequência do primeiro harmônico; a do n-ésimo é n vezes maior
from-0-to-10-in-half-a-period-and-back-the-continuous-wave-has-a-40-4-0528-twelve-ordinates-are-few = De 0 a 10 em meio período e de volta. A onda contínua tem a₁ = −40/π² = −4,0528: doze ordenadas são poucas.
harmonic-analysis-of-a-periodic-curve = Análise harmônica de uma curva periódica
harmonic-n-cosine-coefficient-by-goertzel-s-recursion = harmônico { $n }: coeficiente do cosseno pela recursão de Goertzel
harmonic-n-sine-coefficient-by-goertzel-s-recursion = harmônico { $n }: coeficiente do seno pela recursão de Goertzel
harmonics-of-the-curve = Harmônicos da curva
if-given-the-frequency-of-the-first-harmonic-is-also-calculated = Se dado, a frequência do primeiro harmônico também é calculada.
impulse-of-the-force-and-of-the-spring-up-to-the-maximum = impulso da força e da mola até o máximo
impulse-of-the-spring-up-to-the-maximum = impulso da mola até o máximo
initial-velocity-from-a-blow = Velocidade inicial, de um choque
kinetic-energy-at-the-start-in-the-spring-at-the-maximum = energia cinética inicial, na mola no máximo
m-v-2-r-y-max-y-e-2-energy-of-an-elastic-perfectly-plastic-spring-it-yields-at-sin-t-e-y-e-v-and-the = m v₀²/2 = R (y_max − y_e/2): energia de uma mola elástica, perfeitamente plástica; ela escoa em sen ωₙt_e = y_e ωₙ/v₀, e a massa desacelera com R/m a partir de v₀ cos ωₙt_e
maximum-displacement-after-yielding = Deslocamento máximo, após o escoamento
maximum-displacement-permanent-displacement-ductility-and-rebound-of-a-mass-on-an-elastic-perfectly = Deslocamento máximo, deslocamento permanente, ductilidade e retorno de uma massa sobre uma mola elástica, perfeitamente plástica, sob uma força súbita ou um choque.
maximum-displacement-the-spring-stays-elastic = Deslocamento máximo: a mola permanece elástica
maximum-displacement-the-spring-stays-elastic-twice-the-static-displacement = Deslocamento máximo: a mola permanece elástica, o dobro do deslocamento estático
mean-square-of-the-ordinates-the-square-of-the-mean-and-half-the-squares-of-the-amplitudes-of-all = média dos quadrados das ordenadas: o quadrado da média e metade dos quadrados das amplitudes de todos os harmônicos
mean-the-sum-of-the-ordinates-over-their-number = Média: a soma das ordenadas sobre o seu número
minimum-displacement-of-the-rebound = Deslocamento mínimo do retorno
minimum-of-the-rebound-the-return-is-elastic-about-the-position-at-which-spring-and-load-are-in = Mínimo do retorno: o retorno é elástico, em torno da posição em que mola e carregamento estão em equilíbrio
n-83-4-kip-in-45-286-kip-0-0259-kip-s-in-30-kip-the-targets-are-read-from-a-chart-of-a-numerical = 83,4 kip/in, 45,286 kip, 0,0259 kip·s²/in, 30 kip. Os valores de referência vêm de uma integração numérica.
natural-frequency-elastic = Frequência natural, elástica
natural-frequency-of-the-elastic-spring = Frequência natural da mola elástica
no-velocity-at-the-minimum-net-work-of-spring-and-load-on-the-return = sem velocidade no mínimo: trabalho resultante da mola e do carregamento no retorno
number-of-harmonics = Número de harmônicos
numbers = Números
ordinate = ordenada
ordinates = ordenadas
ordinates-and-the-sum-of-the-harmonics = Ordenadas e a soma dos harmônicos
ordinates-of-one-period = Ordenadas de um período
permanent-displacement = Deslocamento permanente
permanent-displacement-from-the-dissipated-energy = deslocamento permanente a partir da energia dissipada
permanent-displacement-what-remains-when-the-spring-has-returned-elastically = Deslocamento permanente: o que resta quando a mola retornou elasticamente
phase-of-harmonic = Fase do harmônico
phase-the-harmonic-is-a-cos-n-t = Fase: o harmônico é A cos (nωt − φ)
pressure-in-a-pipe-by-twelve-ordinates = Pressão num tubo por doze ordenadas
root-mean-square-of-the-ordinates = Valor eficaz das ordenadas
s-s-rao-mechanical-vibrations-1-11-numerical-fourier-analysis-of-the-pressure-in-a-pipe = S. S. Rao, Mechanical Vibrations, §1.11, análise de Fourier numérica da pressão num tubo
sine-coefficient-2-n-y-j-sin-360-n-j-1-n = Coeficiente do seno: 2/N Σ y_j sen (360° n (j − 1)/N)
sine-coefficient-of-harmonic = Coeficiente do seno do harmônico
static-displacement-under-the-force = Deslocamento estático sob a força
the-force-is-not-below-the-yield-force-resistance-the-mass-is-driven-on-without-end-reduce-the-force = a força não é menor que a força de escoamento { $resistance }: a massa é empurrada sem fim; reduza a força
the-largest-force-of-the-spring-the-resistance-of-the-structure = A maior força da mola: a resistência da estrutura.
the-mass-on-its-spring = A massa sobre a mola
the-period-of-0-12-s-in-twelve-intervals-the-book-counts-them-from-0-01-s-where-the-pressure-is-20-kn = O período de 0,12 s em doze intervalos; o livro os conta de 0,01 s, onde a pressão é 20 kN/m², a 0,12 s, onde ela é nula.
the-target-is-that-of-a-numerical-integration-calculated-0-8043-in = o valor de referência vem de uma integração numérica; calculado: 0,8043 in
time-at-which-the-spring-yields = Instante em que a mola escoa
time-at-which-the-spring-yields-v-sin-t-y-e = Instante em que a mola escoa: v₀/ωₙ sen ωₙt = y_e
time-at-which-the-spring-yields-y-s-1-cos-t-y-e = Instante em que a mola escoa: y_s (1 − cos ωₙt) = y_e
time-of-the-maximum-a-quarter-of-a-period = Instante do máximo: um quarto de período
time-of-the-maximum-displacement = Instante do deslocamento máximo
time-of-the-maximum-half-a-period = Instante do máximo: meio período
time-of-the-minimum-displacement = Instante do deslocamento mínimo
time-of-the-minimum-half-a-period-of-the-elastic-spring-later = Instante do mínimo: meio período da mola elástica depois
time-of-the-return-by-quadrature-of-dt-dy-v = tempo do retorno por quadratura de dt = dy/v
triangular-wave-by-twelve-ordinates = Onda triangular por doze ordenadas
up-to-the-yield-force-and-of-the-return = Até a força de escoamento, e no retorno.
velocity-there-v-cos-t = Velocidade ali: v₀ cos ωₙt
velocity-there-y-s-sin-t = Velocidade ali: y_s ωₙ sen ωₙt
work-of-the-force-up-to-the-maximum-in-the-spring = trabalho da força até o máximo, na mola
y-e-50-mm-100-kg-at-4-m-s-have-800-j-y-max-0-425-m = y_e = 50 mm; 100 kg a 4 m/s têm 800 J: y_max = 0,425 m.
y-max-2-f-k-up-to-f-r-2-j-m-biggs-introduction-to-structural-dynamics-2-3 = y_max = 2 F/k até F = R/2: J. M. Biggs, Introduction to Structural Dynamics, §2.3
yield-displacement = deslocamento de escoamento
yield-force = Força de escoamento
acceleration-with-a-fundamental-and-its-third-harmonic = Aceleração com fundamental e terceiro harmônico
cam-lift-in-simple-harmonic-motion = Elevação de um came em movimento harmônico simples
f-300-n-the-amplitude-2-f-lies-above-4f-that-of-the-continuous-wave = F = 300 N. A amplitude √2 F fica acima de 4F/π, a da onda contínua.
square-wave-of-a-force-by-four-ordinates = Onda quadrada de uma força por quatro ordenadas
stiffness-and-damping-ratio-are-those-of-the-resonance-at-900-rpm-with-21-6-mm = A rigidez e o fator de amortecimento são os da ressonância a 900 rpm com 21,6 mm.
the-ordinates-at-every-60-cannot-tell-the-third-harmonic-from-its-reflection-of-the-last-harmonic-n-n = As ordenadas a cada 60° não distinguem o terceiro harmônico do seu reflexo: do último harmônico, n = N/2, só há o cosseno.
the-root-mean-square-is-40-25-2-n-m = O valor eficaz é √(40² + 25²/2) N·m.
the-same-structure-at-1200-rpm = A mesma estrutura a 1200 rpm
turning-moment-of-a-twin-by-eight-ordinates = Momento torçor de um motor de dois cilindros por oito ordenadas
h-20-mm-the-lift-at-every-45 = h = 20 mm; a elevação a cada 45°.
harmonic-n-cosine-coefficient-from-amplitude-and-phase = harmônico { $n }: coeficiente do cosseno a partir da amplitude e da fase
harmonic-n-sine-coefficient-from-amplitude-and-phase = harmônico { $n }: coeficiente do seno a partir da amplitude e da fase
s-h-2-1-cos-mean-h-2-cosine-coefficient-h-2-nothing-else = s = h/2 (1 − cos θ): média h/2, coeficiente do cosseno −h/2, nada mais
pressure-that-pulsates-once-in-a-period = Pressão que pulsa uma vez por período
p-5-bar-2-bar-cos = p = 5 bar + 2 bar cos θ
acceleration-at-its-end = Aceleração no fim
accelerations-of-the-base = Acelerações da base
all-coordinates-are-displacements-in-its-direction-and-are-then-relative-to-it = Todas as coordenadas são deslocamentos na direção dela e passam a ser relativas a ela.
exact-motion-of-a-chain-or-of-given-matrices-from-initial-conditions-under-steps-pulses-ramps = Movimento exato de uma cadeia ou de matrizes dadas a partir de condições iniciais, sob degraus, pulsos, rampas, forças harmônicas ou tabelas de forças, ou sobre uma base móvel, com qualquer amortecimento.
harmonic-a-cos-t = Harmônica: a cos(Ωt − φ)
x-a-sin-t-d-over-the-modes-with = xᵢ = −Σ φᵢ Γ ∫ a(τ) sen ω(t − τ) dτ/ω sobre os modos, com Γ = Σ φ
two-storeys-on-a-base-that-accelerates-suddenly = Dois pavimentos sobre uma base que acelera de repente
two-equal-storeys-2000-kg-and-800-kn-m-each-the-displacements-are-those-relative-to-the-base = Dois pavimentos iguais, 2000 kg e 800 kN/m cada um; os deslocamentos são relativos à base.
two-storeys-on-a-base-under-a-harmonic-acceleration = Dois pavimentos sobre uma base sob aceleração harmônica
from-rest-1-5-m-s-cos-10-t = Do repouso, 1,5 m/s² cos 10 t.
two-storeys-on-a-base-under-a-pulse-of-acceleration = Dois pavimentos sobre uma base sob um pulso de aceleração
n-1-5-m-s-for-0-15-s = 1,5 m/s² por 0,15 s.
two-storeys-on-a-base-whose-acceleration-rises-to-a-constant = Dois pavimentos sobre uma base cuja aceleração cresce até uma constante
n-1-5-m-s-is-reached-in-0-1-s = 1,5 m/s² é alcançado em 0,1 s.
two-storeys-on-a-base-under-a-table-of-accelerations = Dois pavimentos sobre uma base sob uma tabela de acelerações
a-triangle-of-1-5-m-s-that-lasts-0-2-s = Um triângulo de 1,5 m/s² que dura 0,2 s.

# Half-power points, equivalent-system, plane-frame, sprung masses, loss-of-contact, tables of tapered beams, loss factors
n-1-cos-cosh-m-cos-sinh-sin-cosh-m-l-0-m-1-kg = 1 + cos β cosh β + M β(cos β sinh β − sin β cosh β)/(m̄L) = 0, M = 1 kg
n-1-k-e-l-tan-2-tanh-2-4ei-0-with-k-e-k-m-m-k-and-sin-0 = 1 + k_e L³(tan β/2 − tanh β/2)/(4EIβ³) = 0 com k_e = k m ω²/(m ω² − k), e sen β = 0
a-bar-of-3-kg-and-1-2-m-on-a-pivot-0-3-m-from-its-end-j-0-63-1-62-2-25-kg-m-k-1620-n-m-rad-c-10-n-m-s = Uma barra de 3 kg e 1,2 m sobre um pivô a 0,3 m de sua extremidade: J = 0,63 + 1,62 = 2,25 kg·m², K = 1620 N·m/rad, C = 10 N·m·s/rad; a força de 30 N a 15 rad/s tem o braço 0,9 m.
a-beam-of-2-kg-and-ei-2000-n-m-with-1-kg-on-5-kn-m-the-spring-mass-system-alone-vibrates-at-11-25-hz = Uma viga de 2 kg e EI = 2000 N·m² com 1 kg sobre 5 kN/m: o sistema massa-mola sozinho vibra a 11,25 Hz, a viga a 17,70 Hz.
a-frustum-with-a-tip-of-a-thousandth-of-its-base-has-nearly-the-frequency-of-the-cone-8-7193 = Um tronco de cone com a ponta de um milésimo da base tem quase a frequência do cone, 8,7193.
a-joint-without-members = Um nó sem barras
a-light-lever-on-a-frictionless-pivot-is-at-rest-in-every-position = Uma alavanca leve sobre um pivô sem atrito fica em repouso em qualquer posição
a-mass-on-a-spring-above-a-support = Uma massa sobre uma mola acima de um apoio
a-member-has-a-length = Uma barra tem um comprimento
a-member-to-a-joint-that-does-not-exist = Uma barra até um nó que não existe
a-natural-frequency-outside-of-the-bandwidth = Uma frequência natural fora da largura de banda
a-round-section-of-20-mm-f-2-e-d-4l = Uma seção circular de 20 mm: f₁ = π/2·√(E/ρ)·d/(4L²).
a-section-of-100-200-mm-over-2-m-bending-at-115-709-hz-117-642-hz-without-shear-and-rotary-inertia = Uma seção de 100 × 200 mm sobre 2 m: flexão a 115,709 Hz, 117,642 Hz sem cisalhamento e inércia rotativa; o rolete deixa a viga vibrar também ao longo de seu eixo.
a-strip-of-10-mm-whose-width-falls-from-30-mm-by-e-2x-with-x-in-metres-0-6-m-long-bending-about-the = Uma tira de 10 mm cuja largura diminui a partir de 30 mm segundo e^(−2x) com x em metros, de 0,6 m; flexão em torno do lado largo.
a-table-that-ends-before-the-beam = Uma tabela que termina antes da viga
afnor-guide-de-validation-des-progiciels-de-calcul-de-structures-test-sdll10-89-quoted-in-the = AFNOR, Guide de validation des progiciels de calcul de structures, teste SDLL10/89; citado no manual de verificação do SCIA Engineer
afnor-guide-de-validation-des-progiciels-de-calcul-de-structures-test-sdlx01-89-quoted-in-the = AFNOR, Guide de validation des progiciels de calcul de structures, teste SDLX01/89; citado no manual de verificação do SCIA Engineer
amplitude-at-which-contact-is-lost = Amplitude em que se perde o contato
amplitude-at-which-contact-is-lost-at-this-frequency = Amplitude em que se perde o contato nesta frequência
amplitude-of-the-contact-force = Amplitude da força de contato
amplitude-of-the-contact-force-for-each-metre-of-the-road-m-m-k-ic-k-m-ic = Amplitude da força de contato por metro da estrada: ω²|m + M(k + icω)/(k − Mω² + icω)|
amplitude-of-the-contact-force-for-each-metre-of-the-surface-inertia-less-stiffness-m-k = Amplitude da força de contato por metro da superfície: inércia menos rigidez, m ω² − k
amplitude-of-the-moment = Amplitude do momento
amplitude-of-the-moment-of-the-force = Amplitude do momento da força
amplitude-of-the-point = Amplitude do ponto
amplitude-of-the-reference-point = Amplitude do ponto de referência
amplitude-of-the-surface = Amplitude da superfície
angle-to-the-motion-of-its-end = Ângulo com o movimento de sua extremidade
angular-amplitude = Amplitude angular
angular-amplitude-against-the-frequency-of-the-load = Amplitude angular em função da frequência do carregamento
angular-amplitude-of-the-steady-motion = Amplitude angular do movimento em regime permanente
arm-of-the-cord = Braço do cabo
arm-of-the-force = Braço da força
at-the-top-the-surface-accelerates-downwards-with-a-the-contact-force-n-k-a-m-a-is-zero-there = No topo a superfície acelera para baixo com A ω²; a força de contato N₀ + k A − m A ω² é zero ali
axial-stiffness-of-the-member = Rigidez axial da barra
bandwidth-of-16-8-to-23-2-hz-about-20-hz = Largura de banda de 16,8 a 23,2 Hz em torno de 20 Hz
below-the-peak-where-the-amplitude-is-1-2-of-its-peak-3-db-down = Abaixo do pico, onde a amplitude é 1/√2 do pico: 3 dB a menos.
bending-stiffness-of-the-member = Rigidez à flexão da barra
block-on-a-piston-with-a-period-of-2-68-s = Bloco sobre um pistão com período de 2,68 s
block-on-a-piston-amplitude-6-05-cm = Bloco sobre um pistão, amplitude de 6,05 cm
body-in-contact = Corpo em contato
body-or-follower = Corpo ou seguidor
cantilever-on-a-spring = Viga em balanço sobre uma mola
cantilever-with-a-mass-at-its-tip = Viga em balanço com uma massa na ponta
cantilever-with-a-mass-on-a-spring-at-its-tip = Viga em balanço com uma massa sobre uma mola na ponta
coefficient-for-critical-damping = Coeficiente para amortecimento crítico
coefficient-of-damper-n-for-critical-damping-the-others-unchanged = Coeficiente do amortecedor { $n } para o amortecimento crítico, os outros inalterados
columns-of-810-mm-clamped-at-their-feet-beams-at-360-and-810-mm-all-of-one-section-of-29-4-8-mm-steel = Colunas de 810 mm engastadas na base, vigas a 360 e 810 mm, todas de uma seção de 29 × 4,8 mm; aço de 210 GPa e 7800 kg/m³.
cone-by-a-table = Cone por uma tabela
coordinate-x = Coordenada x
coordinate-y = Coordenada y
cubic-finite-elements-with-the-varying-section-integrated-in-each-extrapolated-from-40-and-80 = Elementos finitos cúbicos com a seção variável integrada em cada um, extrapolados de 40 e 80 elementos, independentemente do programa
cylinder-in-a-cylindrical-trough = Cilindro em uma calha cilíndrica
cylinder-in-a-looped-cord = Cilindro em um laço de cabo
dampers = Amortecedores
damping-ratio-from-the-bandwidth-for-light-damping = Fator de amortecimento pela largura de banda, para amortecimento leve
deep-beam-on-a-pin-and-a-roller = Viga alta sobre um pino e um rolete
diameter-at-the-left-end-of-the-table = Diâmetro na extremidade esquerda, da tabela
disc-pulley-with-a-block-and-a-spring = Polia em disco com um bloco e uma mola
displacements-of-the-joints-over-the-largest-of-the-mode = Deslocamentos dos nós sobre o maior do modo
distance-of-a-reference-point = Distância de um ponto de referência
distance-of-the-centre-of-mass-from-the-pivot = Distância do centro de massa ao pivô
distance-of-the-centre-of-the-bar-from-the-pivot = Distância do centro da barra ao pivô
distance-of-the-pivot-from-one-end = Distância do pivô a uma extremidade
double-cross-with-pinned-ends = Cruz dupla com extremidades apoiadas
each-joint-belongs-to-a-member = Cada nó pertence a uma barra
eight-arms-of-5-m-from-one-joint-of-the-seven-vibrations-with-the-joint-at-rest-two-push-it-along-the = Oito braços de 5 m a partir de um nó. Das sete vibrações com o nó em repouso, duas o empurram ao longo dos braços, que se alongam: ficam um pouco abaixo do valor de referência.
ends-of-the-member = Extremidades da barra
equivalent-damping-at-the-point = Amortecimento equivalente no ponto
equivalent-damping-at-the-reference-point-the-same-power = Amortecimento equivalente no ponto de referência: a mesma potência
equivalent-inertia-stiffness-and-damping-of-a-lever-a-rolling-body-or-a-pulley-with-masses-springs = Inércia, rigidez e amortecimento equivalentes de uma alavanca, de um corpo que rola ou de uma polia com massas, molas e amortecedores; frequência natural, fator de amortecimento, estabilidade, amplitude sob um carregamento harmônico.
equivalent-mass-at-the-point = Massa equivalente no ponto
equivalent-moment-of-inertia = Momento de inércia equivalente
equivalent-moment-of-inertia-about-the-pivot = Momento de inércia equivalente em relação ao pivô
equivalent-moment-of-inertia-the-kinetic-energies-add-up = Momento de inércia equivalente: as energias cinéticas se somam
equivalent-stiffness-at-the-point = Rigidez equivalente no ponto
equivalent-stiffness-at-the-reference-point-the-same-potential-energy = Rigidez equivalente no ponto de referência: a mesma energia potencial
equivalent-torsional-damping = Amortecimento torcional equivalente
equivalent-torsional-damping-moment-of-the-dampers-at-one-radian-per-second = Amortecimento torcional equivalente: momento dos amortecedores a um radiano por segundo
equivalent-torsional-stiffness-moment-that-brings-the-body-back-for-each-radian = Rigidez torcional equivalente: momento que traz o corpo de volta, por radiano
exact-damping-ratio-and-are-1-2-2-1-and-with-sin-tan-2 = Fator de amortecimento exato: ω₁² e ω₂² são ωₙ²(1 − 2ζ² ∓ 2ζ√(1 − ζ²)), e com ζ = sen α, tan 2α = (ω₂² − ω₁²)/(ω₂² + ω₁²)
exact-loss-factor-with-hysteretic-damping-and-are-1 = Fator de perda exato com amortecimento histerético: ω₁² e ω₂² são ωₙ²(1 ∓ η)
exact-natural-frequencies-and-mode-shapes-of-a-plane-frame-of-straight-members-in-bending-and-axial = Frequências naturais e formas modais exatas de um pórtico plano de barras retas em flexão e vibração axial, com rótulas, massas e apoios nos nós; comparadas com elementos finitos.
exponential-taper-between-clamps = Afilamento exponencial entre engastes
exponential-taper-between-clamps-closed-form = Afilamento exponencial entre engastes, forma fechada
f-p-beer-and-e-r-johnston-vector-mechanics-for-engineers-dynamics-sample-problem-19-2-8k-3m = F. P. Beer e E. R. Johnston, Vector Mechanics for Engineers: Dynamics, problema resolvido 19.2: ωₙ² = 8k/(3m)
first-joint = Primeiro nó
flat-ground-or-vertical-cord = Piso plano ou cabo vertical
follower-on-an-eccentric-cam = Seguidor sobre um came excêntrico
follower-that-nothing-presses-on-the-cam = Seguidor que nada pressiona contra o came
frequencies-and-mode-shapes-of-a-beam-whose-width-height-or-diameter-varies-linearly-exponentially-or = Frequências e formas modais de uma viga cuja largura, altura ou diâmetro varia linearmente, exponencialmente ou por uma tabela, incluindo cunhas e cones, por Rayleigh–Ritz com sua convergência.
frequency-at-which-contact-is-lost = Frequência em que se perde o contato
frequency-at-which-the-contact-force-is-required = Frequência em que se pede a força de contato
frequency-of-the-load = Frequência do carregamento
frequency-of-the-peak-between-them-is-the-mean-of-and = Frequência do pico entre elas: ωₚ² é a média de ω₁² e ω₂²
frequency-speed-and-amplitude-at-which-a-body-on-a-vibrating-table-a-cam-follower-with-a-spring-or-a = Frequência, velocidade e amplitude em que um corpo sobre uma mesa vibratória, um seguidor de came com mola ou uma roda com suspensão em uma estrada ondulada perde o contato; força de contato em um ciclo.
from-the-left-end-to-the-right-one-distance-diameter = Da extremidade esquerda à direita: distância, diâmetro.
from-the-left-end-to-the-right-one-distance-width-height = Da extremidade esquerda à direita: distância, largura, altura.
from-the-pivot-radius-on-the-pulley-height-above-the-ground-on-a-rolling-body = A partir do pivô; raio na polia; altura acima do piso em um corpo que rola.
half-power-bandwidth = Largura de banda de meia potência
half-power-bandwidth-between-the-frequencies-at-which-the-amplitude-is-1-2-of-its-peak = Largura de banda de meia potência: entre as frequências em que a amplitude é 1/√2 do pico
half-power-frequencies = Frequências de meia potência
half-power-frequencies-in-the-wrong-order = Frequências de meia potência na ordem errada
half-power-frequencies-of-a-mode-with-0-05-and-10-hz = Frequências de meia potência de um modo com ζ = 0,05 e 10 Hz
hanging-lever-with-a-counterweight-and-a-dashpot = Alavanca pendente com um contrapeso e um amortecedor
hanging-vertically = Pendente na vertical
harmonic-load = Carregamento harmônico
height-at-the-left-end-of-the-table = Altura na extremidade esquerda, da tabela
hinged-at-both-joints = Rotulada nos dois nós
hinged-at-the-first-joint = Rotulada no primeiro nó
hinged-at-the-second-joint = Rotulada no segundo nó
if-given-mass-stiffness-and-damping-are-also-reduced-to-that-point-from-the-pivot-the-ground-or-the = Se dada, massa, rigidez e amortecimento também são reduzidos a esse ponto. A partir do pivô, do piso ou do eixo.
if-given-speeds-along-it-are-also-answered = Se dado, também se respondem as velocidades ao longo dela.
inside-of-a-cylinder = Interior de um cilindro
inverted-pendulum-held-by-a-spring = Pêndulo invertido mantido por uma mola
inverted-pendulum-on-a-spring-that-is-too-soft = Pêndulo invertido com uma mola macia demais
it-does-not-slip-on-the-ground-or-on-a-vertical-cord = Não desliza sobre o piso, nem sobre um cabo vertical.
it-vibrates-on-the-beam-across-it = Vibra sobre a viga, transversalmente a ela.
j-0-03-0-0675-0-03375-0-13125-kg-m-k-18-n-m-rad-c-1-08-n-m-s-rad = J = 0,03 + 0,0675 + 0,03375 = 0,13125 kg·m², K = 18 N·m/rad, C = 1,08 N·m·s/rad.
j-0-09-0-1152-0-2052-kg-m-k-56-25-n-m-rad-c-3-75-n-m-s-rad = J = 0,09 + 0,1152 = 0,2052 kg·m², K = 56,25 N·m/rad, C = 3,75 N·m·s/rad.
j-0-8-0-02-0-01-0-83-kg-m-k-9-81-1-4-0-1-12-753-n-m-rad-c-0-54-n-m-s-rad = J = 0,8 + 0,02 + 0,01 = 0,83 kg·m², K = 9,81 (1,4 − 0,1) = 12,753 N·m/rad, C = 0,54 N·m·s/rad.
j-wr-g-0-2-kg-m-k-k-a-20-n-m-rad = J = WR²/g = 0,2 kg·m², K = k a² = 20 N·m/rad
l-frame-clamped-at-both-ends = Pórtico em L engastado nas duas extremidades
largest-contact-force = Máxima força de contato
largest-contact-force-while-contact-lasts = Máxima força de contato enquanto há contato
least-contact-force = Mínima força de contato
least-contact-force-against-frequency = Mínima força de contato em função da frequência
least-contact-force-below-zero-contact-is-lost = Mínima força de contato; abaixo de zero, perde-se o contato
least-stiffness-for-stability = Rigidez mínima para a estabilidade
least-stiffness-of-spring-n-for-stability-the-equivalent-stiffness-is-then-zero = Rigidez mínima da mola { $n } para a estabilidade: a rigidez equivalente é então zero
length-of-the-member = Comprimento da barra
lever-on-a-pivot = Alavanca sobre um pivô
lever-that-nothing-brings-back = Alavanca que nada traz de volta
lever-rolling-body-or-pulley = Alavanca, corpo que rola ou polia
loss-factor-for-light-damping = Fator de perda, para amortecimento leve
loss-factor-half-power-points = Fator de perda, pontos de meia potência
loss-of-contact = Perda de contato
lower-half-power-frequency = Frequência inferior de meia potência
lowest-frequency-at-which-the-amplitude-of-the-contact-force-a-m-m-k-ic-k-m-ic-is-n = Menor frequência em que a amplitude da força de contato, ω² A|m + M(k + icω)/(k − Mω² + icω)|, é N₀
mass-of-the-member = Massa da barra
mass-of-the-wheel = Massa da roda
masses-on-cords = Massas em cabos
masses-on-springs-in-mode = Massas sobre molas no modo
masses-on-the-lever = Massas na alavanca
mean-contact-force-the-weight-of-both-masses = Força de contato média: o peso das duas massas
member-clamped-at-one-end-and-hinged-at-the-other = Barra engastada em uma extremidade e rotulada na outra
member-hinged-at-both-ends = Barra rotulada nas duas extremidades
members-end-at-joints-of-the-list = As barras terminam em nós da lista
modal-loss-factor = Fator de perda modal
modal-loss-factor-loss-factor-of-each-spring-times-its-share-of-the-strain-energy-of-the-mode = Fator de perda modal: fator de perda de cada mola vezes sua parte na energia de deformação do modo
moment-of-inertia-about-the-centre = Momento de inércia em relação ao centro
moment-of-inertia-about-the-pivot = Momento de inércia em relação ao pivô
moment-of-inertia-about-the-point-of-contact-which-is-at-rest-j-g-m-r = Momento de inércia em relação ao ponto de contato, que está em repouso: J_G + m r²
moment-of-inertia-of-a-solid-cylinder-about-its-centre = Momento de inércia de um cilindro maciço em relação ao centro
moment-of-inertia-of-a-solid-sphere-about-its-centre = Momento de inércia de uma esfera maciça em relação ao centro
moment-of-inertia-of-a-thin-ring-about-its-centre = Momento de inércia de um anel fino em relação ao centro
moment-of-inertia-of-mass-n-about-the-pivot = Momento de inércia da massa { $n } em relação ao pivô
moment-of-inertia-of-the-bar-about-the-pivot-m-l-12-m-d = Momento de inércia da barra em relação ao pivô: m L²/12 + m d²
moment-of-the-weights-for-each-radian-they-bring-the-lever-back = Momento dos pesos por radiano: trazem a alavanca de volta
moment-of-the-weights-for-each-radian-they-upset-the-lever = Momento dos pesos por radiano: tombam a alavanca
nafems-test-fv2-target-in-the-verification-problem-vmp09-t2-of-ansys-mechanical-apdl = NAFEMS, teste FV2; valor de referência no problema de verificação VMP09-T2 do Ansys Mechanical APDL
n-min = N_min
natural-frequency-against-the-stiffness-of-the-first-spring = Frequência natural em função da rigidez da primeira mola
natural-frequency-of-the-mass-on-the-spring = Frequência natural da massa sobre a mola
negative-on-the-other-side-of-the-pivot = Negativa do outro lado do pivô.
numbered-in-this-order = Numerados nesta ordem.
of-the-peak-if-omitted-it-follows-from-the-two-half-power-frequencies = Do pico. Se omitida, decorre das duas frequências de meia potência.
of-the-table-the-follower-or-the-road-zero-to-peak-unless-the-unit-says-otherwise = Da mesa, do seguidor ou da estrada: de zero a pico, salvo se a unidade disser outra coisa.
omitted-for-a-point-mass = Omitido para uma massa pontual.
omitted-for-a-spring-along-the-motion = Omitido para uma mola ao longo do movimento.
phase-by-which-the-motion-lags = Fase com que o movimento se atrasa
pinned-aluminium-beam-under-compression = Viga biapoiada de alumínio sob compressão
f-n-n-2l-ei-m-1-n-n-n-cr-with-n-cr-ei-l = f_n = (n²π/(2L²))√(EI/m̄)√(1 − N/(n²N_cr)) com N_cr = π²EI/L²
pinned-beam-with-a-mass-on-a-spring-at-midspan = Viga biapoiada com uma massa sobre uma mola no meio do vão
pivoted-bar-with-a-mass-a-spring-and-a-dashpot = Barra pivotada com uma massa, uma mola e um amortecedor
plane-frame = Pórtico plano
position-of-equilibrium = Posição de equilíbrio
pulley-by-its-wr = Polia por seu WR²
pulley-on-a-fixed-axle = Polia sobre um eixo fixo
radius-of-the-surface = Raio da superfície
radius-on-the-pulley-height-above-the-ground-on-a-rolling-body = Raio na polia; altura acima do piso em um corpo que rola.
rigid-at-both-joints = Rígida nos dois nós
rigid-body-motions-of-an-unsupported-frame-are-not-included = Os movimentos de corpo rígido de um pórtico sem apoios não são incluídos.
rim-with-a-spring-at-30-to-its-motion = Aro com uma mola a 30° de seu movimento
ring-held-by-a-spring-at-its-top = Anel mantido por uma mola em seu topo
roller-that-moves-along-x = Rolete que se move ao longo de x
roller-that-moves-along-y = Rolete que se move ao longo de y
roller-with-a-block-on-a-cord-spring-and-dashpot = Rolo com um bloco em um cabo, mola e amortecedor
rolling-body = Corpo que rola
rolling-cylinder-held-by-a-spring-at-its-centre = Cilindro que rola, mantido por uma mola em seu centro
root-of-the-determinant-of-the-exact-dynamic-stiffness-of-all-members-with-the-frequencies-below-it = Raiz do determinante da rigidez dinâmica exata de todas as barras, com as frequências abaixo dela contadas
rotary-inertia-of-the-sections-radius-of-gyration-squared = Inércia rotativa das seções: raio de giração ao quadrado
second-joint = Segundo nó
shear-flexibility-ei-ga-of-the-member-g-e-2-1 = Flexibilidade ao cisalhamento EI/(κGA) da barra, G = E/(2(1 + ν))
solid-cylinder-or-disc = Cilindro maciço ou disco
solid-sphere = Esfera maciça
speed-along-the-road-one-wavelength-in-each-cycle = Velocidade ao longo da estrada: um comprimento de onda em cada ciclo
speed-at-which-contact-is-lost = Velocidade em que se perde o contato
sphere-in-a-cylindrical-trough = Esfera em uma calha cilíndrica
spring-that-presses-it-on-the-surface = Mola que o pressiona contra a superfície
spring-n-it-stretches-by-a-cos-and-its-force-has-the-arm-a-cos = Mola { $n }: alonga-se a θ cos α, e sua força tem o braço a cos α
spring-n-its-end-moves-by-a-and-its-force-k-a-has-the-arm-a = Mola { $n }: sua extremidade se move a θ, e sua força k a θ tem o braço a
sprung-wheel = Roda com suspensão
sprung-wheel-on-a-wavy-road = Roda com suspensão em uma estrada ondulada
stable-for-k-m-g-l-a-109-n-m = Estável para k > m g l/a² = 109 N/m
standing-vertically = De pé na vertical
stepped-pulley-with-a-block-a-spring-and-a-dashpot = Polia escalonada com um bloco, uma mola e um amortecedor
strip-that-swells-and-tapers = Tira que engrossa e afila
sum-of-the-masses-times-their-distances-from-the-pivot = Soma das massas vezes suas distâncias ao pivô
surface = Superfície
symmetric-portal-frame-with-two-beams = Pórtico simétrico com duas vigas
table-of-a-circular-section = Tabela de uma seção circular
table-of-a-rectangle = Tabela de um retângulo
the-approximation-of-the-bandwidth-0-05025-about-the-peak-is-a-little-above-the-exact-ratio = A aproximação da largura de banda, 0,05025 em torno do pico, fica um pouco acima do fator exato.
the-body-on-the-moving-surface = O corpo sobre a superfície móvel
the-centre-moves-by-r-on-a-circle-of-radius-r-r-moment-of-the-weight-for-each-radian = O centro se move r θ em um círculo de raio R − r: momento do peso por radiano
the-cord-is-fixed-on-one-side-where-the-cylinder-is-at-rest-and-held-by-the-spring-on-the-other-which = O cabo é fixo de um lado, onde o cilindro está em repouso, e mantido pela mola do outro, que se move 2rθ.
the-corner-does-not-move-turning-it-pins-both-members-at-rest-it-clamps-them-ei-2000-n-m-2-kg-m-1-m = O canto não se desloca: girando, apoia as duas barras; em repouso, engasta-as. EI = 2000 N·m², 2 kg/m, 1 m.
the-frame = O pórtico
the-frequencies-are-written-as-multiples-of-ei-m-l-of-the-first-member = As frequências são escritas como múltiplos de √(EI₁/(m̄₁L₁⁴)), da primeira barra
the-hinge-moves-cos-cosh-1-or-rests-tan-tanh = A rótula se move, cos β cosh β = −1, ou fica em repouso, tan β = tanh β
the-lever = A alavanca
the-lower-frequency-lies-below-the-peak = A frequência inferior fica abaixo do pico
the-modes-with-a-node-at-midspan-leave-the-mass-at-rest = Os modos com um nó no meio do vão deixam a massa em repouso.
the-other-end-lies-on-the-side-of-the-positive-distances = A outra extremidade fica do lado das distâncias positivas.
the-page-prints-the-formula-with-4-kg-and-4000-n-m-it-gives-25-82-rad-s = A página traz a fórmula; com 4 kg e 4000 N/m ela dá 25,82 rad/s.
the-peak-lies-between-its-half-power-frequencies = O pico fica entre suas frequências de meia potência
the-positive-distances-are-above-the-pivot = As distâncias positivas ficam acima do pivô.
the-positive-distances-are-below-the-pivot = As distâncias positivas ficam abaixo do pivô.
the-printed-values-are-those-of-2-y-in-place-of-2-y-w-e-x-y-leads-to-y-2-y-y-0-as-of-a-beam-in = Os valores impressos são os de + 2α²y'' em lugar de − 2α²y'': w = e^(αx)y leva a y'''' − 2α²y'' + (α⁴ − β⁴)y = 0, como de uma viga sob tração, de modo que o afilamento eleva a primeira frequência acima dos 144,59 Hz da tira uniforme. Elementos finitos dão 145,877 Hz, e o manual que cita o guia encontra 145,57 Hz com cisalhamento.
the-pulley = A polia
the-rolling-body = O corpo que rola
the-springs-balance-the-weights-which-have-no-other-effect = As molas equilibram os pesos, que não têm outro efeito.
the-support-does-not-move-nor-does-the-beam-there = O apoio não se move, nem a viga ali
the-table-leads-from-one-end-to-the-other = A tabela vai de uma extremidade à outra
the-tip-is-free-along-y-alone = A ponta é livre apenas ao longo de y.
the-tip-of-a-cone-clamped-at-its-base-8-719-kirchhoff = A ponta de um cone engastado na base: Λ = 8,719 (Kirchhoff)
thin-ring-or-tube = Anel fino ou tubo
torsional-damper = Amortecedor torcional
tube-between-clamps = Tubo entre engastes
two-cantilevers-joined-by-a-hinge = Duas vigas em balanço unidas por uma rótula
two-equal-members-that-do-not-stretch-the-corner-turns-or-rests-cos-sinh-sin-cosh-and-cos-cosh-1 = Duas barras iguais que não se alongam: o canto gira ou fica em repouso, cos β sinh β = sen β cosh β e cos β cosh β = 1
two-joints-at-one-place = Dois nós em um lugar
undamped-lever-at-resonance = Alavanca sem amortecimento na ressonância
uniform-bar = Barra uniforme
upper-half-power-frequency = Frequência superior de meia potência
variation-between-the-points = Variação entre os pontos
vibrations-illustrated-course-online-flipbuilder-com-yeqn-fayu-p-20 = Vibrations (curso ilustrado, online.flipbuilder.com/yeqn/fayu), p. 20
wavelength-of-the-road = Comprimento de onda da estrada
wheel-on-a-torsional-spring-under-a-harmonic-moment = Roda sobre uma mola torcional sob um momento harmônico
width-at-the-left-end-of-the-table = Largura na extremidade esquerda, da tabela
with-a-period-of-2-65-s-the-page-finds-1-747-m-as-the-amplitude-of-separation-from-rounded-to-2-37 = Com um período de 2,65 s a página encontra 1,747 m como amplitude de separação, com ω arredondado para 2,37 rad/s; é 1,745 m.
without-weight-and-spring-there-is-no-contact-force = Sem peso e mola não há força de contato
zero-for-a-follower-that-moves-horizontally = Zero para um seguidor que se move na horizontal.
a-mass-on-a-spring-stands-on-a-support-of-the-beam-and-vibrates-alone-remove-it = uma massa sobre uma mola está sobre um apoio da viga e vibra sozinha: retire-a
a-member-is-so-slender-or-the-frequencies-are-so-high-that-its-waves-cannot-be-resolved-ask-for-fewer = uma barra é tão esbelta, ou as frequências são tão altas, que suas ondas não podem ser resolvidas: peça menos frequências
a-wheel-without-weight-does-not-press-on-the-road-write-the-gravity = uma roda sem peso não pressiona a estrada: escreva a gravidade
amplitude-at-the-lower-half-power-frequency-1-2-of-the-peak = amplitude na frequência inferior de meia potência: 1/√2 do pico
amplitude-at-the-upper-half-power-frequency-1-2-of-the-peak = amplitude na frequência superior de meia potência: 1/√2 do pico
amplitude-of-the-contact-force-from-spring-damper-and-inertia-of-the-wheel = amplitude da força de contato por mola, amortecedor e inércia da roda
amplitude-of-the-point-from-the-equivalent-mass-stiffness-and-damping-there = amplitude do ponto por massa, rigidez e amortecimento equivalentes ali
at-this-frequency-contact-is-lost-in-each-cycle-the-forces-are-those-of-a-surface-that-would-hold-the = nesta frequência perde-se o contato em cada ciclo: as forças são as de uma superfície que prendesse o corpo
bandwidth-of-a-mode-with-the-exact-damping-ratio-from-its-half-power-frequencies-in-closed-form = largura de banda de um modo com o fator de amortecimento exato, por suas frequências de meia potência em forma fechada
bandwidth-over-twice-the-damping-ratio-the-frequency-between = largura de banda sobre o dobro do fator de amortecimento: a frequência entre elas
both-joints-of-member-n-have-the-same-coordinates-correct-one-of-them = os dois nós da barra { $n } têm as mesmas coordenadas: corrija um deles
contact-is-lost = perde-se o contato
cos-cosh-1-f-2-l-e-d-d-16 = cos β cosh β = 1, f = β²/(2πL²)·√(E(D² + d²)/(16ρ))
round-cantilever-away-from-the-origin = Barra redonda em balanço, afastada da origem
closed-form-cos-cosh-1-f-2-l-d-4-e-l-0-9-1-2-m = forma fechada: cos β cosh β = −1, f = β²/(2πL²)·(d/4)·√(E/ρ), L = √(0,9² + 1,2²) m
doubtnut-com-qqkdweke3t-2k-3m-numbers-of-askfilo-com-3430393239313731 = doubtnut.com, QQkdWeke3T: ωₙ = √(2k/3m); números de askfilo.com 3430393239313731
elements-in-each-member = elementos em cada barra
hysteretic-damping-half-the-power-of-the-peak-where-1-is-the-loss-factor = amortecimento histerético: metade da potência do pico onde 1 − (ω/ωₙ)² é o fator de perda
inertia-force-at-the-top-at-that-frequency-all-that-presses-the-body-down = força de inércia no topo nessa frequência: tudo o que pressiona o corpo para baixo
kinetic-energy-at-a-unit-speed-of-the-reference-point = energia cinética com velocidade unitária do ponto de referência
largest-contact-force-of-a-cycle = máxima força de contato de um ciclo
least-contact-force-of-a-cycle = mínima força de contato de um ciclo
loss-factors-are-those-of-the-springs-of-a-chain-choose-a-chain-or-leave-the-loss-factors-out = os fatores de perda são os das molas de uma cadeia: escolha uma cadeia, ou deixe-os de fora
member-n-begins-and-ends-at-the-same-joint-write-two-joints = a barra { $n } começa e termina no mesmo nó: escreva dois nós
member-n-ends-at-a-joint-that-does-not-exist-there-are-count-joints = a barra { $n } termina em um nó que não existe: há { $count } nós
member-n-is-less-than-ten-times-as-long-as-deep-shear-and-rotary-inertia-lower-the-frequencies-choose = o comprimento da barra { $n } é menor que dez vezes sua altura: cisalhamento e inércia rotativa reduzem as frequências; escolha a teoria de Timoshenko
mode-mode-energy-lost-in-the-springs-over-2-times-the-strain-energy = modo { $mode }: energia perdida nas molas, sobre 2π vezes a energia de deformação
moment-a-quarter-of-a-cycle-ahead-of-the-motion-that-of-the-dampers = momento um quarto de ciclo à frente do movimento: o dos amortecedores
moment-in-phase-with-the-motion-springs-less-inertia = momento em fase com o movimento: molas menos inércia
no-equivalent-stiffness-is-left-with-the-least-stiffness-of-spring-n = não resta rigidez equivalente com a rigidez mínima da mola { $n }
no-member-ends-at-joint-n-remove-it-or-write-a-member-to-it = nenhuma barra termina no nó { $n }: retire-o, ou escreva uma barra até ele
nothing-brings-the-body-back-to-its-position-write-a-spring-or-the-weight-of-a-hanging-lever = nada traz o corpo de volta à sua posição: escreva uma mola, ou o peso de uma alavanca pendente
nothing-on-the-light-lever-has-mass-at-a-distance-from-the-pivot-write-a-mass-or-the-mass-of-the-bar = nada na alavanca leve tem massa a uma distância do pivô: escreva uma massa, ou a massa da barra
nothing-presses-the-body-on-the-surface-write-a-preload-of-the-spring-or-the-gravity = nada pressiona o corpo contra a superfície: escreva uma pré-carga da mola, ou a gravidade
physicsforums-com-thread-635713-simple-harmonic-motion-find-amplitude-given-period = physicsforums.com, tópico 635713, Simple harmonic motion: find amplitude given period
potential-energy-at-a-unit-displacement-of-the-reference-point = energia potencial com deslocamento unitário do ponto de referência
power-of-the-dampers-at-a-unit-speed-of-the-reference-point = potência dos amortecedores com velocidade unitária do ponto de referência
qammunity-org-question-11428478 = qammunity.org, questão 11428478
some-frequencies-coincide-any-linear-combination-of-their-mode-shapes-is-also-a-mode-shape = algumas frequências coincidem: qualquer combinação linear de suas formas modais também é uma forma modal
tan-tanh = tan β = tanh β
the-chain-has-no-spring-n-springs-count-from-the-left-that-before-mass-1-is-the-first = a cadeia não tem a mola { $n }: as molas se contam da esquerda, a que precede a massa 1 é a primeira
the-damping-is-not-below-the-critical-one-the-body-returns-without-oscillating = o amortecimento não está abaixo do crítico: o corpo retorna sem oscilar
the-distances-in-the-table-do-not-ascend-write-each-place-once-from-the-left-end-to-the-right-one = as distâncias na tabela não são crescentes: escreva cada posição uma vez, da extremidade esquerda à direita
the-frame-can-move-without-deformation-n-such-motions-at-frequency-zero-precede-the-first-frequency = o pórtico pode mover-se sem deformação: { $n } desses movimentos de frequência zero precedem a primeira frequência
the-frequencies-of-the-frame-cannot-be-found-members-masses-and-springs-differ-too-much-in-magnitude = as frequências do pórtico não podem ser encontradas: barras, massas e molas diferem demais em ordem de grandeza
the-manual-that-quotes-the-guide-finds-our-values-for-this-density = o manual que cita o guia encontra nossos valores para esta densidade
the-last-digit-of-the-target-is-rounded-up = o último algarismo do valor de referência é arredondado para cima
the-load-has-the-natural-frequency-and-nothing-damps-the-motion-it-grows-without-limit-write-another = o carregamento tem a frequência natural e nada amortece o movimento: ele cresce sem limite; escreva outra frequência ou um amortecedor
the-loss-factor-at-resonance-is-twice-the-damping-ratio = o fator de perda na ressonância é o dobro do fator de amortecimento
the-lower-half-power-frequency-is-not-below-the-upper-one-exchange-the-two-frequencies = a frequência inferior de meia potência não está abaixo da superior: troque as duas frequências
the-natural-frequency-does-not-lie-between-the-two-half-power-frequencies-write-the-frequency-of-the = a frequência natural não fica entre as duas frequências de meia potência: escreva a frequência do pico entre elas
the-natural-frequency-lies-away-from-the-middle-of-the-two-half-power-frequencies-where-one-mode = a frequência natural fica longe do meio das duas frequências de meia potência, onde um só modo tem seu pico ({ $peak }): há outro modo ou um erro de leitura nesses números
the-page-prints-one-digit = a página traz um algarismo
the-page-rounds-to-2-37-rad-s = a página arredonda ω para 2,37 rad/s
the-position-is-unstable-the-springs-give-held-and-the-weights-take-taken-from-it-write-stiffer = a posição é instável: as molas dão { $held }, e os pesos tiram { $taken }; escreva molas mais rígidas ou braços maiores
the-response-from-twice-as-many-real-equations-in-phase-and-a-quarter-of-a-cycle-ahead = a resposta por um sistema com o dobro de equações reais, em fase e um quarto de ciclo à frente
the-surface-is-not-wider-than-the-body-that-rolls-in-it-write-a-radius-of-the-surface-above-that-of = a superfície não é mais larga que o corpo que rola nela: escreva um raio da superfície maior que o do corpo
the-table-does-not-lead-from-the-left-end-to-the-right-one-its-first-distance-is-0-its-last-one-the = a tabela não vai da extremidade esquerda à direita: sua primeira distância é 0, a última o comprimento da viga
the-table-has-fewer-than-two-points-write-at-least-those-of-both-ends = a tabela tem menos de dois pontos: escreva ao menos os das duas extremidades
the-table-has-more-than-30-points-leave-some-of-them-out = a tabela tem mais de 30 pontos: deixe alguns de fora
the-target-is-that-of-arms-that-do-not-stretch = o valor de referência é o de braços que não se alongam
the-wheel-keeps-contact-at-all-frequencies-that-can-be-examined-check-masses-stiffness-and-amplitude = a roda mantém o contato em todas as frequências que podem ser examinadas: verifique massas, rigidez e amplitude
there-are-more-than-60-joints-or-members-join-members-that-continue-each-other-or-use-a-finite = há mais de 60 nós ou barras: una barras que se prolongam, ou use um programa de elementos finitos
time-of-a-wavelength-at-that-speed-a-period = tempo de um comprimento de onda nessa velocidade: um período
u-mode-n = u, modo { $n }
v-mode-n = v, modo { $n }
w-e-x-y-y-2-y-y-0-with-y-y-0-at-both-ends-1-m = w = e^(αx)y, y'''' − 2α²y'' + (α⁴ − β⁴)y = 0 com y = y' = 0 nas duas extremidades, α = 1/m
with-that-coefficient-of-damper-n-the-damping-is-critical = com esse coeficiente do amortecedor { $n } o amortecimento é crítico
m-k-t-j-with-j-m = Θ = M₀/(k_t − J ω²) com J = m κ²
ei-1-cos-cosh-k-l-cos-sinh-sin-cosh-k-5-kn-m = β³EI(1 + cos β cosh β) = k L³(cos β sinh β − sin β cosh β), k = 5 kN/m
ei-1-cos-cosh-k-e-l-cos-sinh-sin-cosh-with-k-e-k-m-m-k = β³EI(1 + cos β cosh β) = k_e L³(cos β sinh β − sin β cosh β) com k_e = k m ω²/(m ω² − k)
i-g-a-i-1-e-g-k-ei-k-0-k-l-5-6-rod-e-4l = ρ²I ω⁴/(κG) − (ρA + ρI(1 + E/κG)k²) ω² + EI k⁴ = 0, k = π/L, κ = 5/6; barra √(E/ρ)/(4L)
a-m-m-k-ic-k-m-ic-m-m-g-solved-by-bisection-independently-of-the-program = ω² A|m + M(k + icω)/(k − Mω² + icω)| = (m + M)g, resolvida por bisseção independentemente do programa
and-are-1-2-2-1 = ω₁² e ω₂² são ωₙ²(1 − 2ζ² ∓ 2ζ√(1 − ζ²))
k-a-m-g-l-m-l-stable-for-k-m-g-l-a = ωₙ² = (k a² − m g l)/(m l²); estável para k > m g l/a²
k-j-10-rad-s = √(K/J) = 10 rad/s

# Half-power points, equivalent-system, plane-frame, sprung masses, loss-of-contact, tables of tapered beams, loss factors
k-m-ih-x-f-solved-independently-of-the-program-r-k-k = (K − ω²M + iH)X = F resolvida independentemente do programa; η_r = Σηⱼkⱼ(Δφⱼ)²/Σkⱼ(Δφⱼ)²
k-m-ih-x-f-with-h-0-3-2000-n-m-solved-independently-of-the-program-r-k-k = (K − ω²M + iH)X = F com H₁₁ = 0,3·2000 N/m, resolvida independentemente do programa; η_r = Σηⱼkⱼ(Δφⱼ)²/Σkⱼ(Δφⱼ)²
a-loss-factor-of-a-spring-that-does-not-exist = Um fator de perda de uma mola que não existe
counted-from-the-left-the-spring-before-mass-1-is-the-first-that-to-the-wall-on-the-right-the-last = Contada da esquerda: a mola antes da massa 1 é a primeira, a que vai à parede da direita a última.
critical-torsional-damping-2-k-eq-j-eq = Amortecimento torcional crítico: 2√(K_eq J_eq)
damper-n-its-end-moves-at-b-and-its-force-c-b-has-the-arm-b = Amortecedor { $n }: sua extremidade se move a b θ′, e sua força c b θ′ tem o braço b
dynamic-stiffness-of-springs-and-inertia-k-eq-j-eq = Rigidez dinâmica, de molas e inércia: K_eq − J_eq ω²
equivalent-mass-at-the-reference-point-the-same-kinetic-energy-x-p = Massa equivalente no ponto de referência: a mesma energia cinética, x = p θ
mass-n-moves-by-l-its-part-in-the-moment-of-inertia = A massa { $n } se move l θ: sua parte no momento de inércia
critical-damping-leaves-one-root-c-c-4-k-eq-j-eq = o amortecimento crítico deixa uma raiz: C_c² = 4 K_eq J_eq
energy-in-the-springs-and-of-the-lifted-weights-in-one-displacement-k-eq = energia nas molas e dos pesos elevados em um deslocamento: ½ K_eq θ²
kinetic-energy-of-all-parts-at-the-speeds-of-one-motion-j-eq = energia cinética de todas as partes com as velocidades de um movimento: ½ J_eq θ′²
power-of-the-dampers-at-one-speed-c-eq = potência dos amortecedores com uma velocidade: C_eq θ′²
product-of-the-roots-i-d-of-the-characteristic-equation-k-eq-j-eq = produto das raízes −ζωₙ ± iω_d da equação característica: K_eq/J_eq
twice-the-rate-of-decay-2-is-c-eq-j-eq = o dobro da taxa de decaimento, 2ζωₙ, é C_eq/J_eq

# Half-power points, equivalent-system, plane-frame, sprung masses, loss-of-contact, tables of tapered beams, loss factors
hysteretic-damping-beside-any-other-the-stiffness-of-such-a-spring-is-k-1-i = Amortecimento histerético, além de qualquer outro: a rigidez de tal mola é k(1 + iη).
loss-factors-of-springs = Fatores de perda de molas
the-natural-frequencies-are-500-and-2000-rad-s-two-thirds-and-one-third-of-their-strain-energies-are = As frequências naturais são √500 e √2000 rad/s; dois terços e um terço de suas energias de deformação estão na primeira mola.
three-equal-masses-between-walls-two-springs-of-other-material = Três massas iguais entre paredes, duas molas de outro material
three-masses-without-a-wall-on-the-right-have-three-springs = Três massas sem parede à direita têm três molas
two-masses-the-first-spring-of-rubber = Duas massas, a primeira mola de borracha

# Half-power points, equivalent-system, plane-frame, sprung masses, loss-of-contact, tables of tapered beams, loss factors
contact-force-at-the-lowest-position-at-rest-weight-and-preload-of-the-spring = Força de contato na posição mais baixa, em repouso: peso e pré-carga da mola
contact-force-in-the-middle-of-the-stroke-the-spring-is-compressed-by-a = Força de contato no meio do curso: a mola é comprimida de A
force-of-the-spring-at-the-lowest-position-of-the-body = Força da mola na posição mais baixa do corpo.
preload = Pré-carga
sums-over-the-parts-j-m-l-12-d-m-l-k-k-a-c-c-b-k-j-c-2-jk = Somas sobre as partes: J = m(L²/12 + d²) + m₁l₁², K = k a², C = c b², ωₙ = √(K/J), ζ = C/(2√(JK))
least-contact-force-with-that-amplitude = mínima força de contato com essa amplitude
the-tip-is-a-thousandth-of-the-base-and-not-a-point = a ponta é um milésimo da base e não um ponto
n-1-cos-2-t-t-d-2-it-begins-and-ends-smoothly = (1 − cos 2πt/t_d)/2: começa e termina suavemente.
n-1-e-t-it-tends-to-its-maximum = 1 − e^(−t/τ): tende ao seu máximo.
a-spring-of-800-n-m-at-0-6-m-and-a-damper-of-20-n-s-m-at-0-4-m-below-the-pivot-3-2-n-m-s-rad = Uma mola de 800 N/m a 0,6 m e um amortecedor de 20 N·s/m a 0,4 m abaixo da articulação: 3,2 N·m·s/rad.
about-its-centre-of-mass-or-about-a-parallel-axis = Em relação ao seu centro de massa, ou a um eixo paralelo.
about-the-axis-through-the-centre-of-mass = Em relação ao eixo pelo centro de massa.
amplitude-of-the-body = Amplitude do corpo
amplitude-of-the-rotation-of-the-base = Amplitude da rotação da base
amplitude-of-the-torque-in-spring-and-damper-it-accelerates-the-body = Amplitude do torque na mola e no amortecedor: ele acelera o corpo
angle-at-time = Ângulo no instante
angle-of-the-body-at-that-time = Ângulo do corpo nesse instante
angle-time-history = Ângulo ao longo do tempo
angular-acceleration-of-the-base = Aceleração angular da base
angular-impulse-of-the-whole-pulse-given = Impulso angular do pulso inteiro dado
angular-impulse-on-the-body = Impulso angular sobre o corpo
body-beside-its-axis-by-the-radius-of-gyration = Corpo ao lado do seu eixo, pelo raio de giração
body-that-rolls-without-slipping = Corpo que rola sem deslizar
linear-coefficient = Coeficiente linear
quadratic-coefficient = Coeficiente quadrático
constant-term = Termo constante
cylinder-that-oscillates-across-a-wire = Cilindro que oscila atravessado num fio
cylinder-that-rolls-between-two-springs = Cilindro que rola entre duas molas
disc-on-a-shaft-critically-damped = Disco num eixo, criticamente amortecido
disc-or-solid-cylinder-its-own-axis = Disco ou cilindro maciço, no próprio eixo
disc-that-rolls-under-a-sudden-force = Disco que rola sob uma força súbita
distance-from-the-axis-to-the-centre = Distância do eixo ao centro
equal-springs-side-by-side = Molas iguais lado a lado
equal-springs-side-by-side-their-stiffnesses-add-up = Molas iguais lado a lado: as suas rigidezes se somam
equivalent-mass-of-the-body-that-rolls-m-j-g-r-its-kinetic-energy-over-half-the-square-of-its = Massa equivalente do corpo que rola, m + J_G/r²: a sua energia cinética sobre metade do quadrado da sua velocidade
exponential-rise = Subida exponencial
for-a-rotation-the-angle-is-that-relative-to-the-base = Para uma rotação. O ângulo é relativo à base.
fourier-coefficients-of-a-periodic-force-torque-or-base-motion-and-the-steady-state-response-to-each = Coeficientes de Fourier de uma força, de um torque ou de um movimento da base periódicos, e a resposta em regime permanente a cada harmônico e a todos eles.
frequency-of-the-cosine-of-which-the-pulse-is-one-wave = Frequência do cosseno de que o pulso é uma onda
frequency-ratio-of-that-cosine = Razão de frequências desse cosseno
f-3i-2t-d-the-motion-by-numerical-integration-of-its-equation-step-by-step = F₀ = 3I/(2t_d); o movimento por integração numérica da sua equação, passo a passo
initial-rotation = Rotação inicial
j-w-g-g-d-the-motion-by-numerical-integration-of-its-equation = J = (W/g)(κ_G² + d²); o movimento por integração numérica da sua equação
j-m-d-16-l-12-ln-50-t-the-motion-by-numerical-integration-of-its-equation = J = m(D²/16 + L²/12), ζ = ln 50/(ωₙtₛ); o movimento por integração numérica da sua equação
j-m-a-b-12-md-with-d-half-the-diagonal-k-mgd-the-motion-by-numerical-integration-of-its-equation = J = m(a² + b²)/12 + md² com d igual à metade da diagonal, K = mgd; o movimento por integração numérica da sua equação
j-md-10-k-t-j-ln-2-10-the-motion-by-numerical-integration-of-its-equation = J = mD²/10, k_t = Jωₙ², δ = (ln 2)/10; o movimento por integração numérica da sua equação
j-md-4-m-d-2-k-mgd-2-ln-1-s-ln-1-s = J = mD²/4 + m(D/2)², K = mgD/2, ζ = ln(1/s)/√(π² + (ln(1/s))²)
j-ml-3-k-ka-mgl-2-c-cb-the-motion-by-numerical-integration-of-its-equation = J = mL²/3, K = ka² + mgL/2, C = cb²; o movimento por integração numérica da sua equação
mass-or-inertia-and-period = Massa ou inércia, e período
mass-or-moment-of-inertia = Massa ou momento de inércia
moving-mass = Massa em movimento
mass-under-a-force-that-rises-exponentially = Massa sob uma força que sobe exponencialmente
mass-under-a-parabolic-arch-of-known-impulse = Massa sob um arco parabólico de impulso conhecido
mass-under-a-parabolic-force-that-falls-to-zero = Massa sob uma força parabólica que cai a zero
mass-under-a-versed-sine-pulse = Massa sob um pulso de seno verso
mass-with-a-known-natural-frequency = Massa com uma frequência natural conhecida
maximum-absolute-angular-acceleration = Aceleração angular absoluta máxima
maximum-angle-after-the-load = Ângulo máximo depois da carga
maximum-angular-acceleration = Aceleração angular máxima
maximum-of-the-load-the-impulse-is-the-area-of-the-half-sine-2f-t-d = Máximo da carga: o impulso é a área da meia-onda senoidal, 2F₀t_d/π
maximum-of-the-load-the-impulse-is-the-area-of-the-rectangle-f-t-d = Máximo da carga: o impulso é a área do retângulo, F₀t_d
maximum-of-the-load-the-impulse-is-the-area-of-the-triangle-f-t-d-2 = Máximo da carga: o impulso é a área do triângulo, F₀t_d/2
maximum-of-the-load-the-impulse-is-the-area-of-the-versed-sine-half-that-of-its-rectangle = Máximo da carga: o impulso é a área do seno verso, metade da do seu retângulo
maximum-of-the-load-the-impulse-is-the-area-under-the-exponential-f = Máximo da carga: o impulso é a área sob a exponencial, F₀τ
maximum-of-the-load-the-impulse-is-the-area-under-the-parabola-a-a-2-a-3-of-its-rectangle = Máximo da carga: o impulso é a área sob a parábola, (a₀ + a₁/2 + a₂/3) do seu retângulo
maximum-torque = Torque máximo
maximum-torque-given = Torque máximo dado
maximum-torque-of-spring-and-damper-on-the-support-k-t-c-t-where-its-rate-is-zero = Torque máximo da mola e do amortecedor no apoio, k_t θ + c_t θ̇, onde a sua taxa é nula
maximum-torque-on-the-support = Torque máximo no apoio
moment-of-inertia-by-the-parallel-axis-theorem-that-about-the-centre-and-m-d = Momento de inércia pelo teorema dos eixos paralelos: o relativo ao centro, mais m d²
moment-of-inertia-of-a-rectangular-plate-about-the-normal-through-its-centre = Momento de inércia de uma placa retangular em relação à normal pelo seu centro
moment-of-inertia-of-a-slender-rod-about-its-centre = Momento de inércia de uma barra esbelta em relação ao seu centro
moment-of-inertia-of-a-solid-cylinder-about-a-diameter-through-its-centre = Momento de inércia de um cilindro maciço em relação a um diâmetro pelo seu centro
motion-of-the-body-from-rest = Movimento do corpo a partir do repouso
mounts-of-a-machine-for-instance = Os coxins de uma máquina, por exemplo.
omitted-for-an-axis-through-the-centre-of-mass-half-the-length-for-the-end-of-a-rod = Omitida para um eixo pelo centro de massa; metade do comprimento para a ponta de uma barra.
parabola-over-its-duration-then-zero = Parábola na sua duração, depois zero
periodic-force-torque-or-base = Força, torque ou base periódicos
phase-lag-of-the-body = Atraso de fase do corpo
plate-that-swings-about-its-corner = Placa que oscila em torno do seu canto
rectangular-plate-axis-normal-to-it = Placa retangular, eixo normal a ela
required-for-a-force-or-torque-not-required-for-base-excitation-if-the-natural-frequency-is-known = Exigida para uma força ou um torque; não exigida para excitação de base se a frequência natural for conhecida.
required-only-for-a-force-or-torque-on-it-or-if-the-stiffness-is-given-instead-of-a-frequency = Exigida somente para uma força ou um torque sobre ela, ou se a rigidez for dada em vez de uma frequência.
required-only-if-the-moment-of-inertia-is-given = Exigido somente se o momento de inércia for dado.
ring-that-swings-on-a-knife-edge = Anel que oscila num cutelo
rod-on-a-pivot-at-its-end-with-spring-and-damper = Barra articulada na ponta, com mola e amortecedor
rod-plate-sphere-cylinder = Barra, placa, esfera, cilindro
root-mean-square-of-the-angle = Valor eficaz do ângulo
rotation-of-the-base = Rotação da base
rotation-of-the-base-given = Rotação da base dada
rotor-after-an-angular-impulse = Rotor depois de um impulso angular
rotor-from-an-initial-rotation = Rotor a partir de uma rotação inicial
rotor-on-a-base-with-a-sawtooth-rotation = Rotor numa base com rotação em dente de serra
n-1-2-nr-1-n-r-2-nr-mean-square-2 = Θₙ = Φ/(nπ)√((1 + (2ζnr)²)/((1 − n²r²)² + (2ζnr)²)), valor quadrático médio (Φ/2)² + ½ΣΘₙ²
rotor-on-a-shaft-whose-end-is-suddenly-accelerated = Rotor num eixo cuja ponta é acelerada de repente
rotor-on-a-shaft-whose-other-end-oscillates = Rotor num eixo cuja outra ponta oscila
rotor-under-a-half-sine-torque = Rotor sob um torque em meia-onda senoidal
rotor-under-a-square-wave-of-torque = Rotor sob uma onda quadrada de torque
n-4t-n-k-t-1-n-r-2-nr-mean-square = Θₙ = 4T₀/(nπk_t)/√((1 − n²r²)² + (2ζnr)²), valor quadrático médio ½ΣΘₙ²
rotor-under-a-torque-from-a-table = Rotor sob um torque dado por tabela
rotor-under-a-triangular-torque-of-known-impulse = Rotor sob um torque triangular de impulso conhecido
slender-rod-axis-across-it = Barra esbelta, eixo transversal
solid-cylinder-axis-across-it = Cilindro maciço, eixo transversal
sphere-on-a-wire-by-frequency-and-decay = Esfera num fio, pela frequência e pelo decaimento
springs-dampers-and-forces-act-at-its-centre = Molas, amortecedores e forças atuam no seu centro.
static-angle = Ângulo estático
static-angle-under-the-maximum-torque = Ângulo estático sob o torque máximo
stiffness-from-the-static-deflection-k-st-m-g = Rigidez pela deflexão estática: k δ_st = m g
the-angular-impulse-instantaneously-gives-the-body-its-angular-momentum = O impulso angular dá instantaneamente ao corpo a sua quantidade de movimento angular
the-area-under-the-torque = A área sob o torque.
the-body-lags-the-base-by = Ângulo de fase (atraso) do corpo em relação à base
the-body-relative-to-the-base-rotates-as-under-the-torque-j-static-angle-under-its-maximum-value = O corpo relativo à base gira como sob o torque −J α: ângulo estático sob o seu valor máximo
the-force-and-the-spring-act-at-the-centre = A força e a mola atuam no centro.
the-motion-by-numerical-integration-of-its-equation-step-by-step = O movimento por integração numérica da sua equação, passo a passo
the-relative-angle-is-at-most-2-without-damping-and-the-body-itself-reaches-2 = Sem amortecimento o ângulo relativo é no máximo 2α₀/ωₙ², e o próprio corpo chega a 2α₀
the-springs-act-at-the-centre-of-the-cylinder = As molas atuam no centro do cilindro.
thin-ring-axis-normal-to-it = Anel fino, eixo normal a ele
time-from-its-start-to-the-peak = Tempo do seu início ao pico
torque-on-the-body = Torque sobre o corpo
torque-on-the-body-from-a-table = Torque sobre o corpo por tabela
torsional-stiffness-given = Rigidez torcional dada
two-masses-on-a-base-with-a-half-sine-shock = Duas massas numa base com choque em meia-onda senoidal
two-masses-on-a-base-with-a-triangular-shock = Duas massas numa base com choque triangular
two-masses-on-a-base-with-a-versed-sine-shock = Duas massas numa base com choque em seno verso
two-masses-under-a-half-sine-pulse = Duas massas sob um pulso de meia-onda senoidal
two-masses-under-a-triangle-and-a-versed-sine = Duas massas sob um triângulo e um seno verso
t-2i-t-d-the-motion-by-numerical-integration-of-its-equation-step-by-step = T₀ = 2I/t_d; o movimento por integração numérica da sua equação, passo a passo
versed-sine-pulse = Pulso em seno verso
weight-with-a-known-static-deflection-and-decay = Peso com deflexão estática e decaimento conhecidos
overdamped-with-a-velocity-that-carries-it-through-equilibrium = Superamortecido, com velocidade que o leva além do equilíbrio
n-1-x-c-e-t-c-e-t-from-x-and-v-and-its-derivatives = λ = −ζωₙ ± ωₙ√(ζ² − 1), x = C₁e^(λ₁t) + C₂e^(λ₂t) a partir de x₀ e v₀, e as suas derivadas
wheel-that-rolls-on-a-spring = Roda que rola presa a uma mola
a-torque-moves-a-moment-of-inertia-give-it-in-addition-to-the-natural-frequency = um torque move um momento de inércia: dê-o além da frequência natural
a-parabola-without-coefficients-is-no-load-write-at-least-one-of-them = uma parábola sem coeficientes não é carga: escreva ao menos um deles
a-sustained-load-has-no-finite-impulse-give-its-maximum-or-choose-a-pulse = uma carga mantida não tem impulso finito: dê o seu máximo, ou escolha um pulso
a-torque-moves-a-moment-of-inertia-write-it-or-choose-rotation-of-the-base = um torque move um momento de inércia: escreva-o, ou escolha a rotação da base
a-a-s-a-s-with-s-t-t-d-in-multiples-of-the-maximum-1-0-1-for-1-s-0-4-4-for-an-arch = a₀ + a₁s + a₂s² com s = t/t_d, em múltiplos do máximo: 1, 0, −1 para 1 − s²; 0, 4, −4 para um arco.
c-2-m-the-motion-by-numerical-integration-of-its-equation = c = 2ζmωₙ; o movimento por integração numérica da sua equação
equal-springs = molas iguais
equivalent-mass-by-the-moment-of-inertia-about-the-point-of-contact-j-c-r = massa equivalente pelo momento de inércia em relação ao ponto de contato, J_C/r²
static-angle-under-the-torque = ângulo estático sob o torque
m-eq-3m-2-2k-m-eq-c-2-k-m-eq-the-motion-by-numerical-integration-of-its-equation-with-the-envelope-x = m_eq = 3m/2, ωₙ = √(2k/m_eq), c = 2ζ√(k m_eq); o movimento por integração numérica da sua equação, com a envoltória x₀e^(−ζωₙt)/√(1 − ζ²)
relative-angle = ângulo relativo
the-area-under-this-parabola-is-not-positive-and-gives-no-maximum-for-an-impulse-give-the-maximum-or = a área sob esta parábola não é positiva, e não dá máximo para um impulso: dê o máximo, ou outros coeficientes
at-the-natural-frequency-stiffness-and-inertia-have-one-impedance-k-m = na frequência natural a rigidez e a inércia têm a mesma impedância, k/ωₙ = mωₙ
the-weight-of-a-rolling-body-does-not-deflect-its-springs-and-its-equivalent-mass-is-not-that-of-its = o peso de um corpo que rola não deflete as suas molas, e a sua massa equivalente não é a do seu peso: dê a rigidez das molas
torque-from-the-relative-motion = torque pelo movimento relativo
what-the-moment-of-inertia-adds-to-the-mass-of-a-rolling-body-depends-on-its-radius-write-the-radius = o que o momento de inércia acrescenta à massa de um corpo que rola depende do seu raio: escreva o raio
x-f-k-1-2-t-d-1-cos-t-t-t-d-until-t-d-then-free-the-maximum-by-numerical-integration = x = (F₀/k)((1 + 2/(ωₙt_d)²)(1 − cos ωₙt) − (t/t_d)²) até t_d, depois livre; o máximo por integração numérica
n-1-2-r-1-r-2-r-t-j-the-motion-from-rest-by-numerical-integration = Θ = Φ√((1 + (2ζr)²)/((1 − r²)² + (2ζr)²)), T = Jω²Θ; o movimento a partir do repouso por integração numérica
max-i-j-without-damping = θ_max = I/(Jωₙ) sem amortecimento
g-st-ln-4-3-4-c-2-m-the-motion-by-numerical-integration-of-its-equation = ωₙ = √(g/δ_st), δ = (ln 4)/3, ζ = δ/√(4π² + δ²), c = 2ζmωₙ; o movimento por integração numérica da sua equação
disc-on-a-wire-by-its-period-and-damping-ratio = Disco num fio, pelo período e pelo fator de amortecimento
rod-across-a-steel-shaft = Barra atravessada num eixo de aço
a-cushion-of-four-springs-its-damping-by-a-decay = Embalagem de quatro molas, com o amortecimento por um decaimento
the-springs-and-the-damping-of-the-cushion-before-20-kn-m-and-a-damping-ratio-of-0-2 = As molas e o amortecimento do caso anterior: 20 kN/m e um fator de amortecimento de 0,2.
white-acceleration-on-a-mount-known-by-its-free-vibration = Aceleração branca sobre um apoio conhecido pela sua vibração livre
numerical-integration-of-the-equation-of-motion = Integração numérica da equação de movimento
response-step-by-step-of-one-or-several-degrees-of-freedom-by-central-differences-newmark-wilson = Resposta passo a passo de um ou vários graus de liberdade por diferenças centrais, Newmark, Wilson, Houbolt ou Runge–Kutta, ao lado do movimento exato, com o passo de tempo crítico.
read-at-the-ends-of-the-time-steps-at-a-jump-the-value-of-the-larger-magnitude = Lidas nas extremidades dos passos de tempo; em um salto, vale o valor de maior módulo.
time-step = Passo de tempo
number-of-steps = Número de passos
central-differences = Diferenças centrais
newmark-average-acceleration = Newmark, aceleração média
the-acceleration-is-constant-within-a-step-1-2-1-4 = A aceleração é constante dentro de um passo: γ = 1/2, β = 1/4.
the-acceleration-is-linear-within-a-step-1-2-1-6 = A aceleração é linear dentro de um passo: γ = 1/2, β = 1/6.
newmark-linear-acceleration = Newmark, aceleração linear
newmark-with-and = Newmark com γ e β
gamma = Gama
beta = Beta
theta = Teta
wilson = Wilson-θ
houbolt = Houbolt
its-first-two-steps-are-central-differences = Os dois primeiros passos são por diferenças centrais.
fourth-order-runge-kutta = Runge–Kutta de quarta ordem
exact-for-a-piecewise-linear-load = Exato para carga linear por trechos
the-load-is-linear-between-the-ends-of-the-steps = A carga é linear entre as extremidades dos passos.
have-degrees-of-freedom-at-most-most-are-integrated-step-by-step = { $have } graus de liberdade: no máximo { $most } são integrados passo a passo
the-integration-is-unstable-the-motion-grows-beyond-all-numbers-take-a-shorter-time-step = a integração é instável: o movimento cresce além de qualquer número; use um passo de tempo menor
the-effective-stiffness-of-a-step-is-singular-take-another-time-step = a rigidez efetiva de um passo é singular: use outro passo de tempo
critical-time-step-of-central-differences-t = Passo de tempo crítico das diferenças centrais, T/π
critical-time-step-of-the-linear-acceleration-method-3-t = Passo de tempo crítico do método da aceleração linear, √3 T/π
critical-time-step-of-newmark-s-method-without-damping = Passo de tempo crítico do método de Newmark sem amortecimento
critical-time-step-of-the-fourth-order-runge-kutta-method-without-damping-2-t = Passo de tempo crítico do método de Runge–Kutta de quarta ordem sem amortecimento, √2 T/π
critical-time-step = Passo de tempo crítico
the-time-step-is-longer-than-the-critical-one-the-integration-is-unstable-and-its-results-are-no = o passo de tempo é maior que o crítico: a integração é instável e os resultados não são um movimento deste sistema
displacement-after-the-last-step = Deslocamento após o último passo
displacement-at-the-end = Deslocamento no fim
velocity-after-the-last-step = Velocidade após o último passo
velocity-at-the-end = Velocidade no fim
acceleration-after-the-last-step = Aceleração após o último passo
acceleration-at-the-end = Aceleração no fim
displacement-farthest-from-zero-at-the-end-of-a-step = Deslocamento mais distante de zero no fim de um passo
largest-displacement-of-all-steps = Maior deslocamento de todos os passos
exact-displacement-at-the-end-by-modal-superposition = Deslocamento exato no fim, por superposição modal
exact-displacement-at-the-end = Deslocamento exato no fim
error-of-the-integration-at-the-end = Erro da integração no fim
error-at-the-end = Erro no fim
displacement-after-each-step = Deslocamento após cada passo
velocity-after-each-step = Velocidade após cada passo
acceleration-after-each-step = Aceleração após cada passo
load-at = carga { $at }
displacement-at = deslocamento { $at }
velocity-at = velocidade { $at }
acceleration-at = aceleração { $at }
motion-step-by-step = Movimento passo a passo
coordinate-at-step-by-step = coordenada { $at }, passo a passo
coordinate-at-exact = coordenada { $at }, exata
the-first-step-worked-out-is-that-of-the-matrices = o primeiro passo resolvido é o das matrizes
stiffness-of-the-springs-side-by-side = Rigidez das molas lado a lado
damping-coefficient-from-the-damping-ratio = Coeficiente de amortecimento a partir do fator de amortecimento
load-at-the-start = Carga no início
load-after-one-step = Carga após um passo
initial-acceleration-from-the-equation-of-motion = Aceleração inicial, pela equação de movimento
displacement-one-step-before-the-start-by-taylor-s-formula = Deslocamento um passo antes do início, pela fórmula de Taylor
effective-stiffness-of-central-differences = Rigidez efetiva das diferenças centrais
factor-of-the-displacement-before = Fator do deslocamento anterior
factor-of-the-present-displacement = Fator do deslocamento atual
effective-load-of-the-first-step = Carga efetiva do primeiro passo
displacement-after-one-step = Deslocamento após um passo
parameter-gamma-of-the-method = Parâmetro gama do método
parameter-beta-of-the-method = Parâmetro beta do método
effective-stiffness-of-newmark-s-method = Rigidez efetiva do método de Newmark
acceleration-after-one-step = Aceleração após um passo
velocity-after-one-step = Velocidade após um passo
extended-time-step = Passo de tempo estendido
effective-stiffness-of-wilson-s-method = Rigidez efetiva do método de Wilson
load-at-the-end-of-the-extended-step = Carga no fim do passo estendido
displacement-at-the-end-of-the-extended-step = Deslocamento no fim do passo estendido
load-in-the-middle-of-the-step = Carga no meio do passo
velocity-of-the-second-evaluation = Velocidade da segunda avaliação
acceleration-of-the-second-evaluation = Aceleração da segunda avaliação
velocity-of-the-third-evaluation = Velocidade da terceira avaliação
acceleration-of-the-third-evaluation = Aceleração da terceira avaliação
velocity-of-the-fourth-evaluation = Velocidade da quarta avaliação
acceleration-of-the-fourth-evaluation = Aceleração da quarta avaliação
half-sine-pulse-average-acceleration = Pulso de meia-onda senoidal, aceleração média
half-sine-pulse-linear-acceleration = Pulso de meia-onda senoidal, aceleração linear
half-sine-pulse-central-differences = Pulso de meia-onda senoidal, diferenças centrais
half-sine-pulse-in-si-exact-between-the-points-of-the-load = Pulso de meia-onda senoidal no SI, exato entre os pontos da carga
half-sine-pulse-in-si-central-differences = Pulso de meia-onda senoidal no SI, diferenças centrais
two-degrees-of-freedom-under-a-step-newmark = Dois graus de liberdade sob um degrau, Newmark
exact-end-of-the-same-motion = Fim exato do mesmo movimento
one-newmark-step-with-1-12 = Um passo de Newmark com β = 1/12
one-wilson-step-with-2 = Um passo de Wilson com θ = 2
three-houbolt-steps = Três passos de Houbolt
one-runge-kutta-step-of-a-free-vibration = Um passo de Runge–Kutta de uma vibração livre
initial-displacement-as-none-is-given = Deslocamento inicial, pois nenhum é dado
initial-velocity-as-none-is-given = Velocidade inicial, pois nenhuma é dada

# random loads of beams, rotations of one degree of freedom
n-3-absolute-angular-acceleration = Aceleração angular absoluta 3σ
n-3-angle = Ângulo 3σ
n-3-relative-angle = Ângulo relativo 3σ
a-beam-on-one-pin-turns-freely = Uma viga sobre um só apoio gira livremente
a-solid-cylinder-that-rolls-has-the-equivalent-mass-3m-2-2k-3m-2-x-f-2k-3m-2-2-k = Um cilindro maciço que rola tem a massa equivalente 3m/2: ωₙ = √(2k/(3m/2)); X = F₀/√((2k − 3mω²/2)² + (2ηk)²)
a-torque-turns-a-body = Um torque gira um corpo
acceleration-of-the-supports = Aceleração dos apoios
angle-over-one-period = Ângulo ao longo de um período
angular-acceleration-of-the-base-by-a-table = Aceleração angular da base por uma tabela
angular-acceleration-of-the-base-in-a-band = Aceleração angular da base numa faixa
beam-on-a-pin-alone = Viga sobre um só apoio
beam-without-damping = Viga sem amortecimento
both-have-the-same-motion-the-responses-are-relative-to-it = Ambos têm o mesmo movimento; as respostas são relativas a ele.
cantilever-tube-on-an-accelerated-base-moment-at-the-clamp = Tubo em balanço sobre base vibrante, momento no engaste
cross-terms-what-every-two-modes-have-in-common-from-the-integral-of-h-h-s = Termos cruzados: o que cada dois modos têm em comum, da integral de H₁H₂*S
cubic-coefficient-given = Coeficiente cúbico dado
cubic-coefficient-of-a-pendulum-from-sin-6 = Coeficiente cúbico de um pêndulo, de sen θ ≈ θ − θ³/6
curvature-of-the-mode-shape-at-the-place-over-1-l = Curvatura da forma modal no ponto, dividida por 1/L²
damping-coefficient-per-unit-length = Coeficiente de amortecimento por unidade de comprimento
damping-ratio-of-the-mode-c-2m = Fator de amortecimento do modo: c̄/(2m̄ωₙ)
disc-on-a-hardening-torsional-spring-under-a-torque = Disco sobre uma mola torcional endurecedora sob um torque
disc-on-a-shaft-with-structural-damping = Disco num eixo com amortecimento estrutural
distance-from-the-pivot-to-the-centre-of-mass = Distância do pivô ao centro de massa
distributed-load-without-correlation-between-points = Carga distribuída sem correlação entre os pontos
double-sum-over-five-modes-with-re-h-h-d-2-4-4 = Soma dupla sobre cinco modos com ∫Re(H₁H₂*)dω = 2π(ζ₁ω₁ + ζ₂ω₂)/((ω₁² − ω₂²)² + 4ζ₁ζ₂ω₁ω₂(ω₁² + ω₂²) + 4(ζ₁² + ζ₂²)ω₁²ω₂²)
equivalent-viscous-damping-8a-t-3 = Amortecimento viscoso equivalente, 8a_tωΘ/(3π)
equivalent-viscous-damping-loss-factor-and-steady-state-amplitude-of-an-oscillator-moving-along-a = Amortecimento viscoso equivalente, fator de perda e amplitude em regime permanente de um oscilador, em translação ou em rotação, cujo amortecimento é dado pelo laço de histerese.
five-modes-of-120-hermite-elements-adaptive-quadrature-over-5-to-200-hz = Cinco modos de 120 elementos de Hermite, quadratura adaptativa de 5 a 200 Hz
five-modes-of-120-hermite-elements-adaptive-quadrature-over-5-to-300-hz = Cinco modos de 120 elementos de Hermite, quadratura adaptativa de 5 a 300 Hz
five-modes-of-120-hermite-elements-adaptive-quadrature-over-all-frequencies = Cinco modos de 120 elementos de Hermite, quadratura adaptativa em todas as frequências
for-a-rotation-about-its-pivot = Para uma rotação em torno do pivô.
for-a-rotation-under-the-weight-of-the-body = Para uma rotação sob o peso do corpo.
for-a-rotation-the-torque-of-the-spring-is-k-t-h-t = Para uma rotação: o torque da mola é k_t θ + h_t θ³.
force-on-the-mode-over-its-mass-for-a-load-of-one = Força sobre o modo dividida por sua massa, para uma carga unitária
force-or-torque = Força ou torque
forced-rotation-under-a-harmonic-torque-with-viscous-damping = Rotação forçada por um torque harmônico, com amortecimento viscoso
four-modes-of-120-hermite-elements-adaptive-quadrature-over-20-to-2000-hz = Quatro modos de 120 elementos de Hermite, quadratura adaptativa de 20 a 2000 Hz
free-rotation-released-from-rest = Rotação livre, solta do repouso
from-the-neutral-axis-for-the-bending-stress-omitted-half-the-depth-of-the-section = A partir da linha neutra, para a tensão de flexão. Omitida: metade da altura da seção.
hysteretic-loop-area-of-a-rotation-given = Histerético: área do laço de uma rotação dada
inertia-force-on-the-mode-over-its-mass-for-an-acceleration-of-one = Força de inércia sobre o modo dividida por sua massa, para uma aceleração unitária
loss-factor-at-this-frequency-the-damping-torque-k-t-over-the-elastic-one = Fator de perda nesta frequência: o torque de amortecimento βωk_tΘ dividido pelo elástico
loss-factor-the-area-of-the-loop-is-k-t = Fator de perda: a área do laço é πηk_tΘ²
mass-on-a-cantilever-that-deflects-by-2-4525-mm-under-it = Massa sobre uma viga em balanço que se deflete 2,4525 mm sob ela
maximum-amplitude-at-any-frequency-where-both-frequencies-of-an-amplitude-meet-h-t-k-t-c-t-4j-t-j-c-t = Amplitude máxima em qualquer frequência, onde as duas frequências de uma amplitude se encontram: ¾h_tΘ⁴ + (k_t − c_t²/4J)Θ² = T₀²J/c_t²
maximum-angle-with-the-third-harmonic = Ângulo máximo com o terceiro harmônico
maximum-angle-with-the-third-harmonic-also-balanced-by-newton-s-method = Ângulo máximo com o terceiro harmônico também balanceado, pelo método de Newton
mean-of-the-mode-shape-along-the-beam = Média da forma modal ao longo da viga
mean-square-of-the-mode-shape-along-the-beam-its-largest-deflection-one = Média quadrática da forma modal ao longo da viga, com deflexão máxima unitária
mode-shape-at-the-force = Forma modal no ponto da força
mode-shape-at-the-place-of-the-response = Forma modal no ponto da resposta
nearly-static-s-f-k-t = Quase estática: σ_θ = √(S Δf)/k_t
of-a-pendulum-sin-6 = De um pêndulo: sen θ ≈ θ − θ³/6
pendulum-released-at-60-with-the-cubic-term-of-its-weight = Pêndulo solto a 60°, com o termo cúbico de seu peso
place-of-the-response = Ponto da resposta
power-spectral-density-of-the-angular-acceleration = Densidade espectral de potência da aceleração angular
power-spectral-density-of-the-force-per-unit-length = Densidade espectral de potência da força por unidade de comprimento
power-spectral-density-of-the-load-per-unit-length = Densidade espectral de potência da carga por unidade de comprimento
power-spectral-density-of-the-response = Densidade espectral de potência da resposta
power-spectral-density-of-the-torque = Densidade espectral de potência do torque
rain-in-a-band-on-a-beam-with-elastic-and-guided-ends = Chuva numa faixa sobre uma viga com extremos elástico e guiado
rain-on-a-simply-supported-beam-with-viscous-damping = Chuva sobre uma viga biapoiada com amortecimento viscoso
rain-on-the-roof = Chuva no telhado.
random-load-on-a-beam = Carga aleatória numa viga
random-torque-with-only-a-natural-frequency = Torque aleatório com apenas uma frequência natural
resisting-torque-proportional-to-the-square-of-the-angular-velocity = Torque resistente proporcional ao quadrado da velocidade angular
response-beyond-the-end-of-the-beam = Resposta além do fim da viga
restoring-torque-of-the-weight-per-radian-of-a-small-angle = Torque restaurador do peso por radiano de um ângulo pequeno
roller-on-two-springs-in-parallel = Rolo sobre duas molas em paralelo
root-mean-square-of-displacement-velocity-bending-moment-and-bending-stress-at-a-point-of-a-beam = Valor eficaz do deslocamento, da velocidade, do momento fletor e da tensão de flexão num ponto de uma viga sob força aleatória, carga distribuída ou movimento dos apoios, por superposição modal.
root-mean-square-of-the-absolute-angular-acceleration = Valor eficaz da aceleração angular absoluta
root-mean-square-of-the-angle-relative-to-the-base = Valor eficaz do ângulo em relação à base
root-mean-square-of-the-angular-acceleration = Valor eficaz da aceleração angular
root-mean-square-of-the-angular-velocity = Valor eficaz da velocidade angular
root-mean-square-of-the-angular-velocity-relative-to-the-base = Valor eficaz da velocidade angular em relação à base
root-mean-square-of-the-bending-moment = Valor eficaz do momento fletor
root-mean-square-of-the-bending-moment-along-the-beam = Valor eficaz do momento fletor ao longo da viga
root-mean-square-of-the-bending-stress = Valor eficaz da tensão de flexão
root-mean-square-of-the-bending-stress-at-the-extreme-fibre = Valor eficaz da tensão de flexão na fibra extrema
root-mean-square-of-the-displacement-along-the-beam = Valor eficaz do deslocamento ao longo da viga
root-mean-square-of-the-modal-coordinate-under-white-noise-with-the-sign-of-the-load-on-the-mode = Valor eficaz da coordenada modal sob ruído branco, com o sinal da carga sobre o modo
root-mean-square-of-the-modal-coordinate-from-the-integral-of-h-s-with-the-sign-of-the-load-on-the = Valor eficaz da coordenada modal, da integral de |H|²S, com o sinal da carga sobre o modo
root-mean-square-of-the-modal-velocity-under-white-noise = Valor eficaz da velocidade modal sob ruído branco
root-mean-square-of-the-modal-velocity-from-the-integral-of-h-s = Valor eficaz da velocidade modal, da integral de ω²|H|²S
root-mean-square-of-the-relative-angle = Valor eficaz do ângulo relativo
root-mean-square-of-the-relative-angular-velocity = Valor eficaz da velocidade angular relativa
root-mean-square-of-the-torque-of-spring-and-damper-over-the-moment-of-inertia = Valor eficaz do torque de mola e amortecedor, dividido pelo momento de inércia
root-mean-square-of-the-torque-on-the-support = Valor eficaz do torque no apoio
root-of-the-balance-of-the-first-harmonic-stable-a-larger-amplitude-requires-a-larger-torque = Raiz do balanço do primeiro harmônico; estável: uma amplitude maior exige um torque maior
root-of-the-balance-of-the-first-harmonic-unstable-a-larger-amplitude-requires-a-smaller-torque-so-it = Raiz do balanço do primeiro harmônico; instável: uma amplitude maior exige um torque menor, de modo que ela salta
root-of-the-frequency-equation-of-the-beam-on-its-supports = Raiz da equação de frequências da viga sobre seus apoios
root-of-the-sum-of-the-squares-of-the-modes-each-alone = Raiz da soma dos quadrados dos modos, cada um isolado
roots-of-k-t-j-h-t-c-t-t-its-largest-amplitude = Raízes Θ² de ((k_t − Jω²) + ¾h_tΘ²)²Θ² + (c_tωΘ)² = T₀²; sua maior amplitude
shares-of-the-modes-bending-moment = Parcelas dos modos, momento fletor
shares-of-the-modes-displacement = Parcelas dos modos, deslocamento
six-modes-of-120-hermite-elements-adaptive-quadrature-over-10-to-800-hz = Seis modos de 120 elementos de Hermite, quadratura adaptativa de 10 a 800 Hz
specific-damping-capacity-that-energy-over-the-largest-elastic-energy-k-t-2 = Capacidade específica de amortecimento: essa energia dividida pela maior energia elástica k_tΘ²/2
stability-limit-of-a-softening-torque-beyond-it-the-body-does-not-return = Limite de estabilidade de um torque amolecedor: além dele o corpo não retorna
steady-state-amplitude-k-t-a-t-a-quadratic-equation-in = Amplitude em regime permanente: (K_t Θ)² + (A Θ²)² = T₀², uma equação quadrática em Θ²
suddenly-applied-load-on-a-cushion-known-by-its-free-vibration = Carga aplicada subitamente sobre uma embalagem conhecida por sua vibração livre
supports-under-white-acceleration = Apoios sob aceleração branca
t-4-dx-v-with-k-t-m-g-d-h-t-k-t-6-j-m-d-t-2-j-k-t-1-8-zero-torque-at-6-rad = T = 4∫dx/v com k_t = m g d, h_t = −k_t/6, J = m d²; T′ = 2π√(J/(k_t(1 − Θ²/8))); torque nulo em √6 rad
that-of-the-force-on-a-length-of-the-beam-over-this-length = A da força sobre um comprimento da viga, dividida por esse comprimento.
the-50-hz-mount-with-rad-s-for-g = O coxim de 50 Hz com rad/s² no lugar de g.
the-area-of-the-torque-angle-loop = A área do laço torque–ângulo.
the-beam-and-its-load = A viga e sua carga
the-drag-a-t-is-equivalent-to-a-viscous-damping-8a-t-3-which-dissipates-the-same-energy-per-cycle = O arrasto a_t Ω|Ω| equivale a um amortecimento viscoso 8a_tωΘ/(3π), que dissipa a mesma energia por ciclo
the-place-lies-on-the-beam = O ponto está sobre a viga
the-response-to-a-torque-needs-the-moment-of-inertia = A resposta a um torque requer o momento de inércia
the-same-at-every-point-of-the-beam-at-the-same-time = A mesma em todos os pontos da viga ao mesmo tempo.
the-same-cantilever-motion-of-its-tip = A mesma viga em balanço, movimento da ponta
the-variance-of-an-undamped-mode-under-white-noise-grows-with-time = A variância de um modo sem amortecimento sob ruído branco cresce com o tempo
torque-in-a-band-far-below-the-resonance = Torque numa faixa muito abaixo da ressonância
torque-of-spring-and-inertia-per-radian-of-amplitude = Torque de mola e inércia por radiano de amplitude
torque-over-the-square-of-the-angular-velocity = Torque sobre o quadrado da velocidade angular
torque-with-a-table-of-its-density = Torque com uma tabela de sua densidade
torque-angle-loop-over-one-cycle = Laço torque–ângulo ao longo de um ciclo
torsional-cubic-coefficient = Coeficiente cúbico torcional
torsional-cubic-coefficient-given = Coeficiente cúbico torcional dado
torsional-loop-of-0-6-j-at-0-1-rad = Laço torcional de 0,6 J a 0,1 rad
twenty-modes-have-all-but-0-002-of-the-mean-square = Vinte modos têm toda a média quadrática, menos 0,002 %.
uniform-load = Carga uniforme
uniform-load-in-a-band-between-two-clamps = Carga uniforme numa faixa entre dois engastes
uniform-load-with-a-table-of-its-density = Carga uniforme com uma tabela de sua densidade
uniform-white-load-first-mode = Carga branca uniforme, primeiro modo
vane-in-a-fluid-at-resonance = Palheta num fluido em ressonância
viscous-damping-along-the-beam = Amortecimento viscoso ao longo da viga
weight-of-a-pendulum = Peso de um pêndulo
white-angular-acceleration-of-the-base = Aceleração angular branca da base
white-force-at-midspan-first-mode = Força branca no meio do vão, primeiro modo
white-force-at-midspan-response-at-a-quarter-of-the-span = Força branca no meio do vão, resposta a um quarto do vão
white-torque-on-a-disc = Torque branco sobre um disco
a-place-lies-beyond-the-right-end-of-the-beam-write-a-distance-not-greater-than-its-length = um ponto está além do extremo direito da viga: escreva uma distância não maior que seu comprimento
a-torque-turns-a-body-give-its-moment-of-inertia-in-addition-to-the-natural-frequency = um torque gira um corpo: dê seu momento de inércia além da frequência natural
absolute-angular-acceleration-of-the-body = aceleração angular absoluta do corpo
at-that-angle-the-restoring-torque-is-zero = nesse ângulo o torque restaurador é nulo
at-the-jump-a-small-change-of-the-amplitude-needs-no-change-of-the-torque = no salto, uma pequena variação da amplitude não exige variação do torque
at-the-jump-the-torques-of-spring-inertia-and-damping-balance-the-applied-torque = no salto, os torques de mola, inércia e amortecimento equilibram o torque aplicado
at-this-angle-the-softening-torque-does-not-restore-choose-an-amplitude-below-k-t-h-t = neste ângulo o torque amolecedor não restaura: escolha uma amplitude abaixo de √(k_t/|h_t|)
bending-moment = momento fletor
bending-stress-by-the-root-mean-square-of-the-curvature-e-c = tensão de flexão pelo valor eficaz da curvatura, E c κ
density-of-the-bending-moment = densidade do momento fletor
density-of-the-displacement = densidade do deslocamento
mean-of-mode-shape-n-by-the-shear-forces-at-its-ends = média da forma modal { $n } pelas forças cortantes em seus extremos
no-natural-frequency-counted-is-inside-the-band-of-the-load-no-resonance-is-excited = nenhuma frequência natural considerada está na faixa da carga: nenhuma ressonância é excitada
no-steady-state-vibration-was-found-these-values-differ-too-much-in-magnitude-check-the-units-of-h-t = nenhuma vibração em regime permanente foi encontrada: estes valores diferem demais em grandeza; confira as unidades de h_t e T₀
response = resposta
root-mean-square-of-the-torque-k-t-ic-t-of-spring-and-damper-on-the-angle = valor eficaz do torque k_t + ic_tω de mola e amortecedor sobre o ângulo
sin-without-the-series-gives-2-1529-s-the-cubic-term-alone-is-0-4-from-it = sen θ sem a série dá 2,1529 s: só com o termo cúbico a diferença é de 0,4 %.
spring-inertia-and-damper-balance-the-torque = mola, inércia e amortecedor equilibram o torque
the-beam-can-move-as-a-rigid-body-and-a-random-load-moves-it-away-without-bound-add-supports = a viga pode mover-se como corpo rígido, e uma carga aleatória a afasta sem limite: acrescente apoios
the-beam-is-neither-deflected-nor-bent-at-this-place-choose-another-place = neste ponto a viga não se desloca nem se flexiona: escolha outro ponto
the-beam-is-so-slender-that-its-bending-cannot-be-resolved-count-fewer-modes = a viga é tão esbelta que sua flexão não pode ser resolvida: considere menos modos
the-frequencies-cannot-be-found-the-springs-at-the-ends-differ-too-much-from-the-stiffness-of-the = as frequências não podem ser encontradas: as molas nos extremos diferem demais da rigidez da viga
the-largest-amplitude-satisfies-the-balance-of-torques = a maior amplitude satisfaz o equilíbrio dos torques
the-last-modes-still-contribute-share-of-the-mean-square-bending-moment-count-more-modes = os últimos modos ainda contribuem com { $share } da média quadrática do momento fletor: considere mais modos
the-load-does-not-excite-these-modes-place-the-force-between-the-supports-or-count-more-modes = a carga não excita estes modos: coloque a força entre os apoios, ou considere mais modos
the-response-has-no-maximum-amplitude-at-a-frequency-above-zero-the-softening-torque-does-not-restore = a resposta não tem amplitude máxima numa frequência acima de zero: o torque amolecedor não restaura, ou o amortecimento é forte demais
the-torque-supplies-the-same-energy-t-sin = o torque fornece a mesma energia, πT₀Θ sen φ
torque-of-the-spring-over-the-moment-of-inertia-under-white-noise-by-integration-over-all-frequencies = torque da mola sobre o momento de inércia sob ruído branco, por integração em todas as frequências
torque-on-the-support-over-moment-of-inertia = torque no apoio sobre momento de inércia
torque-over-moment-of-inertia = torque sobre momento de inércia
torques-of-spring-and-inertia-are-balanced-by-the-torque-component-in-phase-with-the-motion = os torques de mola e inércia são equilibrados pela componente do torque em fase com o movimento
under-a-white-noise-torque-the-angular-acceleration-has-no-finite-mean-square-it-grows-with-the = sob um torque de ruído branco a aceleração angular não tem média quadrática finita: ela cresce com a largura da faixa
under-white-noise-with-viscous-damping-the-velocity-and-the-bending-moment-have-no-finite-mean-square = sob ruído branco com amortecimento viscoso, a velocidade e o momento fletor não têm média quadrática finita: crescem com o número de modos; dê um fator de amortecimento ou uma faixa
work-of-the-torque-in-a-cycle-work-of-the-damper-t-sin-c-t = trabalho do torque num ciclo = trabalho do amortecedor, πT₀Θ sen φ = πc_tωΘ²
what-by-the-integral-of-the-whole-response-over-the-frequency = { $what } pela integral da resposta total na frequência
n-3-t-8a-t-at-the-natural-frequency-c-eq-8a-t-3 = Θ = √(3πT₀/(8a_tω²)) na frequência natural; c_eq = 8a_tωΘ/(3π)
w-2-m-l-s-4-with-s-per-rad-s-m-ei-l-w-the-rate-is-the-natural-frequency = σ_w = 2/(m̄L) √(πS/(4ζω³)) com S por rad/s; σ_M = EI(π/L)² σ_w; a taxa é a frequência natural
w-4-m-s-4-with-s-per-rad-s-m-ei-l-w = σ_w = 4/(πm̄) √(πS/(4ζω³)) com S por rad/s; σ_M = EI(π/L)² σ_w
w-sl-96-c-ei-at-midspan-with-s-per-rad-s-every-mode-has-the-same-mean-energy-so-that-the-mean-square = σ_w² = πSL³/(96 c̄EI) no meio do vão com S por rad/s: todos os modos têm a mesma energia média, de modo que a média quadrática é a flexibilidade estática L³/(48EI) vezes πS/(2c̄)
s-2-k-t-c-t-with-s-per-rad-s-s-2-j-c-t = σ_θ² = π S/(2 k_t c_t) com S por rad/s; σ_Ω² = π S/(2 J c_t)
s-4-s-1-4-4-with-s-per-rad-s = σ_θ² = π S/(4ζωₙ³), σ_α² = π S ωₙ(1 + 4ζ²)/(4ζ) com S por rad/s
d-1-8-rad-s-with-0-6-y-max-1-e-1-with-g = ω_d = ωₙ√(1 − ζ²) = 8 rad/s com ζ = 0,6; y_max = δ(1 + e^(−ζπ/√(1 − ζ²))) com δ = g/ωₙ²
g-st-at-resonance-x-f-k = ωₙ² = g/δ_st; na ressonância X = F₀/(ηk)
tests-of-opensees-as-companion-to-chopra-dynamics-of-structures-4th-ed-example-5-3 = Testes do OpenSees, complemento a Chopra, Dynamics of Structures, 4ª ed., exemplo 5.3
tests-of-opensees-as-companion-to-chopra-dynamics-of-structures-4th-ed-example-5-4 = Testes do OpenSees, complemento a Chopra, Dynamics of Structures, 4ª ed., exemplo 5.4
tests-of-opensees-as-companion-to-chopra-dynamics-of-structures-4th-ed-example-5-2 = Testes do OpenSees, complemento a Chopra, Dynamics of Structures, 4ª ed., exemplo 5.2
package-structdyn-as-companion-to-chopra-dynamics-of-structures-5th-ed-example-5-1 = Pacote structdyn, complemento a Chopra, Dynamics of Structures, 5ª ed., exemplo 5.1
package-structdyn-as-companion-to-chopra-dynamics-of-structures-5th-ed-example-5-2 = Pacote structdyn, complemento a Chopra, Dynamics of Structures, 5ª ed., exemplo 5.2
test-of-a-public-program-as-companion-to-bathe-finite-element-procedures-example-9-4 = Teste de um programa público, complemento a Bathe, Finite Element Procedures, exemplo 9.4
bathe-example-9-7-x-a-5-3-1-cos-2-t-2-2-3-cos-5-t-1-at-t-3-36-s = Bathe, exemplo 9.7: x = A (5/√3 (1 − cos √2 t); 2√(2/3) (cos √5 t − 1)), em t = 3,36 s
from-x-1-with-1-and-t-1-a-2-s-1-5-a-2-5-x-3-5-v-7-10 = De x₀ = 1 com ω = 1 e Δt = 1: a(2 s) = 1/5, a₁ = −2/5, x₁ = 3/5, v₁ = −7/10
from-x-1-with-1-and-t-1-x-1-2-1-7-13-v-1-x-2-10-13 = De x₀ = 1 com ω = 1 e Δt = 1: x₁ = (1/2 + β)/(1 + β) = 7/13, v₁ = −(1 + x₁)/2 = −10/13
from-x-1-with-1-and-t-1-x-1-2-and-x-1-2-by-central-differences-3-x-5-x-4-x-x = De x₀ = 1 com ω = 1 e Δt = 1: x₁ = 1/2 e x₂ = −1/2 por diferenças centrais, 3 x₃ = 5 x₂ − 4 x₁ + x₀
t-with-t-1-s-which-the-mass-0-2533-gives-to-four-figures = T/π com T = 1 s, que a massa 0,2533 dá com quatro algarismos
the-numbers-of-the-book-in-kips-and-inches-stand-as-newtons-and-metres-here = Os números do livro, em kips e polegadas, estão aqui em newtons e metros.
the-book-rounds-every-step-to-four-decimals = o livro arredonda cada passo a quatro casas decimais
x-1-z-2-z-24-and-v-z-z-6-with-z-t-0-2-the-amplitude-does-not-grow-while-z-576-z-72-z-2-2 = x₁ = 1 − z²/2 + z⁴/24 e v₁ = −ω(z − z³/6) com z = ωΔt = 0,2; a amplitude não cresce enquanto z⁸/576 ≤ z⁶/72, z ≤ 2√2
without-displacement-or-velocity-there-is-no-motion-but-a-period-2-1 = Sem deslocamento nem velocidade não há movimento, mas há um período: 2π/(ωₙ√(1 − ζ²))
time-step-over-the-minimum-natural-period = Passo de tempo dividido pelo menor período natural
time-step-over-the-minimum-period = Passo de tempo sobre o menor período
displacement-at-at-the-end-by-another-form-of-the-method = deslocamento { $at } no fim por outra forma do método
velocity-at-at-the-end-by-another-form-of-the-method = velocidade { $at } no fim por outra forma do método
acceleration-at-at-the-end-by-another-form-of-the-method = aceleração { $at } no fim por outra forma do método
largest-displacement-at-by-another-form-of-the-method = maior deslocamento { $at } por outra forma do método
exact-displacement-at-at-the-end-by-taylor-series-step-by-step = deslocamento exato { $at } no fim por série de Taylor, passo a passo
error-at-from-the-other-form-of-the-method-and-the-taylor-series = erro { $at } pela outra forma do método e pela série de Taylor
rayleigh-s-bound-improved = Limite de Rayleigh, melhorado
inertia-force-of-the-disc-at-rayleigh-s-frequency = Força de inércia do disco na frequência de Rayleigh
deflection-at-the-disc-under-these-forces = Deflexão no disco sob essas forças
rayleigh-s-quotient-of-these-deflections-whose-bending-energy-is-the-work-of-the-forces = Quociente de Rayleigh dessas deflexões, cuja energia de flexão é o trabalho das forças
rayleigh-improved-the-second-step-of-matrix-iteration = Rayleigh, melhorado: o segundo passo da iteração matricial

# Statements of exercises.
the-suspension-of-a-vehicle-is-modelled-as-a-mass-on-a-spring-with-a-viscous-damper-in-a-frequency = A suspensão de um veículo é modelada como uma massa sobre uma mola com um amortecedor viscoso. Em uma varredura de frequência com força harmônica na massa, a receptância (amplitude do deslocamento sobre amplitude da força) tende a 2,0×10⁻⁴ m/N em baixa frequência e tem seu pico de 1,6×10⁻³ m/N em 12 rad/s. Determine a rigidez, o fator de amortecimento, a massa e o coeficiente de amortecimento. O pico não está na frequência natural.
a-fan-of-40-kg-stands-on-the-free-end-of-a-cantilever-1-2-m-long-with-e-200-kn-mm-and-a-second-moment = Um ventilador de 40 kg está na extremidade livre de uma viga engastada de 1,2 m de comprimento, com E = 200 kN/mm² e momento de inércia da seção de 1,3×10⁻⁶ m⁴, cuja massa é desprezada. O desbalanceamento do rotor (massa vezes excentricidade) é de 0,1 kg·m. O amortecimento é viscoso e pequeno; dele só se sabe que a amplitude em regime permanente não passa de 20,3 mm em nenhuma rotação, e alcança esse valor em uma delas. Determine o fator de amortecimento e a amplitude em regime permanente a 1000 rpm.
the-rotor-of-a-francis-turbine-has-a-mass-of-250-kg-and-an-unbalance-of-5-kg-mm-it-sits-on-the-free = O rotor de uma turbina Francis tem massa de 250 kg e desbalanceamento de 5 kg·mm. Ele está na extremidade livre de um eixo maciço de aço que trabalha como viga engastada de 2 m de comprimento (E = 207 GPa; a massa do eixo é desprezada). A folga radial entre rotor e estator é de 5 mm. A turbina opera entre 600 rpm e 6000 rpm, e mantém-se uma margem de 20 % abaixo e acima dessa faixa. O fator de amortecimento é de 30 %. Para quais diâmetros do eixo o rotor não toca o estator em nenhuma dessas rotações?
without-damping-a-turbine-rotor-of-250-kg-with-an-unbalance-of-5-kg-mm-runs-at-the-free-end-of-a = Sem amortecimento, um rotor de turbina de 250 kg com desbalanceamento de 5 kg·mm gira na extremidade livre de um eixo maciço que trabalha como viga engastada de 2 m de comprimento (E = 207 GPa, massa desprezada). Ele deve respeitar uma folga radial de 5 mm em todas as rotações entre 600 rpm e 6000 rpm, com margem de 20 % abaixo e acima. Determine o maior diâmetro do eixo que opera sempre acima de sua velocidade crítica e o menor diâmetro do que opera sempre abaixo dela.
a-mass-is-carried-by-a-cantilever-and-two-springs-the-cantilever-2-5-m-long-e-210-gpa-second-moment = Uma massa é sustentada por uma viga engastada e duas molas. A viga (2,5 m de comprimento, E = 210 GPa, momento de inércia da seção 1,5×10⁻⁵ m⁴) está em paralelo com uma mola de 5×10⁵ N/m; o conjunto está em série com uma mola de 2×10⁵ N/m. Livre, a massa amortecida vibra a 180 cpm (ciclos por minuto), e de 7 amplitudes sucessivas para o mesmo lado a primeira é 15 vezes a última. Determine a rigidez equivalente, a massa e o coeficiente de amortecimento viscoso. Depois, uma força harmônica de 200 N de amplitude e 22,7 rad/s atua na massa: determine a transmissibilidade.
the-reed-of-a-tachometer-is-a-steel-cantilever-50-mm-long-6-mm-wide-and-0-75-mm-thick-e-196-gpa-its = A lâmina de um tacômetro é uma viga engastada de aço com 50 mm de comprimento, 6 mm de largura e 0,75 mm de espessura (E = 196 GPa); sua massa é desprezada. Determine a massa na extremidade com a qual ela vibra a 1800 cpm (ciclos por minuto).
a-weight-of-35-lbf-hangs-on-a-spring-of-18-lbf-in-with-g-386-in-s-find-the-period-of-its-free = Um peso de 35 lbf pende de uma mola de 18 lbf/in. Com g = 386 in/s², determine o período de sua vibração livre.
a-solid-cylinder-of-1-5-kg-and-50-mm-radius-rolls-without-slipping-at-the-bottom-of-a-cylindrical = Um cilindro maciço de 1,5 kg e 50 mm de raio rola sem deslizar no fundo de uma calha cilíndrica de 300 mm de raio (g = 9,81 m/s²). Determine a frequência natural das pequenas oscilações em rad/s.
a-mass-of-4-kg-on-a-spring-of-1600-n-m-is-released-at-rest-10-mm-from-equilibrium-its-velocity-there = Uma massa de 4 kg sobre uma mola de 1600 N/m é solta em repouso a 10 mm do equilíbrio; sua velocidade ali é 0 m/s. Ela pode ultrapassar a posição de equilíbrio em 20 % dessa distância. Determine o fator de amortecimento e o coeficiente de amortecimento viscoso.
an-oscillator-has-a-natural-frequency-of-rad-s-and-a-damping-ratio-of-0-1-it-is-released-at-rest-at = Um oscilador tem frequência natural de π rad/s e fator de amortecimento 0,1. Ele é solto em repouso a 10 mm. Determine a frequência amortecida em hertz, o decremento logarítmico e a ultrapassagem em porcentagem.
a-machine-vibrates-freely-with-a-period-of-0-2025-s-and-a-logarithmic-decrement-of-0-314-find-its = Uma máquina vibra livremente com período de 0,2025 s e decremento logarítmico 0,314. Determine sua frequência natural não amortecida em rad/s e o tempo em que a amplitude cai à décima parte, isto é, por um fator de 10.
a-block-of-5-kg-on-a-horizontal-surface-is-held-by-a-spring-of-980-n-m-the-coefficient-of-dry = Um bloco de 5 kg em uma superfície horizontal está preso a uma mola de 980 N/m; o coeficiente de atrito seco é 0,025 (g = 9,81 m/s²). Ele é solto a 50 mm da posição livre da mola. Determine a frequência natural em rad/s, o número de ciclos inteiros depois dos quais a amplitude caiu a 25 mm, e o tempo que eles levam.
a-block-of-0-02590674-slinch-on-a-spring-of-30-lbf-in-is-pulled-1-in-from-the-free-position-of-the = Um bloco de 0,02590674 slinch sobre uma mola de 30 lbf/in é puxado 1 in da posição livre da mola e solto em repouso. A força de atrito seco é de 1,875 lbf. Determine a perda de amplitude em um ciclo, o número de ciclos até o bloco parar e o instante em que ele para, antes de 2 s.
the-body-of-a-car-weighs-3220-lbf-g-32-2-ft-s-and-has-a-radius-of-gyration-of-4-ft-about-its-mass = A carroceria de um automóvel pesa 3220 lbf (g = 32,2 ft/s²) e tem raio de giração de 4 ft em relação ao centro de massa. As molas dianteiras (2400 lbf/ft no total) estão 4,5 ft à frente dele, as traseiras (2600 lbf/ft no total) 5,5 ft atrás. Determine as duas frequências naturais em hertz.
a-slender-uniform-bar-of-10-kg-and-2-m-rests-level-on-two-springs-of-500-n-m-each-one-at-each-end-1-m = Uma barra delgada homogênea de 10 kg e 2 m apoia-se na horizontal sobre duas molas de 500 N/m cada uma, uma em cada extremidade, a 1 m do meio. Determine as duas frequências naturais de seu movimento no plano vertical em rad/s.
two-equal-slender-rods-of-3-kg-and-1-m-hang-one-below-the-other-on-smooth-hinges-with-g-10-m-s-find = Duas barras delgadas iguais de 3 kg e 1 m pendem uma abaixo da outra em articulações lisas. Com g = 10 m/s², determine as duas frequências naturais das pequenas oscilações em rad/s.
two-uniform-rods-turn-about-fixed-hinges-in-a-horizontal-plane-one-of-3-75-kg-and-0-75-m-the-other-of = Duas barras homogêneas giram em torno de articulações fixas em um plano horizontal: uma de 3,75 kg e 0,75 m, a outra de 5 kg e 1 m. Uma mola de 2940 N/m une as extremidades livres, a 0,75 m e 1 m das articulações. Determine a frequência natural não nula, em rad/s, e a razão dos ângulos (direita sobre esquerda) nesse modo.
a-connecting-rod-of-3-kg-hangs-on-a-knife-edge-0-5-m-from-its-centre-of-mass-it-makes-50-small = Uma biela de 3 kg pende de um cutelo a 0,5 m de seu centro de massa. Ela faz 50 pequenas oscilações em 85,70 s (g = 9,81 m/s²). Determine seu momento de inércia e seu raio de giração em relação ao centro de massa.
the-barrel-of-a-gun-has-a-mass-of-600-kg-and-recoils-by-1-3-m-against-a-spring-of-294-kn-m-without = O cano de um canhão tem massa de 600 kg e recua 1,3 m contra uma mola de 294 kN/m, sem amortecimento. Um amortecedor o traz de volta com amortecimento crítico. Determine a velocidade inicial do recuo, o coeficiente de amortecimento crítico e o tempo do disparo até o cano estar a 50 mm de sua posição inicial.
a-trailer-is-pulled-over-a-road-whose-profile-is-a-sine-of-80-mm-amplitude-and-14-m-wavelength-its = Um reboque é puxado por uma estrada cujo perfil é uma senoide de 80 mm de amplitude e 14 m de comprimento de onda. Suas molas deformam-se 100 mm sob o peso do reboque (g = 9,81 m/s²); o amortecimento é desprezado (fator 0). Determine a velocidade crítica e a amplitude do reboque a 60 km/h.
a-vehicle-of-1200-kg-on-springs-of-400-kn-m-in-all-has-a-damping-ratio-of-0-5-it-runs-at-20-km-h-on-a = Um veículo de 1200 kg sobre molas de 400 kN/m no total tem fator de amortecimento 0,5. Ele anda a 20 km/h em uma estrada senoidal de 0,05 m de amplitude e 6 m de comprimento de onda. Determine a razão de frequências e a amplitude do veículo.
an-engine-of-75-kg-with-an-unbalance-of-2-0-04-kg-m-runs-at-3000-rpm-on-mounts-of-1176000-n-m-in-all = Um motor de 75 kg com desbalanceamento de 2·0,04 kg·m gira a 3000 rpm sobre apoios de 1176000 N/m no total, com fator de amortecimento 0,2. Determine a amplitude da vibração em regime permanente e a amplitude da força transmitida ao piso.
an-exhaust-fan-of-380-kg-rests-on-undamped-springs-damping-ratio-0-that-deflect-by-45-mm-under-its = Um exaustor de 380 kg apoia-se em molas sem amortecimento (fator 0) que se deformam 45 mm sob seu peso de 380·9,81 N. O desbalanceamento do rotor é de 0,15 kg·m. A 1750 rpm, determine a amplitude do exaustor e a amplitude da força transmitida ao solo.
a-shaker-moves-a-mass-of-1-kg-on-a-spring-of-1000-n-m-with-a-damper-of-20-n-s-m-at-30-rad-s-and = Um excitador move uma massa de 1 kg sobre uma mola de 1000 N/m com um amortecedor de 20 N·s/m a 30 rad/s, gastando nisso a potência média de 90 W. Determine a amplitude da vibração em regime permanente e a amplitude da força.
a-radio-of-106-75-n-is-to-be-isolated-from-the-vibration-of-an-aircraft-between-1600-cpm-and-2200-cpm = Um rádio de 106,75 N deve ser isolado da vibração de um avião entre 1600 cpm e 2200 cpm (ciclos por minuto): em toda frequência dessa faixa, pelo menos 85 % dela. Os apoios não têm amortecimento (fator 0), e g = 9,81 m/s². Determine a deflexão estática dos apoios e sua rigidez total.
a-refrigeration-unit-of-65-lb-runs-at-580-rpm-on-3-equal-springs-without-damping-ratio-0-no-more-than = Uma unidade de refrigeração de 65 lb gira a 580 rpm sobre 3 molas iguais sem amortecimento (fator 0). Não mais que 10 % da força desbalanceada pode chegar ao apoio. Determine a rigidez de cada mola.
a-machine-of-1500-kg-stands-on-springs-of-4-5-mn-m-a-harmonic-force-of-200-n-acts-on-it-at-80-of-its = Uma máquina de 1500 kg está sobre molas de 4,5 MN/m. Uma força harmônica de 200 N atua nela a 80 % de sua frequência natural. Um absorvedor sem amortecimento deve manter a máquina em repouso com um curso de 10 mm. Determine a rigidez e a massa do absorvedor e as duas ressonâncias da máquina com ele, em rad/s.
a-vibrometer-with-a-natural-frequency-of-0-5-hz-and-no-damping-ratio-0-is-fixed-to-a-machine-that = Um vibrômetro com frequência natural de 0,5 Hz e sem amortecimento (fator 0) está fixo em uma máquina que vibra a 1 Hz. Ele indica um deslocamento relativo de 2,5 mm de amplitude. Determine a amplitude da máquina.
two-sine-motions-along-one-line-both-of-phase-0-are-added-1-90-cm-at-9-5-rad-s-and-2-00-cm-at-10-rad = Somam-se dois movimentos senoidais na mesma linha, ambos de fase 0°: 1,90 cm a 9,5 rad/s e 2,00 cm a 10 rad/s. Determine a maior e a menor amplitude da soma e a frequência de batimento em hertz.
a-harmonic-force-of-25-n-amplitude-and-10-hz-acts-on-a-body-whose-motion-has-an-amplitude-of-0-05-m = Uma força harmônica de 25 N de amplitude e 10 Hz atua em um corpo cujo movimento tem amplitude de 0,05 m na mesma frequência e está atrasado 30° em relação à força. Determine o trabalho da força em 1 s.
a-body-of-10-kg-on-a-spring-of-1-kn-m-vibrates-in-a-fluid-whose-drag-is-50-n-s-m-times-the-square-of = Um corpo de 10 kg sobre uma mola de 1 kN/m vibra em um fluido cujo arrasto é 50 N·s²/m² vezes o quadrado da velocidade. Uma força harmônica de 20 N atua a 10 rad/s. Com amortecimento viscoso equivalente, determine a amplitude, o coeficiente de amortecimento equivalente e a energia dissipada em um ciclo.
a-structure-is-to-have-proportional-rayleigh-damping-of-5-at-0-3-hz-and-of-2-at-1-2-hz-find-the = Uma estrutura deve ter amortecimento proporcional (de Rayleigh) de 5 % em 0,3 Hz e de 2 % em 1,2 Hz. Determine o coeficiente da matriz de massa, o coeficiente da matriz de rigidez e o fator de amortecimento que eles dão em 1 Hz.
a-mass-of-0-5-lbf-s-in-on-a-spring-of-200-lbf-in-without-damping-ratio-0-and-at-rest-receives-an = Uma massa de 0,5 lbf·s²/in sobre uma mola de 200 lbf/in, sem amortecimento (fator 0) e em repouso, recebe um impulso de 10 lbf·s. Determine seu deslocamento 0,08 s e 0,1 s depois.
a-mass-of-100-kg-rests-on-an-elastic-perfectly-plastic-spring-of-40-kn-m-that-yields-at-2-kn-a-blow = Uma massa de 100 kg está sobre uma mola elástica–perfeitamente plástica de 40 kN/m que escoa a 2 kN. Um golpe dá-lhe a velocidade de 4 m/s. Determine o maior deslocamento, o deslocamento permanente e a energia dissipada.
a-body-of-10-kg-is-set-on-an-undamped-cushion-ratio-0-of-1000-n-m-and-let-go-at-once-its-height-of = Um corpo de 10 kg é posto sobre um apoio elástico sem amortecimento (fator 0) de 1000 N/m e solto de repente: sua altura de queda é 0 m. Com g = 10 m/s², determine a maior deflexão do apoio e a maior força nele.
an-eccentric-moves-a-follower-of-0-8-kg-up-and-down-in-simple-harmonic-motion-of-10-mm-amplitude-at = Um excêntrico move um seguidor de 0,8 kg para cima e para baixo em movimento harmônico simples de 10 mm de amplitude a 960 rpm. Uma mola de 2500 N/m, comprimida de modo a empurrar com 40 N na posição média, mantém o seguidor sobre o came junto com seu peso (g = 9,81 m/s²). Determine a frequência em hertz em que se perde o contato e a menor e a maior força de contato na rotação dada.
a-body-of-450-n-g-9-81-m-s-is-fixed-to-the-free-end-of-a-cantilever-shaft-of-100-mm-diameter-and-1-1 = Um corpo de 450 N (g = 9,81 m/s²) está fixo na extremidade livre de um eixo engastado de 100 mm de diâmetro e 1,1 m de comprimento, com E = 200 GPa. A massa do eixo é desprezada. Determine as frequências naturais da vibração longitudinal e da transversal em hertz.
a-body-of-100-kg-sits-on-a-solid-shaft-of-60-mm-diameter-between-two-bearings-that-leave-its-ends = Um corpo de 100 kg está em um eixo maciço de 60 mm de diâmetro entre dois mancais que deixam as extremidades girar livremente, a 0,6 m do esquerdo e 0,3 m do direito (E = 200 GPa, massa do eixo desprezada). Determine a frequência natural da vibração transversal em hertz.
two-particles-are-fixed-to-a-light-string-stretched-with-1-n-between-two-walls-2-kg-at-1-m-from-the = Duas partículas estão fixas em uma corda leve esticada com 1 N entre duas paredes: 2 kg a 1 m da parede esquerda, e 1 kg a 1 m da primeira; dela à parede direita há novamente 1 m. Determine as duas frequências naturais das pequenas vibrações transversais em rad/s.
a-disc-of-10-kg-with-a-radius-of-gyration-of-120-mm-about-its-axis-and-a-width-of-60-mm-is-fixed-to = Um disco de 10 kg com raio de giração de 120 mm em torno do eixo e largura de 60 mm está fixo na ponta de um eixo em balanço. O eixo trabalha como viga engastada de 0,3 m com E = 196 GPa e momento de inércia da seção de 1×10⁻⁷ m⁴; sua massa é desprezada. A máquina deve girar a 10000 rpm. Determine as duas frequências naturais do disco parado, em rpm.
a-turbine-disc-of-20-kg-sits-in-the-middle-of-a-light-solid-steel-shaft-of-2-5-cm-diameter-and-1-m = O disco de uma turbina, de 20 kg, está no meio de um eixo leve e maciço de aço de 2,5 cm de diâmetro e 1 m de comprimento entre dois mancais que deixam as extremidades girar livremente (E = 207 GPa). Seu centro de massa está a 5 mm do eixo, e o fator de amortecimento é 0,01. O eixo é horizontal (g = 9,81 m/s²) e gira a 6000 rpm. Determine a velocidade crítica em rpm e a amplitude da precessão.
a-guitar-string-of-steel-7920-kg-m-has-a-cross-section-of-5-0671-10-m-and-is-stretched-with-84-n-over = Uma corda de violão de aço (7920 kg/m³) tem seção transversal de 5,0671×10⁻⁸ m² e está esticada com 84 N em um comprimento de 0,71 m. Determine a frequência fundamental, em hertz.
a-solid-round-shaft-of-50-mm-diameter-and-1-m-length-is-pinned-at-both-ends-e-200-gpa-and-the-density = Um eixo redondo maciço de 50 mm de diâmetro e 1 m de comprimento é biapoiado; E = 200 GPa e a massa específica é de 8000 kg/m³. Determine a menor frequência natural de flexão (1 modo) pela teoria de Euler–Bernoulli, em hertz.
the-skin-of-a-circular-drum-of-200-mm-radius-has-a-mass-of-0-1-kg-m-and-is-stretched-with-1-kn-m-all = A pele de um tambor circular de 200 mm de raio tem massa de 0,1 kg/m² e está esticada com 1 kN/m em toda a volta. Determine a frequência fundamental, em hertz.
a-steel-rod-of-1-m-and-1-cm-moves-lengthwise-at-1-m-s-and-hits-a-rigid-wall-with-its-whole-end-face-e = Uma barra de aço de 1 m e 1 cm² move-se na direção do comprimento a 1 m/s e atinge uma parede rígida com toda a face. E = 200 GPa, a massa específica é de 8000 kg/m³ e a resistência de 250 MPa. Determine a tensão atrás da frente de onda, o maior encurtamento e o tempo de contato.
an-instrument-on-a-mount-with-a-natural-frequency-of-50-hz-and-a-damping-ratio-of-0-05-is-shaken-at = Um instrumento em um apoio com frequência natural de 50 Hz e fator de amortecimento 0,05 é agitado em sua base por ruído branco; a densidade espectral da aceleração é de 0,04 g0²/Hz em todas as frequências. Determine o valor eficaz de sua aceleração e de seu deslocamento em relação à base.
a-light-shaft-of-1-m-with-a-cross-section-of-4-9087385-10-m-and-a-second-moment-of-area-of-2-10-m-e = Um eixo leve de 1 m, com seção transversal de 4,9087385×10⁻⁴ m² e momento de inércia da seção de 2×10⁻⁸ m⁴ (E = 200 GPa), é biapoiado. Um disco de 10 kg, considerado partícula, está a 0,5 m da extremidade esquerda. Determine a velocidade crítica em rad/s, exatamente e pela fórmula de Dunkerley.

# Common errors.
the-formula-for-light-damping-1-2-used = usada a fórmula de amortecimento leve, ζ = 1/(2Λ)
n-1-2-assumed = ζ = 1/√2 adotado
the-frequency-of-the-force-used-as-the-natural-frequency = a frequência da força usada como frequência natural
n-2-times-the-damping-ratio-taken-as-for-light-damping = tomado 2π vezes o fator de amortecimento, como para amortecimento leve
a-quarter-of-a-period-taken = tomado um quarto de período
all-masses-taken-together-on-the-first-spring = todas as massas tomadas juntas sobre a primeira mola
all-masses-taken-together-on-the-springs-in-series = todas as massas tomadas juntas sobre as molas em série
all-springs-combined-as-if-in-parallel = todas as molas combinadas como se estivessem em paralelo
all-springs-combined-as-if-in-series = todas as molas combinadas como se estivessem em série
both-arms-taken-as-half-the-distance-between-the-springs = ambos os braços tomados como metade da distância entre as molas
each-mass-taken-alone-on-its-own-spring = cada massa tomada isolada sobre a sua própria mola
each-spring-taken-alone-with-the-mass-that-it-carries-at-rest = cada mola tomada isolada com a massa que sustenta em repouso
the-radius-of-gyration-taken-as-the-radius-of-a-solid-disc = raio de giração tomado como o raio de um disco maciço
only-the-first-and-the-last-amplitude-used = usadas apenas a primeira e a última amplitude
the-added-inertia-included-in-the-result = inércia adicionada incluída no resultado
the-amplitude-assumed-to-decay-to-zero-without-a-sticking-zone = amplitude suposta cair até zero, sem zona de aderência
the-amplitude-without-friction-taken = tomada a amplitude sem atrito
the-angle-of-the-body-taken-as-that-of-its-centre-about-the-centre-of-the-surface = ângulo do corpo tomado como o do seu centro em torno do centro da superfície
the-body-taken-as-a-pendulum-of-the-length-of-the-wires = corpo tomado como um pêndulo do comprimento dos fios
the-body-taken-as-a-point-mass-at-its-centre = corpo tomado como massa pontual no seu centro
the-body-taken-as-a-simple-pendulum-of-the-equivalent-length = corpo tomado como pêndulo simples do comprimento equivalente
the-cosine-of-the-inclination-not-squared = cosseno da inclinação não elevado ao quadrado
the-cylinder-taken-as-a-slender-rod = cilindro tomado como barra esbelta
the-damping-neglected = amortecimento desprezado
the-damping-ratio-of-the-viscous-fit-alone-used = usado o fator de amortecimento do ajuste apenas viscoso
the-decrement-divided-by-2-as-for-light-damping = decremento dividido por 2π, como para amortecimento leve
the-decrement-over-all-cycles-taken-as-that-of-one-cycle = decremento de todos os ciclos tomado como o de um só
the-decrement-used-in-place-of-the-damping-ratio = usado o decremento em vez do fator de amortecimento
the-deflection-under-a-uniformly-distributed-load-used = usada a flecha sob uma carga uniformemente distribuída
the-distance-divided-in-proportion-to-the-equivalent-lengths = distância dividida na proporção dos comprimentos equivalentes
the-elastic-centre-of-the-springs-taken-as-the-node = centro elástico das molas tomado como o nó
the-envelope-assumed-to-start-at-the-initial-displacement = suposta a envoltória começando no deslocamento inicial
the-equilibrium-position-shifted-to-the-wrong-side = posição de equilíbrio deslocada para o lado errado
the-exponential-not-differentiated = exponencial não derivada
the-far-end-of-the-beam-taken-as-clamped = extremidade oposta da viga tomada como engastada
the-far-end-of-the-beam-taken-as-pinned = extremidade oposta da viga tomada como apoiada
the-force-divided-by-the-imaginary-part-of-the-displacement = força dividida pela parte imaginária do deslocamento
the-force-divided-by-the-real-part-of-the-displacement = força dividida pela parte real do deslocamento
the-force-of-the-springs-alone-taken = tomada apenas a força das molas
the-forces-of-spring-and-damper-added-as-if-in-phase = forças da mola e do amortecedor somadas como se estivessem em fase
the-formula-in-terms-of-the-coil-radius-used-with-the-diameter = fórmula em termos do raio da espira usada com o diâmetro
the-formula-for-the-overshoot-after-half-a-cycle-used-for-a-whole-cycle = usada para um ciclo inteiro a fórmula do sobressinal após meio ciclo
the-formula-of-a-thin-walled-tube-used = usada a fórmula de um tubo de parede fina
the-fourth-power-of-the-difference-of-the-diameters-taken = tomada a quarta potência da diferença dos diâmetros
the-frequency-of-the-decaying-motion-taken-as-the-natural-frequency = frequência do movimento em decaimento tomada como a frequência natural
the-frequency-of-the-resonance-peak-taken-1-2 = tomada a frequência do pico de ressonância, ωₙ√(1 − 2ζ²)
the-friction-force-divided-by-the-largest-velocity = força de atrito dividida pela maior velocidade
the-friction-loss-of-a-half-cycle-used-for-a-whole-cycle = usada para um ciclo inteiro a perda por atrito de meio ciclo
the-friction-loss-of-a-whole-cycle-used-for-a-half-cycle = usada para meio ciclo a perda por atrito de um ciclo inteiro
the-friction-neglected = atrito desprezado
the-friction-neglected-beside-the-viscous-damping = atrito desprezado ao lado do amortecimento viscoso
the-radius-of-the-surface-taken-as-that-of-the-path-of-the-centre = raio da superfície tomado como o da trajetória do centro
the-rotation-of-the-body-taken-relative-to-the-line-of-centres-not-to-the-ground = rotação do corpo tomada em relação à linha de centros, não ao solo
the-kinetic-energy-of-the-rotation-neglected = energia cinética da rotação desprezada
the-leaves-taken-as-one-solid-beam-of-their-whole-thickness = lâminas tomadas como uma só viga maciça da espessura total
the-leaves-taken-as-uniform-beams-all-of-the-whole-span = lâminas tomadas como vigas uniformes, todas do vão inteiro
the-length-of-the-inclined-wires-taken-as-the-vertical-distance = comprimento dos fios inclinados tomado como a distância vertical
the-level-taken-to-change-on-one-side-only = suposta a variação do nível em um só lado
the-logarithm-of-the-overshoot-divided-by-as-for-light-damping = logaritmo do sobressinal dividido por π, como para amortecimento leve
the-logarithm-to-base-10-used-in-place-of-the-natural-one = usado o logaritmo de base 10 em vez do natural
the-loss-of-amplitude-taken-for-that-of-energy = perda de amplitude tomada como perda de energia
the-loss-of-the-first-cycle-assumed-in-every-cycle = suposta em todos os ciclos a perda do primeiro
the-magnification-taken-for-the-transmissibility = fator de amplificação tomado como a transmissibilidade
the-masses-of-the-springs-neglected = massas das molas desprezadas
the-mean-diameter-of-the-coils-taken-as-the-outer-one = diâmetro médio das espiras tomado como o externo
the-mean-diameter-used-as-for-a-uniform-bar = usado o diâmetro médio, como em uma barra uniforme
the-mean-diameter-used-as-for-a-uniform-shaft = usado o diâmetro médio, como em um eixo uniforme
the-mean-of-the-two-end-areas-used-as-for-a-uniform-bar = usada a média das áreas das duas extremidades, como em uma barra uniforme
the-mean-of-the-two-end-polar-moments-of-area-used-as-for-a-uniform-shaft = usada a média dos momentos polares de inércia das duas extremidades, como em um eixo uniforme
the-mean-velocity-divided-by-the-time = velocidade média dividida pelo tempo
the-midspan-formula-used-for-a-load-that-is-elsewhere = usada a fórmula do meio do vão para uma carga em outro ponto
the-moment-of-inertia-about-a-corner-of-the-plate-taken = tomado o momento de inércia em torno de um vértice da placa
the-moment-of-inertia-about-a-diameter-of-the-disc-taken = tomado o momento de inércia em torno de um diâmetro do disco
the-moment-of-inertia-about-the-axis-of-the-cylinder-taken = tomado o momento de inércia em torno do eixo do cilindro
the-moment-of-inertia-about-the-centre-used-for-a-rolling-body = usado o momento de inércia em torno do centro para um corpo que rola
the-moment-of-inertia-about-the-end-of-the-cylinder-taken = tomado o momento de inércia em torno da extremidade do cilindro
the-moment-of-inertia-about-the-end-of-the-rod-taken = tomado o momento de inércia em torno da extremidade da barra
the-moment-of-inertia-about-the-first-point-taken = tomado o momento de inércia em torno do primeiro ponto
the-moment-of-inertia-about-the-point-of-contact-taken = tomado o momento de inércia em torno do ponto de contato
the-moment-of-inertia-of-a-disc-taken-for-the-sphere = tomado para a esfera o momento de inércia de um disco
the-moment-of-inertia-of-a-hollow-sphere-taken-for-the-solid-one = tomado para a esfera maciça o momento de inércia de uma esfera oca
the-moment-of-inertia-of-a-ring-taken-for-the-solid-disc = tomado para o disco maciço o momento de inércia de um anel
the-moment-of-inertia-of-a-solid-disc-taken-for-the-ring = tomado para o anel o momento de inércia de um disco maciço
the-moment-of-inertia-of-the-shaft-neglected = momento de inércia do eixo desprezado
the-moment-of-the-weights-neglected = momento dos pesos desprezado
the-motion-assumed-to-start-at-its-maximum-without-a-phase-angle = suposto o movimento começando no máximo, sem ângulo de fase
the-natural-frequency-used-in-place-of-the-damped-one = usada a frequência natural em vez da amortecida
the-number-of-half-cycles-not-rounded-up = número de meios ciclos não arredondado para cima
the-number-of-half-cycles-rounded-down = número de meios ciclos arredondado para baixo
f-k-of-the-fit-with-friction-alone-used = usado F/k do ajuste apenas com atrito
the-overhang-taken-as-a-cantilever-clamped-at-its-support = balanço tomado como viga engastada no seu apoio
the-overshoot-taken-as-the-amplitude-after-a-whole-cycle = sobressinal tomado como a amplitude após um ciclo inteiro
the-parallel-axis-term-added-to-the-moment-of-inertia-about-the-end = termo dos eixos paralelos somado ao momento de inércia em torno da extremidade
the-parallel-axis-term-omitted = termo dos eixos paralelos omitido
the-period-without-damping-used = usado o período sem amortecimento
the-periods-used-in-place-of-their-squares = usados os períodos em vez dos seus quadrados
the-pinned-end-taken-as-free = extremidade apoiada tomada como livre
the-polar-second-moment-of-area-of-the-wire-used-for-its-bending = usado o momento polar de inércia do arame para a sua flexão
the-polar-second-moment-of-area-used-for-bending = usado o momento polar de inércia para a flexão
the-radius-of-gyration-about-the-point-of-contact-taken = tomado o raio de giração em torno do ponto de contato
the-rate-of-decay-of-an-underdamped-motion-used = usada a taxa de decaimento ζωₙ de um movimento subamortecido
the-translation-added-to-the-rotation-about-the-point-of-contact = translação somada à rotação em torno do ponto de contato
the-rotation-of-the-far-end-used = usada a rotação da extremidade oposta
the-rotation-of-the-tip-under-a-force-used-in-place-of-that-under-a-moment = usada a rotação da ponta sob uma força em vez daquela sob um momento
the-rule-of-thumb-for-the-settling-time-used-4 = usada a regra prática do tempo de acomodação, 4/(ζωₙ)
the-second-moment-of-area-about-the-edge-taken-b-h-3 = tomado o momento de inércia de área em torno da borda, b h³/3
the-second-moment-of-area-for-bending-used-in-torsion = usado na torção o momento de inércia de área da flexão
the-second-period-taken-as-that-of-the-added-inertia-alone = segundo período tomado como o da inércia adicionada sozinha
the-springs-combined-as-if-in-parallel = molas combinadas como se estivessem em paralelo
the-springs-combined-as-if-in-series = molas combinadas como se estivessem em série
the-square-of-the-difference-of-the-diameters-taken = tomado o quadrado da diferença dos diâmetros
the-static-deflection-under-the-force-taken = tomada a deflexão estática sob a força
the-static-friction-used-in-place-of-the-kinetic-one = usado o atrito estático em vez do cinético
the-static-rotation-under-the-load-taken = tomada a rotação estática sob a carga
the-stiffness-against-a-force-at-the-tip-used-times-the-length-squared = usada a rigidez a uma força na ponta, vezes o quadrado do comprimento
the-stiffness-reflected-to-the-wrong-side-by-the-inverse-ratio = rigidez refletida para o lado errado, pela relação inversa
the-tension-divided-by-the-whole-length = força de tração dividida pelo comprimento total
the-wall-thickness-times-the-outer-circumference-taken = tomada a espessura da parede vezes a circunferência externa
the-weight-of-the-body-alone-taken-with-both-periods = tomado apenas o peso do corpo com ambos os períodos
the-weight-of-the-platform-omitted = peso da plataforma omitido
the-whole-beam-taken-as-a-cantilever = viga inteira tomada como em balanço
the-whole-mass-of-the-spring-taken = tomada a massa inteira da mola
the-whole-moment-of-inertia-of-the-shaft-taken = tomado o momento de inércia inteiro do eixo
the-wires-taken-as-vertical-with-the-radius-at-the-body = fios tomados como verticais, com o raio no corpo
twice-the-decrement-taken-as-for-light-damping = tomado o dobro do decremento, como para amortecimento leve
a-constant-deceleration-over-the-deflection-assumed = suposta desaceleração constante ao longo da deflexão
a-harmonic-motion-of-this-amplitude-and-period-assumed = suposto movimento harmônico com esta amplitude e este período
a-harmonic-motion-with-the-exact-period-assumed = suposto movimento harmônico com o período exato
a-quarter-of-the-undamped-natural-period-taken = tomado um quarto do período natural não amortecido
both-masses-assumed-to-follow-the-road = suposto que as duas massas acompanham a estrada
both-stiffnesses-added-beyond-the-breakpoint = somadas as duas rigidezes além do ponto de mudança
force-and-displacement-at-that-time-multiplied = multiplicados a força e o deslocamento nesse instante
half-of-the-undamped-natural-period-taken = tomada a metade do período natural não amortecido
inertia-times-acceleration-taken-as-the-load-on-the-foundation = inércia vezes aceleração tomada como o esforço sobre a fundação
the-absolute-motion-taken-as-the-deformation-of-spring-and-damper = movimento absoluto tomado como a deformação da mola e do amortecedor
the-amplitude-at-resonance-of-the-linear-oscillator-taken = tomada a amplitude na ressonância do oscilador linear
the-amplitude-at-the-natural-frequency-taken-as-the-maximum = amplitude na frequência natural tomada como a máxima
the-amplitude-far-above-the-resonance-m-e-m-taken = tomada a amplitude muito acima da ressonância, m₀e/m
the-amplitude-of-the-force-multiplied-by-the-displacement-at-that-time = amplitude da força multiplicada pelo deslocamento nesse instante
the-amplitude-of-the-force-multiplied-by-the-distance-travelled-in-a-cycle-4x = amplitude da força multiplicada pela distância percorrida em um ciclo, 4X
the-amplitude-of-the-relative-motion-used = usada a amplitude do movimento relativo
the-amplitude-ratio-mx-m-e-used-as-the-transmissibility = razão de amplitudes mX/(m₀e) usada como transmissibilidade
the-amplitudes-added-without-their-phases = somadas as amplitudes sem levar em conta as fases
the-amplitudes-combined-as-perpendicular-components = amplitudes compostas como componentes perpendiculares
the-amplitudes-of-base-and-relative-motion-added-without-their-phases = somadas as amplitudes da base e do movimento relativo sem levar em conta as fases
the-amplitudes-of-excitation-and-velocity-multiplied-without-the-phase-between-them = multiplicadas as amplitudes da excitação e da velocidade sem a fase entre elas
the-amplitudes-of-force-and-velocity-multiplied = multiplicadas as amplitudes da força e da velocidade
the-amplitudes-of-the-first-few-harmonics-added-without-their-phases = somadas as amplitudes dos primeiros harmônicos sem levar em conta as fases
the-arithmetic-mean-of-the-half-power-frequencies-taken = tomada a média aritmética das frequências de meia potência
the-centrifugal-force-of-the-unbalance-taken-as-a-static-load = força centrífuga do desbalanceamento tomada como carga estática
the-centrifugal-force-taken-as-the-force-transmitted = força centrífuga tomada como a força transmitida
the-compression-of-the-spring-by-the-motion-omitted = esquecida a compressão da mola pelo movimento
the-contact-force-at-the-lowest-position-taken-as-the-mean = força de contato na posição mais baixa tomada como a média
the-cubic-term-omitted = esquecido o termo cúbico
the-damped-natural-frequency-taken-as-that-of-the-peak = frequência natural amortecida tomada como a do pico
the-damped-natural-frequency-used = usada a frequência natural amortecida
the-damped-natural-frequency-used-in-the-damping-coefficient = usada a frequência natural amortecida no coeficiente de amortecimento
the-damped-natural-frequency-used-in-the-frequency-ratio = usada a frequência natural amortecida na razão de frequências
the-damper-alone-assumed-to-balance-the-excitation-as-at-resonance = suposto que só o amortecedor equilibra a excitação, como na ressonância
the-damper-omitted-the-spring-alone-at-its-maximum-deflection = esquecido o amortecedor: tomada só a mola na sua deflexão máxima
the-damper-omitted-the-spring-alone-taken = esquecido o amortecedor: tomada só a mola
the-damping-neglected-at-the-other-frequency = desprezado o amortecimento na outra frequência
the-damping-omitted = esquecido o amortecimento
the-dashpot-assumed-to-act-in-the-recoil-too = suposto que o amortecedor age também no recuo
the-difference-of-the-two-periods-taken = tomada a diferença dos dois períodos
the-difference-taken-relative-to-the-small-angle-period = diferença tomada em relação ao período de pequenos ângulos
the-drag-linearized-at-the-largest-velocity-of-the-cycle = arrasto linearizado na maior velocidade do ciclo
the-drag-linearized-at-the-mean-velocity-of-the-cycle = arrasto linearizado na velocidade média do ciclo
the-elastic-energy-of-the-spring-omitted-from-the-energy-balance = esquecida a energia elástica da mola no balanço de energia
the-elastic-energy-of-the-spring-taken-as-kr = energia elástica da mola tomada como kR²
the-elastic-energy-of-the-spring-taken-as-the-energy-lost = energia elástica da mola tomada como a energia perdida
the-energy-lost-in-the-impact-with-the-pan-ignored = ignorada a energia perdida no impacto com o prato
the-energy-measured-at-another-amplitude-used-with-the-amplitude-of-this-motion = energia medida em outra amplitude usada com a amplitude deste movimento
the-envelope-of-the-growing-motion-taken-as-the-displacement = envoltória do movimento crescente tomada como o deslocamento
the-equivalent-damping-force-subtracted-from-the-force-as-if-in-phase-with-it = força do amortecimento equivalente subtraída da força como se estivessem em fase
the-factor-2-of-an-undamped-system-under-a-sudden-load-taken = tomado o fator 2 de um sistema sem amortecimento sob carga súbita
the-first-harmonic-alone-taken = tomado só o primeiro harmônico
the-first-ordinate-taken-at-t-n-and-not-at-the-start-of-the-period = primeira ordenada tomada em T/N e não no início do período
the-first-speed-taken-as-that-of-resonance-1-2 = primeira velocidade tomada como a da ressonância, ζ = 1/(2Λ₁)
the-force-divided-by-the-mass-of-the-body-alone = força dividida só pela massa do corpo
the-force-of-the-spring-at-the-breakpoint-omitted = esquecida a força da mola no ponto de mudança
the-formula-for-light-damping-1-2m-used = usada a fórmula de amortecimento leve, ζ = 1/(2M)
the-free-travel-counted-as-deformation-of-the-spring = folga contada como deformação da mola
the-free-travel-counted-on-one-side-only = folga contada só de um lado
the-frequency-of-the-excitation-used-in-the-decay-of-the-free-vibration = usada a frequência da excitação no decaimento da vibração livre
the-frequency-of-the-free-vibration-taken-as-the-undamped-one = frequência da vibração livre tomada como a não amortecida
the-frequency-of-the-peak-taken-as-the-damped-natural-frequency = frequência do pico tomada como a frequência natural amortecida
the-frequency-of-the-peak-taken-as-the-natural-frequency = frequência do pico tomada como a frequência natural
the-friction-added-to-the-force-of-spring-and-inertia-as-if-in-phase = atrito somado à força da mola e da inércia como se estivessem em fase
the-friction-force-subtracted-from-the-amplitude-of-the-force = força de atrito subtraída da amplitude da força
the-geometric-mean-of-the-half-power-frequencies-taken = tomada a média geométrica das frequências de meia potência
the-harmonic-motion-of-small-oscillations-assumed = suposto o movimento harmônico das pequenas oscilações
the-kinetic-energy-taken-as-conserved-in-the-impact = energia cinética tomada como conservada no impacto
the-kinetic-energy-per-unit-volume-set-equal-to-the-strength = energia cinética por unidade de volume igualada à resistência do material
the-kinetic-energy-per-unit-volume-taken-as-the-stress = energia cinética por unidade de volume tomada como a tensão
the-magnification-factor-for-a-force-on-the-mass-used = usado o fator de amplificação de uma força aplicada à massa
the-mean-and-the-first-harmonic-alone-taken = tomados só a média e o primeiro harmônico
the-mean-contact-force-of-the-given-amplitude-used = usada a força de contato média da amplitude dada
the-mean-of-the-phases-taken = tomada a média das fases
the-mean-of-the-two-frequencies-taken = tomada a média das duas frequências
the-midpoint-between-the-largest-and-the-smallest-ordinate-taken-as-the-mean = ponto médio entre a maior e a menor ordenada tomado como a média
the-moment-of-a-load-at-midspan-used = usado o momento de uma carga no meio do vão
the-moment-of-a-simply-supported-beam-used = usado o momento de uma viga biapoiada
the-momentum-balance-made-with-the-speed-of-the-rod-in-place-of-that-of-the-wave-v = balanço da quantidade de movimento feito com a velocidade da barra no lugar da velocidade da onda: ρv²
the-natural-frequency-at-small-amplitudes-taken = tomada a frequência natural de pequenas amplitudes
the-natural-frequency-of-mass-and-spring-taken = tomada a frequência natural de massa e mola
the-natural-frequency-used-in-place-of-that-of-the-excitation = usada a frequência natural no lugar da frequência da excitação
the-parts-of-spring-damper-and-inertia-added-without-their-phases = somadas as parcelas da mola, do amortecedor e da inércia sem levar em conta as fases
the-peak-for-a-force-of-constant-amplitude-taken = tomado o pico de uma força de amplitude constante
the-peak-of-the-magnification-factor-for-a-force-on-the-mass-taken = tomado o pico do fator de amplificação de uma força aplicada à massa
the-peak-taken-as-the-damped-natural-frequency-the-free-vibration-as-the-undamped-one = pico tomado como a frequência natural amortecida, vibração livre como a não amortecida
the-period-at-small-amplitudes-taken = tomado o período de pequenas amplitudes
the-permanent-displacement-ignored-in-the-rebound = ignorado o deslocamento permanente no retorno
the-permanent-displacement-used-in-place-of-the-maximum-one = usado o deslocamento permanente no lugar do máximo
the-phase-of-a-mass-on-a-moving-base-taken = tomada a fase de uma massa sobre base móvel
the-phase-with-the-viscous-damping-equivalent-at-resonance-taken = tomada a fase com o amortecimento viscoso equivalente na ressonância
the-pulse-treated-as-an-impulse-without-duration = pulso tratado como impulso sem duração
the-ratio-of-the-amplitudes-taken-as-the-magnification-at-resonance = razão das amplitudes tomada como a amplificação na ressonância
the-ratio-of-the-forces-taken-as-the-tangent-of-the-angle = razão das forças tomada como a tangente do ângulo
the-ratio-of-the-relative-motion-to-that-of-the-base-used = usada a razão entre o movimento relativo e o da base
the-receptance-at-the-peak-taken-as-that-of-the-spring-alone = receptância no pico tomada como a da mola sozinha
the-reflections-of-the-wave-omitted = esquecidas as reflexões da onda
the-relation-2-which-holds-at-resonance-used-at-another-frequency = relação ζ = η/2, válida na ressonância, usada em outra frequência
the-response-to-a-rotating-unbalance-used = usada a resposta a um desbalanceamento rotativo
the-return-assumed-undamped-a-quarter-of-the-period-again = suposto retorno sem amortecimento: de novo um quarto do período
the-rod-treated-as-a-mass-on-a-spring-half-a-period-taken = barra tratada como massa sobre mola: tomado meio período
the-rod-treated-as-rigid-velocity-of-the-centre-of-mass-at-that-time = barra tratada como rígida: velocidade do centro de massa nesse instante
the-root-mean-square-of-the-harmonic-taken-as-its-amplitude = valor eficaz do harmônico tomado como a sua amplitude
the-root-mean-square-of-the-pulse-taken-as-its-mean = valor eficaz do pulso tomado como a sua média
the-root-mean-squares-of-the-motions-added = somados os valores eficazes dos movimentos
the-secant-stiffness-at-the-amplitude-used-for-the-whole-motion = usada em todo o movimento a rigidez secante na amplitude
the-secant-stiffness-at-the-maximum-displacement-used = usada a rigidez secante no deslocamento máximo
the-series-in-the-amplitude-cut-after-its-first-correction = série na amplitude cortada depois da primeira correção
the-specific-damping-capacity-taken-as-the-loss-factor = capacidade específica de amortecimento tomada como o fator de perda
the-speed-of-the-rod-used-in-place-of-that-of-the-wave = usada a velocidade da barra no lugar da velocidade da onda
the-spring-assumed-linear-beyond-the-breakpoint = mola suposta linear além do ponto de mudança
the-spring-assumed-to-stay-elastic = suposto que a mola permanece elástica
the-spring-omitted-the-weight-alone-taken = esquecida a mola: tomado só o peso
the-sprung-mass-assumed-at-rest = massa suspensa suposta em repouso
the-sprung-mass-assumed-at-rest-and-the-damping-omitted = massa suspensa suposta em repouso e esquecido o amortecimento
the-square-of-the-displacement-replaced-by-its-mean = quadrado do deslocamento substituído pela sua média
the-static-displacement-subtracted-from-the-maximum-one = deslocamento estático subtraído do máximo
the-stiffness-beyond-the-breakpoint-used-throughout = rigidez além do ponto de mudança usada em todo o movimento
the-stiffness-up-to-the-breakpoint-used-for-the-whole-displacement = rigidez até o ponto de mudança usada em todo o deslocamento
the-stiffness-up-to-the-breakpoint-used-throughout = rigidez até o ponto de mudança usada em todo o movimento
the-tangent-stiffness-at-the-amplitude-used-for-the-whole-motion = usada em todo o movimento a rigidez tangente na amplitude
the-time-of-the-maximum-of-an-elastic-spring-taken = tomado o instante do máximo de uma mola elástica
the-travel-time-of-the-wave-to-the-place-omitted = esquecido o tempo de percurso da onda até o ponto
the-transmissibility-used = usada a transmissibilidade
the-transmissibility-used-in-place-of-the-response-to-an-unbalance = usada a transmissibilidade no lugar da resposta a um desbalanceamento
the-transmissibility-without-damping-used = usada a transmissibilidade sem amortecimento
the-viscous-damping-equivalent-at-resonance-used-at-this-frequency = amortecimento viscoso equivalente na ressonância usado nesta frequência
the-weight-of-the-body-added-to-the-force-of-the-spring = peso do corpo somado à força da mola
the-weight-of-the-pan-included = incluído o peso do prato
the-weight-omitted-during-the-compression = esquecido o peso durante a compressão
the-whole-work-of-the-load-taken-as-dissipated = todo o trabalho da carga tomado como dissipado
the-yield-force-multiplied-by-the-whole-displacement = força de escoamento multiplicada por todo o deslocamento
the-natural-frequency-of-the-absorber-used-in-place-of-that-of-the-main-system = usada a frequência natural do absorvedor no lugar da do sistema principal
the-mass-of-the-main-system-used-in-place-of-that-of-the-absorber = usada a massa do sistema principal no lugar da do absorvedor
the-absorber-tuned-to-the-natural-frequency-of-the-main-system = absorvedor sintonizado na frequência natural do sistema principal
the-absolute-motion-of-the-absorber-taken-in-place-of-the-relative-one = tomado o movimento absoluto do absorvedor no lugar do relativo
the-tuning-for-a-random-force-used = usada a sintonia para força aleatória
the-damping-for-zero-slope-at-the-lower-fixed-point-alone-used = usado o amortecimento de inclinação nula apenas no ponto fixo inferior
the-damping-for-a-random-force-used = usado o amortecimento para força aleatória
the-damping-of-a-tuned-absorber-with-a-spring-used = usado o amortecimento de um absorvedor sintonizado, com mola
both-springs-taken-to-carry-the-slip-force = suposto que as duas molas suportam a força de deslizamento
the-viscous-damper-alone-taken-to-dissipate-energy = suposto que só o amortecedor viscoso dissipa energia
the-spring-of-the-friction-element-taken-as-rigid = mola do elemento de atrito suposta rígida
the-friction-element-taken-to-stick-at-every-amplitude = elemento de atrito suposto sem deslizamento em qualquer amplitude
the-friction-element-left-out = esquecido o elemento de atrito
the-pendulum-taken-as-a-point-mass = pêndulo tratado como massa pontual
the-distance-of-the-pendulum-mass-from-the-shaft-used-in-place-of-that-of-the-pivot = usada a distância da massa do pêndulo ao eixo no lugar da distância do pivô
the-speed-of-the-rotor-used-as-the-frequency-of-the-pendulum = usada a rotação do rotor como frequência do pêndulo
the-moment-of-the-pendulum-about-its-pivot-taken-as-its-torque-on-the-rotor = momento do pêndulo em relação ao pivô tomado como o seu torque sobre o rotor
the-pendulum-taken-as-locked-to-the-body-that-carries-it = pêndulo tratado como preso ao corpo que o sustenta
the-pendulum-tuned-to-the-natural-frequency-of-the-mass-on-its-springs = pêndulo sintonizado na frequência natural da massa sobre as suas molas
the-absorber-tuned-to-the-natural-frequency-of-the-main-system-in-place-of-the-speed = absorvedor sintonizado na frequência natural do sistema principal em vez de na rotação
the-mass-ratio-taken-over-the-total-mass = razão de massas tomada em relação à massa total
the-formula-for-an-absorber-tuned-to-the-natural-frequency-of-the-main-system-used = usada a fórmula de um absorvedor sintonizado na frequência natural do sistema principal
the-absorber-mass-taken-as-fixed-to-the-main-system = massa do absorvedor tratada como presa ao sistema principal
the-absorber-mass-taken-as-at-rest = massa do absorvedor suposta em repouso
the-stiffness-of-the-main-system-used-in-place-of-that-of-the-absorber = usada a rigidez do sistema principal no lugar da do absorvedor
the-motion-of-the-absorber-taken-relative-to-the-main-system = tomado o movimento do absorvedor relativo ao sistema principal
the-mean-of-the-two-resonances-taken-as-the-natural-frequency = média das duas ressonâncias tomada como a frequência natural
the-geometric-mean-of-the-two-resonances-taken-as-the-natural-frequency = média geométrica das duas ressonâncias tomada como a frequência natural
the-frequency-of-the-free-vibration-taken-as-that-of-the-largest-reading = frequência da vibração livre tomada como a da maior leitura
the-formula-of-the-other-kind-of-instrument-used = usada a fórmula do outro tipo de instrumento
the-transmissibility-used-as-for-the-absolute-motion-of-the-mass = usada a transmissibilidade, como para o movimento absoluto da massa
the-error-taken-as-a-fraction-of-the-reading = erro tomado como fração da leitura
the-principal-value-of-the-arctangent-taken-the-quadrant-ignored = tomado o valor principal do arco tangente, ignorado o quadrante
the-phase-of-the-absolute-motion-of-the-mass-taken = tomada a fase do movimento absoluto da massa
the-natural-frequency-of-the-instrument-used-in-place-of-that-of-the-motion = usada a frequência natural do instrumento no lugar da do movimento
the-damping-of-the-instrument-neglected = desprezado o amortecimento do instrumento
the-frequency-of-the-damped-free-vibration-used = usada a frequência da vibração livre amortecida
the-ratio-at-the-natural-frequency-1-2-used = usada a razão na frequência natural, 1/(2ζ)
the-highest-speed-used-in-place-of-the-lowest = usada a maior rotação no lugar da menor
the-whole-weight-taken-to-rest-on-one-mount = suposto todo o peso sobre um só coxim
the-mounts-taken-as-springs-in-series = coxins tratados como molas em série
the-frequency-ratio-of-the-largest-magnification-used = usada a razão de frequências da maior amplificação
the-largest-value-assumed-at-the-natural-frequency = suposto o maior valor na frequência natural
the-magnification-used-in-place-of-the-transmissibility = usada a amplificação no lugar da transmissibilidade
the-damping-of-the-mounts-neglected = desprezado o amortecimento dos coxins
the-force-of-the-dampers-omitted = esquecida a força dos amortecedores
the-forces-of-springs-and-dampers-added-as-if-in-phase = forças de molas e amortecedores somadas como se estivessem em fase
the-transmissibility-used-for-the-amplitude-of-the-machine = usada a transmissibilidade para a amplitude da máquina
the-magnification-of-a-force-of-constant-amplitude-used = usada a amplificação de uma força de amplitude constante
the-magnification-set-equal-to-the-required-transmissibility = amplificação igualada à transmissibilidade exigida
both-limits-of-acceleration-and-of-travel-taken-as-reached = supostos atingidos os dois limites, o da aceleração e o do curso
the-deceleration-assumed-to-be-constant = suposta desaceleração constante
the-first-mode-alone-counted-by-the-formula-for-white-noise = contado só o primeiro modo, pela fórmula de ruído branco
miles-formula-used-with-the-first-frequency-as-for-one-degree-of-freedom = usada a fórmula de Miles com a primeira frequência, como para um grau de liberdade
the-mean-squares-of-the-modes-added-by-the-formula-for-white-noise-without-cross-terms = somados os valores quadráticos médios dos modos pela fórmula de ruído branco, sem termos cruzados
the-frequencies-of-a-simply-supported-beam-used = usadas as frequências de uma viga biapoiada
the-root-mean-squares-of-the-modes-added-as-numbers = valores eficazes dos modos somados como números
the-first-mode-alone-counted = contado só o primeiro modo
the-stiffness-times-the-displacement-taken-the-damper-left-out = tomada a rigidez vezes o deslocamento, esquecido o amortecedor
the-formula-for-white-noise-used-for-a-band = usada a fórmula de ruído branco para uma faixa
the-response-taken-as-static-without-the-magnification-at-resonance = resposta tratada como estática, sem a amplificação na ressonância
the-root-mean-square-of-the-excitation-multiplied-by-the-quality-factor = valor eficaz da excitação multiplicado pelo fator de qualidade
the-responses-of-the-modes-added-with-their-signs = respostas dos modos somadas com os seus sinais
the-signs-of-the-modes-dropped-in-the-cross-terms = esquecidos os sinais dos modos nos termos cruzados
the-cross-term-of-each-pair-of-modes-counted-only-once = termo cruzado de cada par de modos contado uma só vez
the-moment-of-inertia-of-the-rod-taken-about-its-centre = momento de inércia da barra tomado em relação ao seu centro
the-mass-of-the-rod-taken-as-a-point-at-its-middle = massa da barra tratada como um ponto no seu meio
the-weight-of-the-rod-taken-at-its-end = peso da barra posto na sua extremidade
the-spring-taken-at-the-end-of-the-pendulum = mola posta na extremidade do pêndulo
the-lower-pendulum-taken-in-line-with-the-upper-one-its-centre-of-mass-at-l-c = pêndulo inferior tratado como alinhado com o superior, o centro de massa a l₁ + c₂
the-moment-of-inertia-of-the-lower-pendulum-counted-for-the-upper-angle-too = momento de inércia do pêndulo inferior contado também no ângulo do superior
the-weight-of-the-lower-pendulum-taken-at-its-centre-of-mass = peso do pêndulo inferior posto no seu centro de massa
the-weight-of-the-upper-pendulum-taken-at-the-lower-pivot = peso do pêndulo superior posto no pivô inferior
the-coupling-of-the-two-pendulums-neglected = desprezado o acoplamento dos dois pêndulos
a-simple-pendulum-of-the-whole-length-assumed = suposto um pêndulo simples com o comprimento total
the-other-mass-taken-as-at-rest = a outra massa suposta em repouso
the-tyres-taken-as-rigid-and-bounce-and-pitch-as-uncoupled = pneus supostos rígidos, e salto vertical e arfagem desacoplados
the-masses-of-the-wheels-neglected-and-bounce-and-pitch-taken-as-uncoupled = desprezadas as massas das rodas, e salto vertical e arfagem supostos desacoplados
the-wheel-taken-on-its-tyre-alone-without-the-suspension = roda tomada só sobre o pneu, sem a suspensão
the-longest-natural-period-used-in-place-of-the-shortest = usado o maior período natural no lugar do menor
a-tenth-of-the-period-the-rule-for-accuracy-taken = tomado um décimo do período, a regra da precisão
the-critical-time-step-of-central-differences-used = usado o passo crítico das diferenças centrais
the-minimum-assumed-halfway-between-the-two-frequencies = mínimo suposto a meio caminho entre as duas frequências
the-geometric-mean-of-the-two-frequencies-taken = tomada a média geométrica das duas frequências
the-damping-ratio-interpolated-linearly-between-the-two-modes = fator de amortecimento interpolado linearmente entre os dois modos
the-coefficient-found-from-one-mode-the-other-term-of-the-damping-left-out = coeficiente calculado com um só modo, esquecido o outro termo do amortecimento
the-mean-damping-ratio-used-for-both-modes = usado o fator de amortecimento médio nos dois modos
the-decay-rate-divided-by-the-damped-frequency = taxa de decaimento dividida pela frequência amortecida
the-coupling-of-the-two-coordinates-neglected = desprezado o acoplamento das duas coordenadas
the-bearing-taken-to-hold-the-shaft-along-its-axis = mancal suposto como se travasse o eixo na direção axial
the-whole-length-between-the-supports-used = usado todo o comprimento entre os apoios
the-stiffness-12ei-l-of-an-end-that-cannot-rotate-used = usada a rigidez 12EI/L³ de uma extremidade impedida de girar
the-stiffness-for-a-body-at-midspan-used = usada a rigidez para um corpo no meio do vão
the-two-parts-taken-as-cantilevers-in-parallel = os dois trechos tomados como vigas em balanço em paralelo
the-bearing-left-out-the-fixed-part-taken-as-a-cantilever = mancal omitido, trecho engastado tomado como viga em balanço
the-bearing-taken-to-keep-the-end-of-the-shaft-from-rotating = mancal suposto como se impedisse a rotação da ponta do eixo
young-s-modulus-used-as-the-shear-modulus = usado o módulo de Young como módulo de cisalhamento
the-bulk-modulus-e-3-1-2-used = usado o módulo volumétrico, E/(3(1 − 2ν))
the-overtones-taken-as-whole-multiples-of-the-first-frequency = frequências superiores tomadas como múltiplos inteiros da primeira
the-frequencies-taken-in-the-ratios-1-4-9-of-pinned-ends = frequências tomadas nas razões 1, 4, 9 de extremidades articuladas
the-amplitude-under-a-constant-force-e-1-r-used = usada a amplitude sob força constante, e/|1 − r²|
the-distance-of-the-centre-of-mass-from-the-bearing-axis-used = usada a distância do centro de massa ao eixo dos mancais
the-amplitude-at-r-1-e-2-used = usada a amplitude em r = 1, e/(2ζ)
the-peak-of-the-response-to-a-constant-force-used = usado o pico da resposta a uma força constante
the-shaft-taken-as-rigid-with-the-force-m-e = eixo tomado como rígido, com a força m e ω²
the-damping-force-at-the-rotor-added-to-the-force-of-the-shaft = força de amortecimento no rotor somada à força do eixo
half-of-the-load-taken-at-each-bearing = metade da carga tomada em cada mancal
the-load-on-the-pinned-bearing-taken = tomada a carga no mancal articulado
the-bending-moment-at-the-rotor-used = usado o momento fletor no rotor
the-bending-moment-of-a-simply-supported-shaft-used = usado o momento fletor de um eixo biapoiado
the-highest-speed-of-the-range-taken-as-the-worst = maior rotação da faixa tomada como a mais desfavorável
the-lowest-speed-of-the-range-taken-as-the-worst = menor rotação da faixa tomada como a mais desfavorável
the-static-deflection-under-the-force-m-e-taken = tomada a deflexão estática sob a força m₀eω²
the-disc-taken-as-a-point-mass-without-moments-of-inertia = disco tomado como massa pontual, sem momentos de inércia
the-disc-taken-to-deflect-without-tilting = disco suposto deslocar-se sem inclinar
the-disc-taken-to-tilt-without-deflecting = disco suposto inclinar-se sem deslocar
the-moment-of-inertia-about-a-diameter-of-the-face-taken = tomado o momento de inércia em torno de um diâmetro da face
the-stiffness-3ei-l-of-a-tip-that-is-free-to-tilt-used = usada a rigidez 3EI/L³ de uma ponta livre para inclinar
the-inverse-of-the-slope-per-unit-force-used = usado o inverso da inclinação por força unitária
the-stiffness-ei-l-of-a-tip-that-is-free-to-deflect-used = usada a rigidez EI/L de uma ponta livre para deslocar-se
the-moments-of-inertia-added-as-if-all-amplitudes-were-1 = momentos de inércia somados como se todas as amplitudes fossem 1
the-amplitudes-not-squared = amplitudes não elevadas ao quadrado
the-phase-vectors-added-as-numbers = vetores de fase somados como números
all-cranks-given-the-same-amplitude-without-the-mode-shape = mesma amplitude dada a todas as manivelas, sem a forma modal
the-firing-angles-not-multiplied-by-the-order = ângulos de ignição não multiplicados pela ordem
the-speed-of-the-crankshaft-used-as-the-frequency = rotação do virabrequim usada como frequência
the-torques-of-the-cylinders-taken-as-the-torque-in-the-shaft = torques dos cilindros tomados como o torque no eixo
the-equilibrium-amplitude-used-in-place-of-that-at-resonance = usada a amplitude de equilíbrio em vez da de ressonância
the-second-disc-taken-as-fixed = segundo disco tomado como fixo
the-first-disc-taken-as-fixed = primeiro disco tomado como fixo
both-discs-taken-to-rotate-together-against-the-shaft = os dois discos supostos girar juntos contra o eixo
the-disc-in-the-middle-left-out = disco do meio omitido
the-disc-in-the-middle-taken-as-fixed = disco do meio tomado como fixo
the-shafts-taken-as-springs-in-parallel = eixos tomados como molas em paralelo
the-moments-of-inertia-added-without-being-reduced = momentos de inércia somados sem serem reduzidos
the-gear-ratio-not-squared-in-the-reduction = relação de transmissão não elevada ao quadrado na redução
the-deflection-of-a-disc-at-midspan-l-48ei-used = usada a deflexão de um disco no meio do vão, L³/(48EI)
the-deflection-of-the-tip-l-3ei-used = usada a deflexão da ponta, L³/(3EI)
the-overhang-taken-as-clamped-at-the-bearing = trecho em balanço tomado como engastado no mancal
the-periods-of-the-masses-alone-added = somados os períodos das massas isoladas
the-squares-of-the-frequencies-of-the-masses-alone-added = somados os quadrados das frequências das massas isoladas
the-deflection-under-the-weight-of-that-disc-alone = deflexão só sob o peso desse disco
g-with-the-largest-static-deflection-used = usada √(g/δ) com a maior deflexão estática
g-with-the-sum-of-the-static-deflections-used = usada √(g/δ) com a soma das deflexões estáticas
the-speed-of-longitudinal-waves-e-used = usada a velocidade das ondas longitudinais, √(E/ρ)
the-wave-speed-of-a-round-shaft-g-used = usada a velocidade de onda de um eixo circular, √(G/ρ)
the-mass-of-the-body-itself-left-out = massa do próprio corpo omitida
the-whole-mass-of-the-body-added-to-that-at-its-end = toda a massa do corpo somada à da extremidade
the-body-taken-as-rigid-on-the-spring = corpo tomado como rígido sobre a mola
euler-s-load-ei-l-of-pinned-ends-used = usada a carga de Euler π²EI/L² de extremidades articuladas
the-whole-mass-of-the-beam-lumped-where-it-deflects-most = toda a massa da viga concentrada onde ela mais se desloca
the-whole-mass-of-the-beam-added-to-that-on-it = toda a massa da viga somada à que está sobre ela
the-body-taken-as-a-point-mass-at-the-tip-of-a-beam-without-mass = corpo tomado como massa pontual na ponta de uma viga sem massa
the-whole-mass-of-the-beam-added-to-the-body-as-a-point-mass-at-the-tip = toda a massa da viga somada ao corpo como massa pontual na ponta
the-longest-span-alone-taken-pinned-at-both-ends = tomado só o vão mais longo, articulado nas duas extremidades
the-supports-between-the-ends-left-out-both-ends-pinned = apoios intermediários omitidos, as duas extremidades articuladas
the-section-of-the-left-end-taken-for-the-whole-beam = seção da extremidade esquerda tomada para toda a viga
the-section-at-the-middle-taken-for-the-whole-beam = seção do meio tomada para toda a viga
the-stiffening-by-the-centrifugal-force-left-out = enrijecimento pela força centrífuga omitido
southwell-s-coefficient-taken-as-1 = coeficiente de Southwell tomado como 1
the-frequency-at-rest-used-rotation-left-out = usada a frequência em repouso, rotação omitida
the-motion-taken-to-lie-in-the-plane-of-rotation = movimento suposto no plano de rotação
the-plate-taken-as-a-strip-of-the-length-a-pinned-at-its-ends = placa tomada como faixa de comprimento a, articulada nas pontas
the-membrane-taken-as-a-string-across-its-diameter = membrana tomada como corda ao longo do diâmetro
the-plate-taken-as-a-beam-across-its-diameter = placa tomada como viga ao longo do diâmetro
the-highest-frequency-decides-not-that-of-the-modes-that-are-shown = A maior frequência decide, não a dos modos mostrados.
two-steps-of-linear-acceleration = Dois passos de aceleração linear
x-x-hv-h-a-3-1-h-6-a-x-v-v-h-a-a-2-with-3-rad-s-and-h-0-2-s-stable-up-to-h-2-3 = x₁ = (x₀ + hv₀ + h²a₀/3)/(1 + ω²h²/6), a₁ = −ω²x₁, v₁ = v₀ + h(a₀ + a₁)/2 com ω = 3 rad/s e h = 0,2 s; estável até ωh = 2√3
twenty-masses-a-step-beyond-the-critical-one = Vinte massas, um passo maior que o crítico
n-2-k-m-sin-20-42-of-twenty-equal-masses-between-two-walls-t-cr-2-of-central-differences = ω₂₀ = 2√(k/m) sen(20π/42) de vinte massas iguais entre duas paredes, Δt_cr = 2/ω₂₀ das diferenças centrais
