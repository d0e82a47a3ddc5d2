# Both analyses
angular-momentum-along-the-shaft = Momento angular ao longo do eixo
at-this-angle = neste ângulo
components-of-the-angular-momentum-in-the-fixed-axes = Componentes do momento angular nos eixos fixos
components-of-the-couple-in-the-fixed-axes = Componentes do binário nos eixos fixos
couple = binário
couple-about-z = binário em torno de z
kinetic-energy = Energia cinética
transport-term-h = Termo de transporte Ω × H

# rigid-body/body
moment-of-inertia-about-an-axis-through-g-that-turns-in-a-principal-plane = Momento de inércia em relação a um eixo por G que gira em um plano principal
angle-from-the-first-axis-of-the-plane = ângulo a partir do primeiro eixo do plano
axis-1-to-axis-2 = do eixo 1 ao eixo 2
axis-2-to-axis-3 = do eixo 2 ao eixo 3
axis-3-to-axis-1 = do eixo 3 ao eixo 1
first-end = Primeira extremidade
second-end = Segunda extremidade
a-hole = Um furo
a-line = Uma reta
a-line-has-no-moment-of-inertia-about-itself-nor-a-particle-about-its-own-position = Uma linha não tem momento de inércia em relação a si mesma, nem uma partícula em relação à sua posição
about-its-centre-of-mass-the-origin = Em relação ao seu centro de massa, a origem.
about-its-own-z-axis-from-its-apex-open-at-the-base = Em torno do seu eixo z, a partir do vértice, aberta na base.
about-its-own-z-axis-from-its-apex = Em torno do seu eixo z, a partir do vértice.
about-its-own-z-axis-from-its-centre-open-at-both-ends = Em torno do seu eixo z, a partir do centro, aberto nas duas extremidades.
about-its-own-z-axis-from-its-centre = Em torno do seu eixo z, a partir do centro.
about-its-own-z-axis-from-its-vertex = Em torno do seu eixo z, a partir do seu vértice.
about-its-own-z-axis-y-0-from-the-middle-of-the-axis-of-the-circle = Em torno do seu eixo z, y ≥ 0, a partir do meio do eixo do círculo.
about-its-own-z-axis-z-0-from-the-centre-of-the-circle-open-there = Em torno do seu eixo z, z ≥ 0, a partir do centro do círculo, aberta ali.
about-its-own-z-axis-z-0-from-the-centre-of-the-circle = Em torno do seu eixo z, z ≥ 0, a partir do centro do círculo.
about-its-own-z-axis = Em torno do seu eixo z.
about-principal-axes-through-its-centre-of-mass-the-origin = Em relação aos eixos principais pelo seu centro de massa, a origem.
all-parts-lie-on-the-axis = Todas as partes estão sobre o eixo
along-its-own-x-y-and-z-axes-from-their-common-corner = Ao longo dos seus eixos x, y e z, a partir do canto comum.
along-its-own-z-axis-from-its-middle = Ao longo do seu eixo z, a partir do meio.
along-x-y-and-z = Ao longo de x, y e z
amount = Quantidade
angle-of-the-arc = Ângulo do arco
angle-positive-by-the-right-hand-rule = Ângulo, positivo pela regra da mão direita
another-point = Outro ponto
any-vector-along-it = Qualquer vetor ao longo dela
any-vector-along-the-axis = Qualquer vetor ao longo do eixo
any-vector-along-its-z-axis = Qualquer vetor ao longo do seu eixo z
any-vector-on-the-side-of-its-x-axis = Qualquer vetor do lado do seu eixo x
any-shape-by-its-inertia-matrix = Qualquer forma, pela matriz de inércia
any-shape-by-its-radii-of-gyration = Qualquer forma, pelos raios de giração
area-of-name = Área de { $name }
as-defined-for-the-shape-the-apex-of-a-cone-the-centre-of-a-sphere-of-a-plate-or-of-a-circle = Como definido para a forma: o vértice de um cone, o centro de uma esfera, de uma placa ou de um círculo.
box = Paralelepípedo
cone = Cone
cylinder = Cilindro
density = Massa específica
direction-cosines-of-the-line = Cossenos diretores da reta
direction-of-the-axes-of-the-shape = Direção dos eixos da forma
direction-of-the-axis-of-name = Direção do eixo de { $name }
direction-of-the-x-axis-of-name = Direção do eixo x de { $name }
direction-of-the-y-axis-of-name = Direção do eixo y de { $name }
direction-of-the-z-axis-of-name = Direção do eixo z de { $name }
distance-of-g-from-the-line = Distância de G à reta
edge-along-x = Aresta ao longo de x
edge-along-y = Aresta ao longo de y
edge-along-z = Aresta ao longo de z
ellipsoid = Elipsoide
euler-angles = Ângulos de Euler
for-shapes-of-revolution-and-rods-other-shapes-are-rotated-there-through-the-smallest-angle = Para formas de revolução e hastes; as demais são giradas até lá pelo menor ângulo.
from-a-to-g = De A a G
from-g-to-the-centre-of-mass-of-name = De G ao centro de massa de { $name }
from-its-centre = A partir do seu centro.
from-the-given-point-to-g = Do ponto dado a G
from-the-reference-point-of-name-to-its-centre-of-mass-in-its-own-axes = Do ponto de referência de { $name } ao seu centro de massa, nos eixos próprios
semi-axis-along-x = Semieixo ao longo de x
semi-axis-along-y = Semieixo ao longo de y
semi-axis-along-z = Semieixo ao longo de z
half-cylinder = Meio cilindro
height = Altura
hemisphere = Semiesfera
hollow-cylinder = Cilindro vazado
hollow-sphere = Esfera oca
i-xy-xy-dm-in-the-inertia-matrix-they-appear-with-a-minus-sign = I_xy = ∫ xy dm; na matriz de inércia entram com sinal negativo.
in-its-own-xy-plane-about-the-origin-from-the-x-axis-towards-y = No seu plano xy em torno da origem, do eixo x para y.
in-its-own-xy-plane-from-its-centre = No seu plano xy, a partir do centro.
in-its-own-xy-plane-legs-along-x-and-y-from-the-right-angle = No seu plano xy, catetos ao longo de x e y a partir do ângulo reto.
in-its-own-xy-plane-x-y-0-from-the-centre-of-the-circle = No seu plano xy, x, y ≥ 0, a partir do centro do círculo.
in-its-own-xy-plane-y-0-from-the-centre-of-the-circle = No seu plano xy, y ≥ 0, a partir do centro do círculo.
inertia-matrix-about-g = Matriz de inércia em relação a G
inner-radius = Raio interno
its-axis = Seu eixo
its-axis-the-direction-u-in-which-i-u-u = Seu eixo: a direção u em que I u = λ u
its-corner = Seu canto
its-far-end = Sua extremidade final
its-centre-of-mass = Seu centro de massa
its-mass-is-subtracted-from-the-rest = Sua massa é subtraída do resto.
its-near-end = Sua extremidade inicial
i-m-k-and-so-on-the-axes-are-principal-ones = Iₓ = m kₓ² e assim por diante; os eixos são principais.
it-is = É
defined-by-its-inertia-matrix = Definido pela matriz de inércia
defined-by-its-radii-of-gyration = Definido pelos raios de giração
leg-along-x = Cateto ao longo de x
leg-along-y = Cateto ao longo de y
length = Comprimento
length-of-name = Comprimento de { $name }
centre-of-mass-g-the-mean-of-the-centres-of-mass-weighted-with-the-masses = Centro de massa G: a média dos centros de massa, ponderada pelas massas
centre-of-mass-of-name = Centro de massa de { $name }
centre-of-mass-moments-and-products-of-inertia-principal-axes-of-a-composite-body-about-any-point-and = Centro de massa, momentos e produtos de inércia e eixos principais de um corpo composto, em relação a qualquer ponto e reta.
mass-of-all-parts = Massa de todas as partes
mass-of-this-body = Massa deste corpo
mass-of-name = Massa de { $name }
mass-of-name-subtracted = Massa de { $name }, subtraída
mass-per-area = Massa por área
mass-per-length = Massa por comprimento
mass-centre-of-mass-and-inertia-of-a-body = Massa, centro de massa e inércia de um corpo
material = Material
moment-of-inertia-about-an-axis-of-the-body-through-g = Momento de inércia em relação a um eixo do corpo por G
moment-of-inertia-about-an-axis-through-g-those-of-the-parts-by-the-parallel-axis-theorem = Momento de inércia em relação a um eixo por G: os das partes, pelo teorema dos eixos paralelos
moment-of-inertia-about-the-line = Momento de inércia em relação à reta
moment-of-inertia-about-the-parallel-line-through-g = Momento de inércia em relação à reta paralela por G
moment-of-inertia-about-the-x-axis-through-a = Momento de inércia em relação ao eixo x por A
moment-of-inertia-about-the-x-axis-through-g = Momento de inércia em relação ao eixo x por G
moment-of-inertia-about-the-y-axis-through-a = Momento de inércia em relação ao eixo y por A
moment-of-inertia-about-the-y-axis-through-g = Momento de inércia em relação ao eixo y por G
moment-of-inertia-about-the-z-axis-through-a = Momento de inércia em relação ao eixo z por A
moment-of-inertia-about-the-z-axis-through-g = Momento de inércia em relação ao eixo z por G
moment-of-inertia-as-given-about-an-axis-through-g = Momento de inércia dado, em relação a um eixo por G
moment-of-inertia-from-its-radius-of-gyration = Momento de inércia a partir do raio de giração
moment-of-inertia-of-name-about-one-of-its-own-axes-through-its-centre-of-mass = Momento de inércia de { $name } em relação a um dos seus eixos pelo seu centro de massa
moment-of-inertia-of-name-about-an-axis-of-the-body-through-its-centre-of-mass-from-its-direction = Momento de inércia de { $name } em relação a um eixo do corpo pelo seu centro de massa, pelos cossenos diretores
moment-of-inertia-of-name-about-any-axis-through-its-centre-of-mass = Momento de inércia de { $name } em relação a qualquer eixo pelo seu centro de massa
moment-of-inertia-of-name-about-its-own-axis = Momento de inércia de { $name } em relação ao seu próprio eixo
transverse-moment-of-inertia-of-name-about-its-centre-of-mass = Momento de inércia transversal de { $name }, em relação ao seu centro de massa
moments-of-inertia-i-i-y-i-z = Momentos de inércia Iₓ, I_y, I_z
no-product-of-inertia-the-axes-through-g-are-principal = Nenhum produto de inércia: os eixos por G são principais
nutation = Nutação
outer-radius = Raio externo
its-z-axis-along = Seu eixo z ao longo de
its-z-axis-along-one-vector-its-x-axis-towards-another = Seu eixo z ao longo de um vetor, seu eixo x para o lado de outro
paraboloid = Paraboloide
parallel-axis-theorem-back-to-g-less-m-times-the-square-of-the-distance-between-the-axes = Teorema dos eixos paralelos, de volta a G: menos m vezes o quadrado da distância entre os eixos
parallel-axis-theorem-moment-of-inertia-about-an-axis-through-a = Teorema dos eixos paralelos: momento de inércia em relação a um eixo por A
parallel-axis-theorem-moment-of-inertia-about-the-line = Teorema dos eixos paralelos: momento de inércia em relação à reta
parallel-axis-theorem-product-of-inertia-about-a = Teorema dos eixos paralelos: produto de inércia em relação a A
particle = Partícula
parts = Partes
position-of-a-point-a = Posição de um ponto A
position-of-a-point-on-it = Posição de um ponto sobre ela
position-of-the-centre-of-mass-g = Posição do centro de massa G
position-of-the-point = Posição do ponto
position-of-the-reference-point = Posição do ponto de referência
principal-moment-of-inertia = Momento principal de inércia
principal-moment-of-inertia-the-roots-of-det-i-1-0-in-ascending-order = Momento principal de inércia: as raízes de det(I − λ 1) = 0 em ordem crescente
product-of-inertia-i-xy-about-a = Produto de inércia I_xy em relação a A
product-of-inertia-i-xy-about-g = Produto de inércia I_xy em relação a G
product-of-inertia-i-yz-about-a = Produto de inércia I_yz em relação a A
product-of-inertia-i-yz-about-g = Produto de inércia I_yz em relação a G
product-of-inertia-i-zx-about-a = Produto de inércia I_zx em relação a A
product-of-inertia-i-zx-about-g = Produto de inércia I_zx em relação a G
product-of-inertia-about-g-i-xy-xy-dm-it-enters-the-inertia-matrix-with-a-minus-sign = Produto de inércia em relação a G, I_xy = ∫ xy dm; na matriz de inércia entra com sinal negativo
product-of-inertia-as-given = Produto de inércia dado
product-of-inertia-in-the-axes-of-the-body-through-g = Produto de inércia nos eixos do corpo por G
product-of-inertia-of-name-in-its-own-axes-through-its-centre-of-mass = Produto de inércia de { $name } nos seus eixos próprios pelo seu centro de massa
product-of-inertia-of-name-in-the-same-way = Produto de inércia de { $name }, do mesmo modo
product-of-inertia-transferred-to-g-in-the-same-way = Produto de inércia, transferido a G do mesmo modo
products-of-inertia-i-yz-i-zx-i-xy = Produtos de inércia I_yz, I_zx, I_xy
composed-of-parts = Composto de partes
radii-of-gyration = Raios de giração
radii-of-gyration-about-the-axes-through-g = Raios de giração em relação aos eixos por G
radius-of-gyration-about-the-line = Raio de giração em relação à reta
radius-of-gyration-about-the-x-axis-through-g = Raio de giração em relação ao eixo x por G
radius-of-gyration-about-the-y-axis-through-g = Raio de giração em relação ao eixo y por G
radius-of-gyration-about-the-z-axis-through-g = Raio de giração em relação ao eixo z por G
radius-of-the-base = Raio da base
radius-of-the-circle-through-the-middle-of-the-section = Raio do círculo pelo meio da seção
radius-of-the-section = Raio da seção
reference-point = Ponto de referência
rod-bent-into-a-circular-arc = Haste curvada em arco de círculo
shape = Forma
side-along-x = Lado ao longo de x
side-along-y = Lado ao longo de y
side-along-z = Lado ao longo de z
slender-ring = Aro delgado
slender-rod = Haste delgada
slender-rod-between-two-points = Haste delgada entre dois pontos
sphere = Esfera
spin = Rotação própria
tetrahedron-with-three-edges-at-right-angles = Tetraedro com três arestas em ângulo reto
the-corner-with-the-smallest-coordinates-in-its-own-axes = O canto de menores coordenadas nos eixos próprios.
the-body = No corpo
the-body-its-axes-and-its-principal-axes-at-g = O corpo, seus eixos e seus eixos principais em G
the-inertia-about-the-axes-through-it-is-also-calculated = Calcula-se também a inércia em relação aos eixos por ele.
the-centre-of-mass = O centro de massa
the-moment-of-inertia-about-it-is-calculated = Calcula-se o momento de inércia em relação a ela.
the-next-root = A raiz seguinte
the-origin-of-its-own-axes = A origem dos seus eixos próprios
the-parts-and-the-whole = As partes e o todo
the-points-relative-to-the-reference-point = Os pontos em relação ao ponto de referência.
taken-about = Tomados em relação a
thin-conical-shell = Casca cônica fina
thin-disc-with-a-hole = Disco fino com furo
thin-elliptical-plate = Placa elíptica fina
thin-half-disc = Meio disco fino
thin-hemispherical-shell = Casca semiesférica fina
thin-quarter-disc = Quarto de disco fino
thin-rectangular-plate = Placa retangular fina
thin-right-angled-triangular-plate = Placa fina em triângulo retângulo
thin-spherical-shell = Casca esférica fina
thin-tube = Tubo fino
torus = Toro
rotated-about-an-axis = Girada em torno de um eixo
rotated-about-z-by-then-about-the-new-x-axis-by-then-about-the-new-z-axis-by = Girada de φ em torno de z, depois de θ em torno do novo eixo x, depois de ψ em torno do novo eixo z.
volume-of-name = Volume de { $name }
where-its-own-z-axis-enters-it-where-an-arc-begins = Onde seu eixo z entra nela; onde um arco começa.
where-its-own-z-axis-leaves-it-where-an-arc-ends = Onde seu eixo z sai dela; onde um arco termina.
a-direction-of-name-has-no-length-write-any-vector-along-it = uma direção de { $name } não tem comprimento: escreva qualquer vetor ao longo dela
all-principal-moments-are-equal-every-axis-through-g-is-a-principal-axis = todos os momentos principais são iguais: todo eixo por G é eixo principal
part = parte
the-body-is-not-defined = o corpo não está definido
the-direction-of-name-has-no-length-write-any-vector-along-it-such-as-1-0-0 = a direção de { $name } não tem comprimento: escreva qualquer vetor ao longo dela, como (1; 0; 0)
with-its-holes-name-would-have-a-mass-of-mass-make-them-smaller = com os furos, { $name } teria massa de { $mass }: diminua-os
the-inertia-about-a-from-the-tensor-i-m-d-1-d-d = a inércia em relação a A pelo tensor I + m (d² 1 − d dᵀ)
the-inertia-matrix-from-the-sum-of-the-rotated-and-shifted-tensors-r-i-r-m-d-1-d-d = a matriz de inércia pela soma dos tensores girados e transportados R I Rᵀ + m (d² 1 − d dᵀ)
the-inertia-matrix-of-name-is-not-symmetric = a matriz de inércia de { $name } não é simétrica
the-inner-radius-of-name-is-not-smaller-than-its-outer-radius-write-the-smaller-one-as-the-inner = o raio interno de { $name } não é menor que o externo: escreva o menor como interno
the-largest-principal-moment-is-the-sum-of-the-others-the-body-is-flat = o maior momento principal é a soma dos outros: o corpo é plano
the-line-has-no-direction-write-any-vector-along-it-such-as-1-0-0 = a reta não tem direção: escreva qualquer vetor ao longo dela, como (1; 0; 0)
the-centre-of-mass-from-the-tensors = o centro de massa pelos tensores
the-total-mass-of-the-parts = a massa total das partes
the-masses-or-dimensions-of-name-are-too-large-for-any-body-check-their-units = as massas ou dimensões de { $name } são grandes demais para qualquer corpo: verifique suas unidades
the-moment-about-the-line-from-the-tensor-about-a-point-of-it-i = o momento em relação à reta pelo tensor em relação a um dos seus pontos, λ · I λ
the-moment-of-inertia-of-name-about-the-axis-axis-through-its-centre-of-mass-would-be-moment-and-none = o momento de inércia de { $name } em relação ao eixo { $axis } pelo seu centro de massa seria { $moment }, e nenhum é negativo: verifique seus momentos, produtos e furos
the-moment-of-inertia-of-name-about-the-principal-axis-axis-would-be-moment-more-than-the-others-of = o momento de inércia de { $name } em relação ao eixo principal { $axis } seria { $moment }, mais que os { $others } dos outros dois juntos, o que viola a desigualdade triangular: verifique seus momentos e produtos
the-principal-axis-from-i-u-u-0 = o eixo principal por I u − λ u = 0
the-principal-moments-from-their-sum-which-is-i-i-y-i-z = os momentos principais pela sua soma, que é Iₓ + I_y + I_z
the-section-of-the-torus-name-is-larger-than-its-circle-make-its-radius-smaller = a seção do toro { $name } é maior que o seu círculo: diminua o raio dela
the-two-ends-of-name-define-its-direction-leave-that-along-x-y-and-z = as duas extremidades de { $name } já dão sua direção: deixe-a ao longo de x, y e z
the-two-vectors-for-the-axes-of-name-lie-along-one-line-give-another-for-the-own-x-axis = os dois vetores dos eixos de { $name } estão sobre uma mesma reta: dê outro para o eixo x próprio
the-whole = o todo
this-body = este corpo
two-principal-moments-are-equal-every-axis-through-g-normal-to-the-principal-axis-n-is-a-principal = dois momentos principais são iguais: todo eixo por G perpendicular ao eixo principal { $n } é eixo principal
name-has-neither-length-area-nor-volume-give-its-mass = { $name } não tem comprimento, área nem volume: dê sua massa
name-has-no-corner-to-be-placed-by-use-the-origin-of-its-own-axes-or-its-centre-of-mass = { $name } não tem canto pelo qual se posicione: use a origem dos eixos próprios ou o centro de massa
name-has-no-ends-to-be-placed-by-use-the-origin-of-its-own-axes-or-its-centre-of-mass = { $name } não tem extremidades pelas quais se posicione: use a origem dos eixos próprios ou o centro de massa
name-has-no-moment-of-inertia-about-the-axis-axis-nothing-resists-its-rotation-there-give-it-a = { $name } não tem momento de inércia em relação ao eixo { $axis }: nada se opõe ao seu giro ali; dê-lhe uma espessura
name-is-a-line-give-its-mass-or-its-mass-per-length = { $name } é uma linha: dê sua massa ou sua massa por comprimento
name-is-a-surface-give-its-mass-or-its-mass-per-area = { $name } é uma superfície: dê sua massa ou sua massa por área
name-is-solid-give-its-mass-or-its-density = { $name } é sólido: dê sua massa ou sua densidade

# rigid-body/dipping-rail
above = De cima
amplitude-of-the-harmonic-motion-half-of-the-depth = Amplitude do movimento harmônico: metade da profundidade
angular-velocity-of-the-wheels = Velocidade angular das rodas
angular-velocity-of-the-wheels-rolling-without-slipping = Velocidade angular das rodas, que rolam sem deslizar
corresponding-change-of-the-wheel-load = Variação correspondente da carga das rodas
angular-frequency-the-whole-dip-is-one-period = Frequência angular: o rebaixo inteiro é um período
couple-that-tilts-the-pair-of-wheels = Binário que inclina o rodeiro
depth-of-the-dip = Profundidade do rebaixo
diameter-of-the-wheels = Diâmetro das rodas
distance-between-the-wheels = Distância entre as rodas
effect-while-the-left-wheel-descends-the-pair-of-wheels-tends-to-turn-to-the-left-while-it-rises-to = Efeito: enquanto a roda esquerda desce, o rodeiro tende a virar para a esquerda; enquanto sobe, para a direita
effect-while-the-right-wheel-descends-the-pair-of-wheels-tends-to-turn-to-the-right-while-it-rises-to = Efeito: enquanto a roda direita desce, o rodeiro tende a virar para a direita; enquanto sobe, para a esquerda
for-the-couple-that-lifts-and-lowers-it = Para o binário que o levanta e abaixa.
force-between-each-wheel-and-its-rail = Força entre cada roda e seu trilho
force-between-each-wheel-and-its-rail-along-the-track-opposite-on-both-sides = Força entre cada roda e seu trilho, ao longo da via, oposta nos dois lados
given = Dado
gyroscopic-couple = Momento giroscópico
gyroscopic-couple-of-a-locomotive-s-pair-of-wheels-when-one-rail-dips-and-the-resulting-forces = Momento giroscópico do rodeiro de uma locomotiva quando um dos trilhos tem um rebaixo, e as forças resultantes entre rodas e trilhos.
gyroscopic-couple-over-the-dip = Momento giroscópico ao longo do rebaixo
extent-of-the-dip = Extensão do rebaixo
by-length = Por comprimento
by-duration = Por duração
maximum-angular-acceleration-of-the-axle-at-the-top-and-at-the-bottom-of-the-dip = Aceleração angular máxima do eixo, no alto e no fundo do rebaixo
maximum-angular-acceleration-of-the-tilting-axle = Aceleração angular máxima do eixo que se inclina
maximum-angular-velocity-of-the-tilting-axle = Velocidade angular máxima do eixo que se inclina
maximum-angular-velocity-with-which-the-axle-tilts = Velocidade angular máxima com que o eixo se inclina
maximum-change-of-each-wheel-load = Variação máxima da carga de cada roda
maximum-couple-that-tilts-the-pair-of-wheels = Binário máximo que inclina o rodeiro
maximum-gyroscopic-couple = Momento giroscópico máximo
maximum-gyroscopic-couple-about-the-vertical = Momento giroscópico máximo, em torno da vertical
maximum-speed-of-the-descending-wheel-half-way-down = Velocidade máxima da roda que desce, a meia descida
left = Esquerda
length-along-the-rail = Comprimento ao longo do trilho
moment-of-inertia = Momento de inércia
moment-of-inertia-of-the-pair-of-wheels-about-its-axle = Momento de inércia do rodeiro em relação ao seu eixo
transverse-moment-of-inertia-of-the-pair-of-wheels = Momento de inércia transversal do rodeiro
pair-of-wheels-on-a-dipping-rail = Rodeiro sobre um trilho com rebaixo
dipping-rail = Trilho com rebaixo
right = Direita
the-wheel-pair-from-behind-and-the-dip-from-the-side-not-to-scale = O rodeiro visto de trás, e a depressão vista de lado (fora de escala)
time-from-beginning-to-end = Tempo do início ao fim
time-to-pass-the-dip = Tempo para passar o rebaixo
track = Bitola
turn = Curva
turn-to = Curva à
wheel-load = Carga da roda
effect = efeito
half-way-down = a meia descida
largest = maior
wheels-at-rest-never-pass-a-dip-of-a-given-length-write-a-speed-above-zero-or-the-time-of-the-dip = rodas paradas nunca passam um rebaixo de dado comprimento: escreva uma velocidade acima de zero, ou o tempo do rebaixo

# rigid-body/edge-mill
acceleration-of-gravity = Aceleração da gravidade
arm = Braço
below = De baixo
carrier = Veículo que leva o rotor
crushing-force-against-the-speed-of-the-shaft = Força de moagem em função da rotação do eixo
crushing-force-of-a-roller-driven-round-on-a-pan-with-its-gyroscopic-component-the-pull-of-the-arm = Força de moagem de um rolo levado em volta sobre um prato, com a parcela giroscópica, a tração do braço e a rotação para uma força desejada.
edge-mill = Moinho de galgas
for-the-slip-at-its-edges-which-does-the-grinding = Para o escorregamento nas bordas, que mói.
force-as-a-multiple-of-the-weight = Força como múltiplo do peso
force-between-roller-and-pan-moments-about-the-hinge = Força entre rolo e prato: momentos em relação à articulação
force-of-a-roller-on-the-pan = Força de um rolo sobre o prato
force-of-all-rollers-on-the-pan = Força de todos os rolos sobre o prato
force-of-one-roller-on-the-pan = Força de um só rolo sobre o prato
from-the-shaft-to-the-middle-of-the-roller = Do eixo ao meio do rolo.
gyroscopic-couple-the-arm-rotates-the-spin-angular-momentum-i-a-at-the-rate = Momento giroscópico: o braço gira o momento angular I_a ω da rotação própria com a velocidade angular Ω
gyroscopic-component-of-the-force = Parcela giroscópica da força
gyroscopic-component-of-the-force-the-pan-exerts-the-couple-about-the-hinge-with-the-lever-arm-r = Parcela giroscópica da força: o prato exerce o binário em relação à articulação com o braço R
mass = Massa
mass-of-a-roller = Massa de um rolo
moment-of-inertia-about-the-axis-from-the-radius-of-gyration = Momento de inércia em relação ao eixo, pelo raio de giração
moment-of-inertia-of-a-solid-roller-about-its-axis = Momento de inércia de um rolo maciço em relação ao seu eixo
moment-of-inertia-of-the-roller-about-its-axis = Momento de inércia do rolo em relação ao seu eixo
number-of-rollers = Número de rolos
pull-of-the-arm = Tração do braço
pull-of-the-arm-which-keeps-the-roller-on-its-circle = Tração do braço, que mantém o rolo na sua circunferência
radius = Raio
radius-of-a-roller = Raio de um rolo
radius-of-gyration = Raio de giração
sliding-at-the-edges-of-the-roller-only-its-middle-rolls-without-slipping = Escorregamento nas bordas do rolo: só o seu meio rola sem escorregar
sliding-speed-at-the-edges = Velocidade de escorregamento nas bordas
solid-disc-or-cylinder = Disco ou cilindro maciço
angular-speed-of-the-roller-about-its-axis = Velocidade angular do rolo em torno do seu eixo
speed-of-the-shaft = Rotação do eixo
speed-of-the-shaft-the-gyroscopic-component-of-the-force-is-i-a-r = Rotação do eixo: a parcela giroscópica da força é I_a Ω²/r
the-roller-rolls-its-centre-moves-at-r-r = O rolo rola: seu centro se move a Ω R = ω r
the-rollers-on-the-pan = Os rolos sobre o prato
vertical-force-of-the-hinge-on-the-arm-positive-upwards-it-holds-the-arm-down = Força vertical da articulação sobre o braço, positiva para cima: ela segura o braço para baixo
vertical-force-of-the-hinge-on-the-arm-upwards = Força vertical da articulação sobre o braço, para cima
required-crushing-force = Força de moagem desejada
weight-of-the-roller = Peso do rolo
width-of-the-roller = Largura do rolo
at-this-speed = nesta rotação
force-of-a-roller = força de um rolo
the-force-at-that-speed-is-the-required-one = a força nessa rotação é a desejada
the-moments-about-the-hinge-from-the-difference-quotient-of-the-angular-momentum = os momentos em relação à articulação pelo quociente de diferenças do momento angular
the-roller-is-so-wide-that-it-reaches-the-shaft = o rolo é tão largo que alcança o eixo
the-required-force-is-below-the-weight-of-the-roller-which-already-acts-at-rest-write-a-larger-one = a força desejada é menor que o peso do rolo, que já pressiona isso em repouso: escreva uma maior
this-speed = esta velocidade
weight = Peso
without-wheels-and-engine = sem rodas e motor

# rigid-body/free-axisymmetric
about-the-axis-relative-to-the-precessing-frame-its-sense-depends-on-the-body = Em torno do eixo, relativa ao referencial que precessiona. O sentido depende do corpo.
about-the-direction-of-the-angular-momentum = Em torno da direção do momento angular.
angle-between-angular-momentum-and-axis = Ângulo entre o momento angular e o eixo
angle-between-angular-velocity-and-angular-momentum-the-half-angle-of-the-space-cone = Ângulo entre a velocidade angular e o momento angular, a semiabertura do cone do espaço
angle-between-angular-velocity-and-axis = Ângulo entre a velocidade angular e o eixo
angle-between-axis-and-angular-momentum = Ângulo entre o eixo e o momento angular
angle-between-axis-and-angular-velocity = Ângulo entre o eixo e a velocidade angular
angle-between-the-axis-and-the-angular-momentum-tan-h-t-h-a-t-r-a = Ângulo entre o eixo e o momento angular: tan θ = H_t/H_a = ω_t/(r ω_a)
angle-between-the-axis-and-the-angular-velocity = Ângulo entre o eixo e a velocidade angular
angle-of-the-precession = Ângulo da precessão
spin-angle-relative-to-the-body-the-angular-velocity-rotates-backwards-by-it = Ângulo da rotação própria; em relação ao corpo, a velocidade angular gira esse ângulo em sentido contrário
angular-momentum-about-the-centre-of-mass = Momento angular em relação ao centro de massa
angular-momentum-about-the-centre-of-mass-which-is-conserved = Momento angular em relação ao centro de massa, que se conserva
transverse-angular-momentum = Momento angular transversal
angular-momentum-and-its-angle-to-the-axis = Momento angular e seu ângulo com o eixo
angular-velocity-about-the-axis = Velocidade angular em torno do eixo
angular-velocity-about-the-axis-h-a-i-a = Velocidade angular em torno do eixo, H_a/I_a
angular-velocity-about-the-axis-i-a-a-h-g-cos-with-h-g-i-t = Velocidade angular em torno do eixo: I_a ω_a = H_G cos θ, com H_G = I_t φ̇
angular-velocity-about-the-axis-from-1-r-a = Velocidade angular em torno do eixo, a partir de ψ̇ = (1 − r) ω_a
transverse-angular-velocity = Velocidade angular transversal
transverse-angular-velocity-h-t-i-t = Velocidade angular transversal, H_t/I_t
transverse-angular-velocity-tan-t-r-a = Velocidade angular transversal: tan θ = ω_t/(r ω_a)
transverse-angular-velocity-the-component-of-the-precession = Velocidade angular transversal: a componente da precessão
angular-velocity-and-its-angle-to-the-axis = Velocidade angular e seu ângulo com o eixo
angular-velocity-at-the-instant-body-axes = Velocidade angular no instante, eixos do corpo
angular-velocity-at-the-start-body-axes = Velocidade angular inicial, eixos do corpo
angular-velocity-in-body-axes = Velocidade angular nos eixos do corpo
at-most-2-for-a-thin-plate-small-for-a-long-rod = No máximo 2, para uma placa fina; pequena para uma haste longa.
attitude-as-a-unit-quaternion-the-product-of-the-rotations-about-h-and-about-the-axis-its-scalar-part = A atitude como quatérnio unitário, o produto das rotações φ em torno de h e ψ em torno do eixo: sua parte escalar
body-cone-about-z-and-space-cone-about-h-in-section-direct-precession = Cone do corpo (em torno de z) e cone do espaço (em torno de H) em corte: precessão direta
body-cone-about-z-and-space-cone-about-h-in-section-retrograde-precession = Cone do corpo (em torno de z) e cone do espaço (em torno de H) em corte: precessão retrógrada
body-of-revolution-in-free-motion = Corpo de revolução em movimento livre
components-of-the-angular-velocity = Componentes da velocidade angular
direction-of-the-angular-momentum-in-the-initial-axes = Direção do momento angular nos eixos iniciais
euler-s-equations-with-zero-moment = as equações de Euler com momento nulo
half-angle-of-the-body-cone = Semiabertura do cone do corpo
half-angle-of-the-body-cone-traced-by-the-angular-velocity-about-the-axis = Semiabertura do cone do corpo, que a velocidade angular descreve em torno do eixo
half-angle-of-the-space-cone-traced-by-the-angular-velocity-about-the-angular-momentum-the-angle = Semiabertura do cone do espaço, que a velocidade angular descreve em torno do momento angular: o ângulo entre os dois
instant = Instante
its-transverse-component = Sua componente transversal
its-component-along-x = Sua componente em x
its-component-along-y = Sua componente em y
its-component-along-z = Sua componente em z
its-rate-of-change = Sua taxa de variação
kinetic-energy-of-rotation-which-is-conserved = Energia cinética de rotação, que se conserva
kinetic-energy-of-rotation-which-is-also-conserved = Energia cinética de rotação, que também se conserva
mass-and-radii-of-gyration = Massa e raios de giração
ratio-of-axial-to-transverse-moment-of-inertia = Razão entre os momentos de inércia axial e transversal
moment-of-inertia-about-the-axis = Momento de inércia em relação ao eixo
moment-of-inertia-about-the-axis-from-its-radius-of-gyration = Momento de inércia em relação ao eixo, por seu raio de giração
precession-and-angle-to-the-angular-momentum = Precessão e ângulo com o momento angular
precession-angle = Ângulo de precessão
precession-of-the-axis-about-the-angular-momentum-h-g-i-t = Precessão do eixo em torno do momento angular, H_G/I_t
precession-revolutions-per-spin-revolution = Voltas de precessão por volta da rotação própria
attitude-quaternion-x-component = Quatérnio de atitude, componente x
attitude-quaternion-y-component = Quatérnio de atitude, componente y
attitude-quaternion-z-component = Quatérnio de atitude, componente z
attitude-quaternion-scalar-part = Quatérnio de atitude, parte escalar
radius-of-gyration-about-the-axis = Raio de giração em torno do eixo
transverse-radius-of-gyration = Raio de giração transversal
ratio-of-the-moments-of-inertia = Razão entre os momentos de inércia
ratio-of-the-moments-of-inertia-above-1-for-a-flat-body-below-1-for-a-long-one = Razão entre os momentos de inércia: acima de 1 para um corpo achatado, abaixo de 1 para um corpo alongado
magnitude-of-the-spin = Módulo da rotação própria
spin-about-the-axis-the-body-is-flat-r-1-retrograde-precession-spin-and-precession-have-opposite = Rotação própria em torno do eixo. O corpo é achatado, r > 1: precessão retrógrada, rotação própria e precessão têm sentidos opostos, e o cone do corpo rola em volta do cone do espaço, que fica dentro dele
spin-about-the-axis-the-body-is-long-r-1-direct-precession-spin-and-precession-have-the-same-sense = Rotação própria em torno do eixo. O corpo é alongado, r < 1: precessão direta, rotação própria e precessão têm o mesmo sentido, e o cone do corpo rola por fora do cone do espaço
spin-about-the-axis-zero-since-with-r-1-all-axes-are-equivalent-and-the-body-rotates-about-its = Rotação própria em torno do eixo: nula, pois com r = 1 todos os eixos são equivalentes e o corpo gira em torno do momento angular
spin-and-angle-to-the-angular-momentum = Rotação própria e ângulo com o momento angular
spin-in-direct-precession = Rotação própria, na precessão direta
spin-in-retrograde-precession = Rotação própria, na precessão retrógrada
the-body-cone-rolls-on-the-space-cone = O cone do corpo rola sobre o cone do espaço
their-ratio-only = Só a razão entre eles
period-of-the-angular-velocity-about-the-axis-relative-to-the-body = Período da velocidade angular em torno do eixo, em relação ao corpo
precession-period = Período de precessão
precession-period-seen-by-a-fixed-observer = Período de precessão, visto por um observador fixo
period-of-the-angular-velocity-about-the-axis = Período da velocidade angular em torno do eixo
torque-free-motion-of-a-body-of-revolution-precession-and-spin-direct-or-retrograde-body-and-space = Movimento de um corpo de revolução livre de momentos: precessão e rotação própria, direta ou retrógrada, cones do corpo e do espaço, velocidade angular e atitude em um instante.
transverse-moment-of-inertia-from-its-radius-of-gyration = Momento de inércia transversal, por seu raio de giração
if-given-the-angular-velocity-and-attitude-at-this-time-after-the-start-are-also-calculated = Se informado, calculam-se também a velocidade angular e a atitude neste tempo após o início.
a-body-whose-moments-of-inertia-are-equal-does-not-spin-about-its-axis-give-the-precession-or-the = um corpo de momentos de inércia iguais não tem rotação própria: informe a precessão ou a velocidade angular
energy = Energia
no-body-has-a-moment-about-its-axis-above-twice-its-transverse-moment-a-thin-plate-has-exactly-twice = nenhum corpo tem momento axial acima do dobro do transversal: uma placa fina tem exatamente o dobro
the-angular-momentum-defines-the-motion-only-together-with-the-moments-of-inertia-give-them-or-the = o momento angular só determina o movimento junto com os momentos de inércia: informe-os, ou a velocidade angular
the-angular-velocity-recomposed-from-precession-and-spin = a velocidade angular recomposta da precessão e da rotação própria
the-attitude-from-its-rate-the-difference-quotient-of-r-compared-with-r = a atitude por sua taxa: o quociente de diferenças de R comparado com ω × R
the-body-does-not-turn-give-an-angular-velocity = o corpo não gira: informe uma velocidade angular
the-same-rotation-by-matrices = a mesma rotação por matrizes

# rigid-body/free-triaxial
along-the-axis = Ao longo do eixo.
angular-momentum-about-the-centre-of-mass-at-the-start-which-is-constant-in-fixed-axes = Momento angular inicial em relação ao centro de massa, constante em eixos fixos
angular-velocity-at-the-instant-fixed-axes = Velocidade angular no instante, eixos fixos
angular-velocity-at-the-instant-principal-axes = Velocidade angular no instante, eixos principais
angular-velocity-at-the-instant-principal-axes-a-cn-a-sn-and-a-dn-with-their-signs = Velocidade angular no instante, eixos principais: A cn τ, A sn τ e A dn τ com seus sinais
angular-velocity-at-the-start-principal-axes = Velocidade angular inicial, eixos principais
angular-velocity-in-principal-axes = Velocidade angular nos eixos principais
angular-velocity-of-the-permanent-rotation = Velocidade angular da rotação permanente
attitude-nutation-from-the-axial-component-of-h-precession-by-the-integral-of-the-third-kind = Atitude: a nutação pela componente de H no eixo, a precessão pela integral de terceira espécie
complete-elliptic-integral-of-the-first-kind-of-this-modulus-by-the-arithmetic-geometric-mean = Integral elíptica completa de primeira espécie deste módulo, pela média aritmético-geométrica
euler-s-equations-with-zero-moment-by-difference-quotients = as equações de Euler com momento nulo, por quocientes de diferenças
free-motion-of-any-body = Movimento livre de um corpo qualquer
growth-of-a-small-disturbance-of-the-rotation-about-axis-the-intermediate-axis-e-t = Crescimento de uma pequena perturbação da rotação em torno de { $axis }, o eixo intermediário, e^(λt)
growth-rate-near-the-intermediate-axis = Taxa de crescimento junto ao eixo intermediário
h-is-parallel-to-the-body-is-in-permanent-rotation-about-a-principal-axis = H é paralelo a ω: o corpo está em rotação permanente em torno de um eixo principal
herpolhode-the-tip-of-the-angular-velocity-seen-along-the-angular-momentum = Herpolódia: a ponta da velocidade angular, vista ao longo do momento angular
homogeneous-box = Paralelepípedo homogêneo
advance-of-the-axis-axis-about-the-angular-momentum-in-one-period-h-i-t-and-an-elliptic-integral-of = Avanço do eixo { $axis } em torno do momento angular em um período: H/I t e uma integral elíptica de terceira espécie
h-2-t-i-with-the-intermediate-moment-asymptotic-motion-along-the-separatrix-from-one-end-of-the = H² = 2 T I com o momento intermediário: movimento assintótico na separatriz, de uma ponta do eixo intermediário à outra, uma só vez, como tanh(p t)
h-2t-is-above-the-intermediate-moment-the-polhode-encircles-axis-the-axis-of-the-largest-moment = H²/2T está acima do momento intermediário: a polódia circunda { $axis }, o eixo do maior momento
h-2t-is-below-the-intermediate-moment-the-polhode-encircles-axis-the-axis-of-the-smallest-moment = H²/2T está abaixo do momento intermediário: a polódia circunda { $axis }, o eixo do menor momento
h-2t-to-be-compared-with-the-intermediate-moment = H²/2T, a comparar com o momento intermediário
its-magnitude = Seu módulo
maximum-component-of-the-angular-velocity-along-x = Componente máxima da velocidade angular em x
maximum-component-of-the-angular-velocity-along-y = Componente máxima da velocidade angular em y
maximum-component-of-the-angular-velocity-along-z = Componente máxima da velocidade angular em z
maximum-axis-from-energy-and-angular-momentum-axis-a-axis-function = Valor máximo de ω_{ $axis }, pela energia e pelo momento angular: ω_{ $axis } = ± A_{ $axis } { $function } τ
moment-of-inertia-about-x = Momento de inércia em relação a x
moment-of-inertia-about-y = Momento de inércia em relação a y
moment-of-inertia-about-z = Momento de inércia em relação a z
rate-of-the-argument-p-t = Taxa do argumento, τ = τ₀ + p t
rate-of-the-elliptic-function-argument = Taxa do argumento das funções elípticas
period-of-the-angular-velocity-in-body-axes-4-k-p = Período da velocidade angular nos eixos do corpo, 4 K/p
period-of-the-angular-velocity-in-body-axes = Período da velocidade angular nos eixos do corpo
poinsot-the-inertia-ellipsoid-rolls-on-the-plane-normal-to-h = Poinsot: o elipsoide de inércia rola sobre o plano normal a H
precession-angle-per-period = Ângulo de precessão por período
mean-precession = Precessão média
principal-axis-x-at-the-instant-fixed-axes = Eixo principal x no instante, eixos fixos
principal-axis-y-at-the-instant-fixed-axes = Eixo principal y no instante, eixos fixos
principal-axis-z-at-the-instant-fixed-axes = Eixo principal z no instante, eixos fixos
principal-moment-of-inertia-from-its-radius-of-gyration = Momento principal de inércia, por seu raio de giração
principal-moment-of-inertia-of-a-homogeneous-box = Momento principal de inércia de um paralelepípedo homogêneo
principal-moments-of-inertia = Momentos principais de inércia
radius-of-gyration-about-x = Raio de giração em relação a x
radius-of-gyration-about-y = Raio de giração em relação a y
radius-of-gyration-about-z = Raio de giração em relação a z
asymptotic-rate-towards-the-intermediate-axis = Taxa de aproximação assintótica ao eixo intermediário
square-of-the-modulus = Quadrado do módulo
square-of-the-modulus-of-the-elliptic-functions = Quadrado do módulo das funções elípticas
the-same-in-fixed-axes-by-the-attitude-of-the-body = A mesma em eixos fixos, pela atitude do corpo
time-between-flips = Tempo entre inversões
time-between-two-sign-changes-along-the-intermediate-axis-flips = Tempo entre duas trocas de sinal no eixo intermediário: inversões
time-until-the-first-flip = Tempo até a primeira inversão
torque-free-motion-of-a-body-with-three-different-moments-of-inertia-by-jacobi-s-elliptic-functions = Movimento livre de momentos de um corpo com três momentos de inércia diferentes pelas funções elípticas de Jacobi: polódia, períodos, inversões em torno do eixo intermediário, velocidade angular e atitude em um instante.
first-time-at-which-the-component-along-the-intermediate-axis-is-zero-sn-0 = Primeiro instante em que a componente no eixo intermediário se anula: sn τ = 0
normal-to-h = normal a H
normal-to-h-and-to-the-first = normal a H e ao primeiro
angular-momentum-in-fixed-axes-a-little-later = o momento angular em eixos fixos um pouco depois
first-flip = primeira inversão
herpolhode = herpolódia
kinetic-energy-a-little-later = a energia cinética um pouco depois
the-triangle-inequality-excludes-a-moment-of-inertia-i-axis-that-is-larger-than-the-sum-of-the-other = a desigualdade triangular exclui um momento de inércia I_{ $axis } maior que a soma dos outros dois: confira os momentos
mean = média
slow = lenta
the-body-rotates-exactly-about-the-axis-of-the-intermediate-moment-where-the-smallest-disturbance = o corpo gira exatamente em torno do eixo do momento intermediário, onde a menor perturbação cresce
the-complete-integral-by-equal-weight-quadrature = a integral completa por quadratura de pesos iguais
the-component-along-the-intermediate-axis-at-that-time = a componente no eixo intermediário nesse instante
the-moment-of-inertia-i-axis-is-out-of-range = o momento de inércia I_{ $axis } está fora da faixa
the-motion-exceeds-the-numerical-range-check-the-magnitudes-of-the-inputs = o movimento excede a faixa numérica: confira as grandezas dos dados
the-motion-is-on-the-separatrix-the-smallest-disturbance-determines-what-follows = o movimento está sobre a separatriz: a menor perturbação determina o que se segue
the-rate-of-the-argument-by-the-numerical-kernel = a taxa do argumento pelo núcleo numérico
the-precession-angle-per-period-by-equal-weight-quadrature = o ângulo de precessão por período, por quadratura de pesos iguais

# rigid-body/gyroscopic-couple
a-frame = Uma estrutura
a-lies-behind-g-for-a-transverse-axle-on-its-right-for-a-vertical-axle-below-negative-where-it-lies = A fica atrás de G; com o eixo transversal ao veículo, à direita; com o eixo vertical, abaixo. Negativa se ficar do outro lado.
seen-from-above-a-turn-to-the-left-is-counter-clockwise-points-up-to-the-right-down = Vista de cima, uma curva à esquerda é anti-horária: Ω aponta para cima; à direita, para baixo
about-an-axis-through-g-transverse-to-the-axle-it-matters-where-the-carrier-turns-about-an-axis-that = Em torno de um eixo por G, transversal ao do rotor. Importa quando o veículo gira em torno de um eixo que não é normal ao do rotor, e nos extremos de um movimento harmônico.
ahead-bow-nose-front = De frente: proa, nariz, dianteira
aircraft = Aeronave
angular-momentum-about-g-due-to-the-spin-and-to-the-rotation-of-the-carrier = Momento angular em relação a G: da rotação própria e do giro do veículo
angular-momentum-of-the-rotor = Momento angular do rotor
angular-momentum-of-the-spin = Momento angular da rotação própria
angular-velocity-of-the-carrier = Velocidade angular do veículo
angular-velocity-of-the-carrier-on-its-curve = Velocidade angular do veículo na curva
pitch-angular-velocity = Velocidade angular de arfagem
angular-velocity-of-the-precession = Velocidade angular da precessão
roll-angular-velocity = Velocidade angular de balanço
any-angular-velocity = Velocidade angular qualquer
b-lies-ahead-of-g-on-its-left-or-above = B fica à frente de G; à esquerda, ou acima.
bearings = Mancais
behind-stern-tail-rear = De trás: popa, cauda, traseira
bow-or-nose = Proa ou nariz
bow-or-nose-in-the-middle-of-the-oscillation = Proa ou nariz, no meio da oscilação
angular-frequency-of-the-harmonic-motion = Frequência angular do movimento harmônico
clockwise = horário
components-forward-to-the-left-and-up = Componentes para a frente, para a esquerda e para cima.
counter-clockwise = anti-horário
couple-on-the-rotor = Binário sobre o rotor
couple-on-the-rotor-forward-left-up = Binário sobre o rotor (frente, esquerda, cima)
couple-on-the-rotor-the-components-of-h-are-constant-in-axes-that-turn-with-the-carrier-so-dh-dt-h = Binário sobre o rotor: as componentes de H são constantes nos eixos que giram com o veículo, logo dH/dt = Ω × H
couple-that-accelerates-and-decelerates-the-rotor-with-its-carrier-maximum-where-the-gyroscopic = Binário que acelera e freia o rotor junto com o veículo, máximo onde o giroscópico é nulo
distance-of-g-from-the-support = Distância de G ao apoio
distance-of-bearing-a-from-g = Distância do mancal A a G
distance-of-bearing-b-from-g = Distância do mancal B a G
effect-on-the-carrier = Efeito sobre o veículo
effect-heels-the-ship-to-port = Efeito: aderna o navio para bombordo
effect-heels-the-ship-to-starboard = Efeito: aderna o navio para boreste
effect-lowers-the-bow-and-raises-the-stern = Efeito: abaixa a proa e levanta a popa
effect-lowers-the-left-wing-and-raises-the-right-one = Efeito: abaixa a asa esquerda e levanta a direita
effect-lowers-the-nose-and-raises-the-tail = Efeito: abaixa o nariz e levanta a cauda
effect-lowers-the-right-wing-and-raises-the-left-one = Efeito: abaixa a asa direita e levanta a esquerda
effect-loads-the-front-wheels-and-unloads-the-rear-wheels = Efeito: carrega as rodas dianteiras e alivia as traseiras
effect-loads-the-left-wheels-and-unloads-the-right-wheels = Efeito: carrega as rodas esquerdas e alivia as direitas
effect-loads-the-rear-wheels-and-unloads-the-front-wheels = Efeito: carrega as rodas traseiras e alivia as dianteiras
effect-loads-the-right-wheels-and-unloads-the-left-wheels = Efeito: carrega as rodas direitas e alivia as esquerdas
effect-raises-the-bow-and-lowers-the-stern = Efeito: levanta a proa e abaixa a popa
effect-raises-the-nose-and-lowers-the-tail = Efeito: levanta o nariz e abaixa a cauda
effect-tips-the-frame-backward = Efeito: tomba a estrutura para trás
effect-tips-the-frame-forward = Efeito: tomba a estrutura para a frente
effect-tips-the-frame-to-the-left = Efeito: tomba a estrutura para a esquerda
effect-tips-the-frame-to-the-right = Efeito: tomba a estrutura para a direita
effect-turns-the-bow-to-port-and-the-stern-to-starboard = Efeito: vira a proa para bombordo e a popa para boreste
effect-turns-the-bow-to-starboard-and-the-stern-to-port = Efeito: vira a proa para boreste e a popa para bombordo
effect-turns-the-frame-to-the-left = Efeito: vira a estrutura para a esquerda
effect-turns-the-frame-to-the-right = Efeito: vira a estrutura para a direita
effect-turns-the-front-to-the-left = Efeito: vira a dianteira para a esquerda
effect-turns-the-front-to-the-right = Efeito: vira a dianteira para a direita
effect-turns-the-nose-to-the-left-and-the-tail-to-the-right = Efeito: vira o nariz para a esquerda e a cauda para a direita
effect-turns-the-nose-to-the-right-and-the-tail-to-the-left = Efeito: vira o nariz para a direita e a cauda para a esquerda
falling = Descendo
force-of-bearing-a-on-the-rotor-forward-left-up = Força do mancal A sobre o rotor (frente, esquerda, cima)
force-of-bearing-b-on-the-rotor-forward-left-up = Força do mancal B sobre o rotor (frente, esquerda, cima)
transverse-force-on-the-rotor-against-the-weight-and-towards-the-centre-of-the-curve = Força transversal sobre o rotor: contra o peso, e para o centro da curva
gyroscopic-couple-on-a-ship-an-aircraft-or-a-vehicle = Momento giroscópico em navio, aeronave ou veículo
gyroscopic-couple-over-two-oscillations-from-the-middle-of-the-first = Momento giroscópico em duas oscilações, a partir do meio da primeira
half-of-the-total-oscillation = Metade da oscilação total.
maximum-angular-acceleration-of-the-carrier = Aceleração angular máxima do veículo
maximum-angular-acceleration-at-the-ends-of-the-oscillation = Aceleração angular máxima, nos extremos da oscilação
maximum-angular-velocity-in-the-middle-of-the-oscillation = Velocidade angular máxima, no meio da oscilação
maximum-inertia-couple-at-the-ends-of-the-oscillation = Binário de inércia máximo, nos extremos da oscilação
left-port = Esquerda, bombordo
level-axle-supported-at-one-end-precession-due-to-the-weight = Eixo nivelado apoiado em uma ponta: precessão devida ao peso
mass-and-radius-of-gyration = Massa e raio de giração
moment-of-inertia-about-the-axle = Momento de inércia em relação ao eixo do rotor
moment-of-inertia-about-the-axle-from-the-radius-of-gyration = Momento de inércia em relação ao eixo do rotor, pelo raio de giração
moment-of-inertia-of-a-disc-about-its-axle = Momento de inércia de um disco em relação ao seu eixo
moment-of-the-weight-about-the-support = Momento do peso em relação ao apoio
the-moment-of-the-weight-about-the-support = o momento do peso em relação ao apoio
moments-about-bearing-a-the-bearing-forces-produce-the-couple-m-about-g = Momentos em relação ao mancal A: as forças dos mancais produzem o binário M em relação a G
motion-of-the-carrier = Movimento do veículo
on-the-side-of-the-spin-vector-by-the-right-hand-rule-negative-on-the-other-side = Do lado para onde aponta o vetor da rotação própria, pela regra da mão direita; negativa do outro lado.
required-only-for-the-bearings-and-the-weight = Necessária só para os mancais e o peso.
pitching-at-a-given-rate = Arfagem com velocidade angular dada
pitching-in-simple-harmonic-motion = Arfagem em movimento harmônico simples
precession = Precessão
radius-of-gyration-about-the-axle = Raio de giração em relação ao eixo do rotor
radius-of-the-turn = Raio da curva
reaction-couple-on-the-carrier-forward-left-up = Binário de reação sobre o veículo (frente, esquerda, cima)
reaction-of-the-rotor-on-its-carrier-equal-and-opposite = Reação do rotor sobre o veículo: igual e oposta
right-starboard = Direita, boreste
rising = Subindo
rolling-at-a-given-rate = Balanço com velocidade angular dada
rolling-in-simple-harmonic-motion = Balanço em movimento harmônico simples
rotor = Rotor
seen-from = Visto
sense = Sentido
sense-of-the-rotor = Sentido do rotor
ship = Navio
descending-side = Lado que desce
descending-side-at-mid-position = Lado que desce, na posição média
magnitude-of-the-angular-velocity-of-the-carrier = Módulo da velocidade angular do veículo
speed-of-the-rotor = Rotação do rotor
steady-turn = Curva em regime permanente
the-axle-precesses-about-the-vertical-through-its-support = O eixo precessiona em torno da vertical do apoio
when-the-bow-rises-points-to-the-right-when-it-falls-to-the-left = Quando a proa sobe, Ω aponta para a direita; quando desce, para a esquerda
the-couple-rotates-h-at-the-precession-rate-m-i-a-p = O binário gira H com a velocidade angular da precessão: M = I_a ω ω_p
the-forces-of-both-bearings-add-up-to-p = As forças dos dois mancais somam P
the-left-hand-side-port = Da esquerda, bombordo
when-the-right-hand-side-descends-points-forward-when-the-left-hand-side-descends-backward = Quando o lado direito desce, Ω aponta para a frente; quando o esquerdo desce, para trás
the-right-hand-side-starboard = Da direita, boreste
the-rotor-its-rotations-and-the-couple = O rotor, suas rotações e o binário
thin-disc = Disco fino
transverse-moment-of-inertia-of-the-rotor = Momento de inércia transversal do rotor
unit-vector-of-the-axle-from-bearing-a-to-bearing-b = Vetor unitário do eixo do mancal A ao mancal B
unit-vector-of-the-spin-away-from-the-viewer-if-clockwise-towards-the-viewer-if-counter-clockwise = Vetor unitário da rotação própria: afasta-se do observador se horária, aponta para ele se anti-horária
vehicle = Veículo
vertical-reaction-at-a-positive-upwards = Reação vertical em A, positiva para cima
vertical-reaction-at-a-upwards = Reação vertical em A, para cima
vertical-reaction-at-b-positive-upwards = Reação vertical em B, positiva para cima
vertical-reaction-at-b-upwards = Reação vertical em B, para cima
position-of-the-viewer-who-looks-along-the-axle-and-sees-that-sense = Posição do observador que olha ao longo do eixo do rotor e vê esse sentido.
a-rotor-without-spin-falls-and-does-not-precess-write-a-speed-above-zero = um rotor sem rotação própria cai e não precessiona: escreva uma velocidade acima de zero
an-axle-held-at-one-end-has-no-two-bearings-leave-the-bearings-out = um eixo apoiado em uma ponta não tem dois mancais: deixe os mancais de fora
a-vertical-axle-needs-no-couple-to-remain-vertical-choose-a-viewpoint-from-which-the-axle-is = um eixo vertical não precisa de binário para permanecer vertical: escolha um ponto de vista em que o eixo fique horizontal
bearing-b-does-not-lie-ahead-of-bearing-a-the-sum-of-their-distances-from-g-must-be-above-zero = o mancal B não fica à frente do mancal A: a soma das suas distâncias a G deve ser maior que zero
here = aqui
the-bearings-also-carry-the-weight-of-the-rotor-write-its-mass-or-0-kg-for-the-contribution-of-the = os mancais também suportam o peso do rotor: escreva a massa, ou 0 kg para a contribuição do binário sozinho
the-carrier-does-not-turn-about-an-axis-normal-to-the-axle-or-the-rotor-is-at-rest-there-is-no = o veículo não gira em torno de um eixo normal ao do rotor, ou o rotor está parado: não há momento giroscópico, nem efeito
the-carrier-turns-about-an-axis-that-is-not-normal-to-the-axle-without-the-transverse-moment-of = o veículo gira em torno de um eixo que não é normal ao do rotor: sem o momento de inércia transversal falta ao binário o termo (I_a − I_t) Ω² sen θ cos θ
the-moments-of-the-bearing-forces-about-g-make-up-the-couple = os momentos das forças dos mancais em relação a G compõem o binário
the-weight-makes-the-axle-precess-write-the-mass-of-the-rotor = o peso faz o eixo precessionar: escreva a massa do rotor
this-turn = esta curva

# rigid-body/heavy-top
about-the-axis-and-about-the-fixed-point = Em relação ao eixo e ao ponto fixo
about-the-axis-and-about-the-centre-of-mass = Em relação ao eixo e ao centro de massa
about-the-axis-only-a-top-that-spins-fast = Só em relação ao eixo: pião rápido
angle-of-the-axis-to-the-vertical = Ângulo do eixo com a vertical
angular-frequency-of-small-nutations = Frequência angular das pequenas nutações
angular-frequency-of-small-nutations-about-this-motion-the-second-derivative-of-the-effective = Frequência angular das pequenas nutações em torno deste movimento: a segunda derivada do potencial efetivo
angular-momentum-about-the-axis = Momento angular em torno do eixo
angular-velocity-about-the-axis-in-fast-precession = Velocidade angular em torno do eixo na precessão rápida
angular-velocity-about-the-axis-spin-plus-the-component-of-the-precession = Velocidade angular em torno do eixo: rotação própria mais a componente da precessão
relative-to-the-frame-that-precesses-with-the-axis = Relativa ao referencial que precessiona com o eixo.
discriminant-of-the-quadratic = Discriminante da equação do segundo grau
distance-of-the-centre-of-mass-from-the-fixed-point = Distância do centro de massa ao ponto fixo
error-of-the-formula-for-fast-tops = Erro da fórmula do pião rápido
fast-precession = Precessão rápida
fast-precession-the-other-root = Precessão rápida: a outra raiz
formula-for-fast-tops-the-moment-k-sin-rotates-the-component-i-a-sin-of-the-angular-momentum-normal = Fórmula do pião rápido: o momento K sen θ gira a componente I_a ψ̇ sen θ do momento angular, normal à vertical; o ângulo se cancela
from-the-upward-vertical-90-with-the-axis-level-more-for-a-hanging-top = A partir da vertical para cima: 90° com o eixo na horizontal, mais para um pião pendurado.
heavy-top-steady-precession = Pião: precessão estacionária
its-angular-momentum-about-the-axis = Seu momento angular em torno do eixo
its-root-with-the-sign-of-h = Sua raiz, com o sinal de H
minimum-angular-velocity-about-the-axis-with-which-the-top-stays-upright-a-sleeping-top = Velocidade angular mínima em torno do eixo com que o pião fica em pé: pião adormecido
minimum-rate-for-a-steady-precession = Rotação mínima para uma precessão estacionária
minimum-rate-for-a-steady-precession-at-this-angle-the-discriminant-h-4-a-k-is-zero = Rotação mínima para uma precessão estacionária neste ângulo: o discriminante H² − 4 A K é nulo
minimum-of-a-sleeping-top = Valor mínimo de ω₃ de um pião adormecido
moment-of-the-weight-about-the-fixed-point-with-the-axis-level-at-the-angle-it-is-k-sin = Momento do peso em relação ao ponto fixo com o eixo na horizontal; no ângulo θ ele é K sen θ
precession-against-spin-at-this-angle = Precessão em função da rotação própria, neste ângulo
precession-by-the-fast-top-formula = Precessão pela fórmula do pião rápido
slow-and-fast-precession-of-a-top-under-its-weight-the-required-spin-the-sleeping-threshold-and-the = Precessão lenta e rápida de um pião sob seu peso, a rotação própria necessária, o limiar do pião adormecido e a fórmula do pião rápido comparada com a exata.
slow-precession = Precessão lenta
slow-precession-the-root-that-stays-finite-when-a-vanishes = Precessão lenta: a raiz que permanece finita quando A se anula
spin-plus-the-axial-component-of-the-precession-cos-constant-for-any-motion-of-the-axis = Rotação própria mais a componente axial da precessão, ψ̇ + φ̇ cos θ: constante em qualquer movimento do eixo.
spin-for-this-precession = Rotação própria para esta precessão
spin-for-this-precession-by-the-fast-top-formula = Rotação própria para esta precessão, pela fórmula do pião rápido
spin-in-slow-precession = Rotação própria na precessão lenta
spin-in-slow-precession-less-the-axial-component-of-the-precession = Rotação própria na precessão lenta: ω₃ menos a componente axial da precessão
spin-relative-to-the-precessing-axis = Rotação própria, em relação ao eixo que precessa
spin-that-maintains-this-precession-m-h-solved-for-it = Rotação própria que mantém esta precessão: ΣM = Ω × H resolvida para ela
spin-of-the-top = rotação própria do pião
steady-precession-a-h-k-0-with-a-i-t-i-a-cos-and-h-i-a = Precessão estacionária: A φ̇² − H φ̇ + K = 0, com A = (I_t − I_a) cos θ e H = I_a ψ̇
steady-precession-a-h-k-0-with-a-i-t-cos-and-h-i-a = Precessão estacionária: A φ̇² − H φ̇ + K = 0, com A = I_t cos θ e H = I_a ω₃
the-required-precession = A precessão desejada
the-top = O pião
the-top-in-steady-precession = O pião em precessão estacionária
time-for-one-revolution-of-the-axis-about-the-vertical = Tempo de uma volta do eixo em torno da vertical
transverse-moment-of-inertia-about-the-fixed-point = Momento de inércia transversal em relação ao ponto fixo
transverse-moment-of-inertia-about-the-fixed-point-parallel-axis-theorem = Momento de inércia transversal em relação ao ponto fixo: teorema dos eixos paralelos
transverse-moment-of-inertia-about-the-centre-of-mass = Momento de inércia transversal em relação ao centro de massa
transverse-radius-of-gyration-about-the-fixed-point = Raio de giração transversal em relação ao ponto fixo
relative-error-of-the-fast-top-formula = Erro relativo da fórmula do pião rápido
a-top-that-does-not-spin-has-no-steady-precession-it-falls-give-a-spin = um pião sem rotação própria não tem precessão estacionária: ele cai; informe uma rotação
a-top-whose-axis-does-not-precess-falls-the-precession-must-not-be-zero = um pião cujo eixo não precessiona cai: a precessão não pode ser nula
angle-to-the-vertical = Ângulo com a vertical
effective-potential = potencial efetivo
fast = rápida
fast-top-formula = fórmula do pião rápido
the-moment-of-the-weight-from-the-motion-of-the-tip-of-h = o momento do peso pelo movimento da ponta de H
the-moment-of-the-weight-from-the-whole-h-about-the-fixed-point = o momento do peso por todo o Ω × H em relação ao ponto fixo
the-root-substituted-into-the-quadratic = a raiz substituída na equação do segundo grau
the-top-is-not-fast-the-error-of-the-fast-top-formula-is-error = o pião não é rápido: o erro da fórmula do pião rápido é { $error }
the-top-is-too-slow-for-a-steady-precession-at-this-angle-its-spin-must-be-at-least-least = o pião é lento demais para uma precessão estacionária neste ângulo: sua rotação própria deve ser no mínimo { $least }
the-top-is-too-slow-for-a-steady-precession-at-this-angle-must-be-at-least-least = o pião é lento demais para uma precessão estacionária neste ângulo: ω₃ deve ser no mínimo { $least }
this-top = este pião
too-slow = lento demais
without-the-transverse-moment-of-inertia-only-the-fast-top-formula-can-be-used = sem o momento de inércia transversal só se pode usar a fórmula do pião rápido

# rigid-body/motion
a-body-that-rotates-freely-about-a-fixed-point-under-gravity-or-under-torques-attitude-and-angular = Um corpo que gira livremente, em torno de um ponto fixo sob a gravidade, ou sob torques: atitude e velocidade angular ao longo do tempo, com o desvio da energia e do momento angular.
a-component-of-the-angular-velocity-changes-its-sign = Uma componente da velocidade angular muda de sinal
a-fixed-point = Um ponto fixo
about-its-axis-z = Em torno do seu eixo z
about-x = Em torno de x
about-y = Em torno de y
about-z = Em torno de z
acceleration-of-gravity-along-z = Aceleração da gravidade, no sentido de −Z
acceleration-of-the-centre-of-mass-at-the-start = Aceleração do centro de massa no início
acceleration-of-the-centre-of-mass-at-the-start-r-r-in-body-axes = Aceleração do centro de massa no início: α × r + ω × (ω × r), nos eixos do corpo
transverse-to-its-axis = Transversal ao seu eixo
angle-to-z = Ângulo com Z
angular-acceleration-at-the-start-body-axes = Aceleração angular no início, eixos do corpo
angular-acceleration-at-the-start-from-euler-s-equations-m-j-j-in-body-axes = Aceleração angular no início, pelas equações de Euler M = J α + ω × (J ω), nos eixos do corpo
angular-frequency = Frequência angular
angular-momentum-about-the-point-at-the-end-in-the-fixed-axes = Momento angular em relação ao ponto no fim, nos eixos fixos
angular-momentum-about-the-point-at-the-start-h-j = Momento angular em relação ao ponto no início: H = J ω
angular-momentum-at-the-end-fixed-axes = Momento angular no fim, eixos fixos
angular-momentum-at-the-start-body-axes = Momento angular no início, eixos do corpo
angular-momentum-conserved-to-within = Momento angular conservado a menos de
angular-velocity-at-the-end-body-axes = Velocidade angular no fim, eixos do corpo
angular-velocity-at-the-end-fixed-axes = Velocidade angular no fim, eixos fixos
angular-velocity-at-the-end-in-body-axes = Velocidade angular no fim, nos eixos do corpo
angular-velocity-at-the-end-in-the-fixed-axes = Velocidade angular no fim, nos eixos fixos
angular-velocity-at-the-start = Velocidade angular inicial
angular-velocity-at-the-start-in-body-axes = Velocidade angular no início, nos eixos do corpo
angular-velocity-in-the-fixed-axes = Velocidade angular nos eixos fixos
aligned-with-the-fixed-axes = Alinhada com os eixos fixos
attitude-a-unit-quaternion-and-angular-momentum-are-integrated-by-the-dormand-prince-method-of-order = A atitude (um quatérnio unitário) e o momento angular são integrados pelo método de Dormand–Prince de ordem 8, com controle de passo; para um corpo de revolução, em eixos que não giram com ele
attitude-at-the-end-as-a-unit-quaternion-its-real-part = Atitude no fim como quatérnio unitário: sua parte real
attitude-at-the-end-unit-quaternion-real-part = Atitude no fim, quatérnio unitário, parte real
attitude-at-the-end-unit-quaternion-the-other-parts = Atitude no fim, quatérnio unitário, as outras partes
attitude-at-the-start = Atitude no início
axis-of-any-length = Eixo, de qualquer comprimento
tracked-axis-of-the-body = Eixo do corpo a acompanhar
body-of-revolution-about-z = Corpo de revolução em torno de z
bound-on-h-m-dt-h-over-the-motion-relative-to-the-maximum-h = Limite de |H − ∫M dt − H₀| no movimento, em relação ao máximo |H|
bound-on-h-z-m-z-dt-h-z0-over-the-motion-relative-to-the-maximum-h-the-weight-has-no-moment-about-the = Limite de |H_Z − ∫M_Z dt − H_Z0| no movimento, em relação ao máximo |H|: o peso não tem momento em relação à vertical
bound-on-t-v-w-e-over-the-motion-relative-to-the-maximum-energy = Limite de |T + V − W − E₀| no movimento, em relação à energia máxima
component-in-the-axes-of-the-body = Componente nos eixos do corpo
constant = Constante
direction-of-the-axis-at-the-end = Direção do eixo no fim
direction-of-the-tracked-axis-of-the-body-at-the-end = Direção do eixo acompanhado do corpo no fim
drift-of-energy-and-angular-momentum = Desvio da energia e do momento angular
duration = Duração
energy-and-angular-momentum-are-not-conserved-to-nine-digits-the-last-digits-of-the-motion-are = a energia e o momento angular não se conservam com nove algarismos: os últimos algarismos do movimento são duvidosos
energy-at-the-start = Energia inicial
energy-conserved-to-within = Energia conservada a menos de
euler-s-angles = Ângulos de Euler
euler-s-equations-at-the-start = as equações de Euler no início
factor = Fator
for-an-attitude-given-by-euler-angles = Para uma atitude dada em ângulos de Euler.
harmonic = Harmônico
horizon = horizonte
in-free-flight-or-supported-there-the-weight-has-no-moment = Em voo livre, ou apoiado nele; o peso não tem momento.
in-body-axes = Nos eixos do corpo
in-the-fixed-axes = Nos eixos fixos
direction-fixed-in = Direção fixa
its-time-history = Sua evolução no tempo
kinetic = Cinética
kinetic-energy-at-the-end = Energia cinética no fim
kinetic-energy-of-rotation-at-the-end = Energia cinética da rotação no fim
kinetic-energy-of-rotation-at-the-start-t-h-2 = Energia cinética da rotação no início: T = ω · H/2
maximum-angle-of-the-axis-to-the-vertical-z-over-the-motion = Ângulo máximo do eixo com a vertical Z no movimento
maximum-angle-of-the-axis-to-z = Ângulo máximo do eixo com Z
minimum-angle-of-the-axis-to-the-vertical-z-over-the-motion = Ângulo mínimo do eixo com a vertical Z no movimento
minimum-angle-of-the-axis-to-z = Ângulo mínimo do eixo com Z
centre-of-mass-at-the-end-fixed-axes = Centro de massa no fim, eixos fixos
centre-of-mass-at-the-end-from-the-fixed-point = Centro de massa no fim, a partir do ponto fixo
centre-of-mass-from-the-fixed-point-in-body-axes = Centro de massa, a partir do ponto fixo, nos eixos do corpo
moment-of-weight-and-torques-about-the-point-at-the-start-in-body-axes = Momento do peso e dos torques em relação ao ponto no início, nos eixos do corpo
moments-and-products-of-inertia = Momentos e produtos de inércia
motion-of-a-rigid-body-in-space = Movimento de um corpo rígido no espaço
nothing = Nada
parallel-axis-theorem-the-moment-of-inertia-about-the-fixed-point-is-larger-by-m-d-transverse-to-the = Teorema dos eixos paralelos: o momento de inércia em relação ao ponto fixo é maior em m d² transversalmente à linha do centro de massa, e o mesmo ao longo dela
relative-to-the-maximum = relativo ao máximo
phase = Fase
potential = Potencial
potential-energy-at-the-start-relative-to-the-level-of-the-fixed-point = Energia potencial no início, em relação ao nível do ponto fixo
precession-about-z-nutation-about-the-new-x-spin-about-the-new-z = Precessão em torno de Z, nutação em torno do novo x, rotação própria em torno do novo z.
principal-axes = Eixos principais
product-xy-dm = Produto ∫xy dm
product-yz-dm = Produto ∫yz dm
product-zx-dm = Produto ∫zx dm
euler-angle-rates = Taxas dos ângulos de Euler
row-of-the-inertia-tensor-about-the-point-j-j-g-m-r-1-r-r = Linha do tensor de inércia em relação ao ponto: J = J_G + m (r² 1 − r rᵀ)
space = No espaço
table = Tabela
the-attitude-at-the-end-by-the-dormand-prince-method = a atitude no fim pelo método de Dormand–Prince
the-axis-of-the-attitude-has-no-length-give-any-vector-along-it = o eixo da atitude não tem comprimento; dê qualquer vetor ao longo dele
the-axis-reaches-an-angle-to-z = O eixo atinge um ângulo com Z
the-balance-of-angular-momentum-over-the-motion = o balanço do momento angular no movimento
the-body-rotates-about = O corpo gira em torno de
the-energy-balance-t-v-w-over-the-motion = o balanço de energia T + V − W ao longo do movimento
the-fixed-point = O ponto fixo
the-moment-of-inertia-of-the-mass-about-the-fixed-point-exceeds-the-numerical-range = o momento de inércia da massa em relação ao ponto fixo excede a faixa numérica
the-moments-of-inertia-are-about = Os momentos de inércia são em relação a
the-momentum-in-the-body-follows-h-by-the-gauss-method-of-order-6-which-keeps-energy-and-h-the = O momento angular no corpo segue Ḣ = H × ω pelo método de Gauss de ordem 6, que conserva a energia e |H|; a atitude segue por exponenciais da velocidade angular média
the-motion-requires-too-many-steps-the-body-makes-too-many-revolutions-in-this-duration-make-it = o movimento exige passos demais: o corpo dá voltas demais nesta duração; encurte-a
the-motion-cannot-be-integrated-with-these-values-they-are-too-large-or-too-small-relative-to-each = o movimento não pode ser integrado com estes valores: são grandes ou pequenos demais uns em relação aos outros
the-motion-does-not-come-to-its-end-within-the-duration-make-this-longer = o movimento não chega ao seu fim dentro da duração; aumente-a
the-other-three-components-of-that-quaternion = As outras três componentes desse quatérnio
the-euler-angle-rates-need-an-attitude-in-euler-angles-give-it-so-or-give-the-angular-velocity-as-a = as taxas dos ângulos de Euler exigem uma atitude em ângulos de Euler; dê-a assim, ou dê a velocidade angular como vetor
the-torque-times-a-factor-linearly-interpolated-between-the-times = O torque vezes um fator, com interpolação linear entre os instantes.
the-torque-times-sin-t = O torque vezes sen(Ω t + φ).
the-rotating-body = O corpo em rotação
the-upward-vertical-at-the-start-in-the-axes-of-the-body = A vertical para cima no início, nos eixos do corpo
these-are-not-the-moments-of-inertia-of-a-body-the-principal-moments-must-all-be-positive-correct-the = estes não são os momentos de inércia de um corpo: os momentos principais devem ser todos positivos; corrija os momentos ou os produtos de inércia
time-at-the-end = Tempo no fim
times-and-factors = Instantes e fatores
torque-about-the-point-of-rotation = Torque em relação ao ponto de rotação
torques = Torques
trace-of-the-axis-axis-on-the-unit-sphere-seen-from-above = Traço do eixo { $axis } na esfera unitária, visto de cima
what-ends-the-motion-before = O que encerra o movimento antes
early-stop-condition = Condição de parada antecipada
work-done = Trabalho realizado
mass-of-the-body-as-described = Massa do corpo tal como foi descrito
centre-of-mass-of-the-body-as-described-from-its-origin = Centro de massa do corpo tal como foi descrito, a partir da sua origem
the-origin-of-its-description = A origem da sua descrição
for-a-body-that-is-defined-as-a-whole = Para um corpo definido por inteiro.
body-defined-as-a-whole = Corpo definido por inteiro
it-rotates-about-its-centre-of-mass-or-about-the-origin-of-its-description = Gira em torno do seu centro de massa ou da origem da sua descrição.
body = Corpo
a-body-defined-as-a-whole-includes-its-mass-and-its-centre-of-mass-let-it-rotate-about-the-origin-of = um corpo definido por inteiro já inclui sua massa e seu centro de massa; faça-o girar em torno da origem da sua descrição ou do seu centro de massa
only-a-body-defined-as-a-whole-has-an-origin-let-the-body-turn-about-a-fixed-point-and-give-its-mass = só um corpo definido por inteiro tem uma origem; faça o corpo girar em torno de um ponto fixo e dê sua massa e seu centro de massa

# rigid-body/rolling-cone
cone-rolling-on-a-plane-about-its-apex = Cone que rola em um plano em torno do seu vértice
angular-velocity-angular-momentum-and-kinetic-energy-of-a-cone-that-rolls-about-its-apex-position-of = Velocidade angular, momento angular e energia cinética de um cone que rola em torno do seu vértice, posição da força normal, atrito necessário e a precessão em que tomba.
a-thin-shell-without-a-base = Casca fina sem base
angular-momentum-about-the-apex = Momento angular em relação ao vértice
angular-momentum-about-the-apex-for-along-x-axial-i-a-a-transverse-i-t-t = Momento angular em relação ao vértice, para ω em +x: axial I_a ω_a, transversal I_t ω_t
angular-velocity-of-the-cone = Velocidade angular do cone
angular-velocity-of-the-cone-along-the-line-of-contact = Velocidade angular do cone, ao longo da linha de contato
angular-velocity-of-the-line-of-contact = Velocidade angular da linha de contato
coefficient-of-friction-required-for-this-motion-with-only-friction-at-the-apex = Coeficiente de atrito necessário para este movimento, só com atrito no vértice
transverse-component-of = Componente transversal de ω
component-of-along-the-axis-of-the-cone = Componente de ω ao longo do eixo do cone
couple-divided-by-the-square-of-the-precession-rate-i-a-cos-i-t-sin-cot = Binário dividido pelo quadrado da precessão: |Ḣ|/φ̇² = (I_a cos² α + I_t sin² α) cot α
distance-from-the-apex = distância do vértice
edge-of-the-base = borda da base
half-the-angle-at-the-apex = Metade do ângulo no vértice
horizontal-force-on-the-cone-towards-the-vertical-through-the-apex = Força horizontal sobre o cone, dirigida ao eixo vertical que passa pelo vértice
horizontal-force-towards-the-axis = Força horizontal para o eixo
kinetic-energy-the-apex-is-at-rest = Energia cinética: o vértice está em repouso
length-of-the-line-of-contact = Comprimento da linha de contato
centre-of-mass-along-the-line-of-contact = Centro de massa, ao longo da linha de contato
centre-of-mass-from-the-apex-on-the-axis = Centro de massa a partir do vértice, no eixo
centre-of-mass-of-a-conical-shell-from-the-apex = Centro de massa de uma casca cônica, a partir do vértice
centre-of-mass-of-a-solid-cone-from-the-apex = Centro de massa de um cone maciço, a partir do vértice
transverse-moment-of-inertia-about-the-apex = Momento de inércia transversal, em relação ao vértice
moment-of-inertia-of-a-conical-shell-about-its-axis = Momento de inércia de uma casca cônica em relação ao seu eixo
transverse-moment-of-inertia-of-a-conical-shell-about-the-apex = Momento de inércia transversal de uma casca cônica, em relação ao vértice
moment-of-inertia-of-a-solid-cone-about-its-axis = Momento de inércia de um cone maciço em relação ao seu eixo
transverse-moment-of-inertia-of-a-solid-cone-about-the-apex = Momento de inércia transversal de um cone maciço, em relação ao vértice
normal-force = Força normal
total-normal-force-of-the-plane = Força normal total do plano
precession-at-tipping = Precessão no limite de tombamento
precession-at-which-the-normal-force-reaches-the-edge-of-the-base-x-n-s-above-it-the-apex-would-lift = Precessão em que a força normal atinge a borda da base, x_N = s: acima dela o vértice se levantaria
rate-of-change-h-is-constant-in-axes-rotating-with-the-line-of-contact-so-h-with-k = Taxa de variação: nos eixos que giram com a linha de contato H é constante, logo Ω × H com Ω = −φ̇ k
rate-of-change-of-the-angular-momentum = Taxa de variação do momento angular
properties-given = Propriedades dadas
solid = Maciça
    .rolling-cone = Maciço
the-couple-from-its-coefficient-of = o binário pelo seu coeficiente de φ̇²
the-kinetic-energy-in-closed-form-3-m-h-1-5-cos-40 = a energia cinética em forma fechada, 3 m h² φ̇² (1 + 5 cos² α)/40
the-line-of-contact-is-at-rest-lies-along-it-and-the-centre-of-mass-moves-with-l-cos-l-sin = A linha de contato está em repouso: ω está ao longo dela, e o centro de massa se move com φ̇ l cos α = ω l sin α
the-line-of-contact-is-at-rest-the-centre-of-mass-moves-with-l-cos-l-sin = A linha de contato está em repouso: o centro de massa se move com φ̇ l cos α = ω l sin α
the-normal-force-would-have-to-act-beyond-the-base-the-cone-tips-about-its-edge-and-cannot-roll-in = a força normal teria de atuar além da base: o cone tomba sobre a borda e não pode rolar desse modo
the-rate-from-the-difference-quotient-of-j-with-the-tensor-rotated = a taxa pelo quociente de diferenças de J ω, com o tensor girado
the-rolling-cone = O cone que rola
position-of-the-normal-force = Posição da força normal
distance-of-the-normal-force-from-the-apex = Distância da força normal ao vértice
distance-of-the-normal-force-from-the-apex-moments-about-y-m-g-x-g-n-x-n-y = Distância da força normal ao vértice: momentos em relação a y, m g x_G − N x_N = Ḣ_y

# rigid-body/rolling-motion
motion-of-a-rolling-disc-or-coin = Movimento de um disco ou moeda que rola
contact-path-angle-normal-force-and-friction-against-time-for-a-disc-hoop-or-coin-rolling-without = Trajetória do contato, ângulo, força normal e atrito em função do tempo de um disco, aro ou moeda que rola sem deslizar, até deitar, perder o contato ou deslizar.
angle-between-its-plane-and-the-floor-at-the-end = Ângulo entre o seu plano e o piso no fim
angle-between-its-plane-and-the-floor-at-the-start = Ângulo entre o seu plano e o piso no início
angle-to-the-floor = Ângulo com o piso
angle-to-the-floor-below-which-it-is-taken-as-flat = Ângulo com o piso abaixo do qual se considera deitado
angular-acceleration-of-the-tilt-at-the-start = Aceleração angular da inclinação no início
angular-acceleration-of-the-tilt-at-the-start-moments-about-the-tangent-at-the-contact-about-which = Aceleração angular da inclinação no início: momentos em relação à tangente no contato, em relação à qual a força normal e o atrito não têm momento
angular-velocity-along-the-axis-the-spin-and-the-precession-along-it = Velocidade angular ao longo do eixo: a rotação própria e a precessão ao longo dele
angular-velocity-along-the-diameter-through-the-contact-the-precession-along-it = Velocidade angular ao longo do diâmetro pelo contato: a precessão ao longo dele
angular-velocity-along-the-horizontal-diameter = Velocidade angular ao longo do diâmetro horizontal
angular-velocity-at-the-end-axes-123 = Velocidade angular no fim, eixos 123
angular-velocity-at-the-end-in-the-axes-123 = Velocidade angular no fim, nos eixos 123
angular-velocity-in-the-axes-123 = Velocidade angular nos eixos 123
bound-on-t-v-e-over-the-motion-relative-to-the-energy-rolling-does-no-work = Limite de |T + V − E₀| no movimento, em relação à energia: o rolamento não realiza trabalho
centre = centro
coefficient-of-friction-with-the-floor = Coeficiente de atrito com o piso
coefficient-of-friction-needed = Coeficiente de atrito necessário
required-coefficient-of-friction = Coeficiente de atrito necessário
contact = contato
contact-at-the-end-along-x = Contato no fim, ao longo de X
contact-at-the-end-along-y = Contato no fim, ao longo de Y
contact-at-the-end-x = Contato no fim, X
contact-at-the-end-y = Contato no fim, Y
direction-of-its-horizontal-diameter-at-the-start-from-x = Direção do seu diâmetro horizontal no início, a partir de X
force = Força
ratio-of-friction-to-normal-force = Razão entre atrito e força normal
it-is-a = É um
it-leaves-the-floor-after-time-the-normal-force-would-become-negative = deixa o piso após { $time }: a força normal ficaria negativa
it-lies-flat-after-time = fica deitado após { $time }
it-lies-flat-from-the-start-give-a-larger-angle-to-the-floor-or-a-smaller-angle-at-which-it-counts-as = está deitado desde o início; dê um ângulo maior com o piso, ou um ângulo menor em que conta como deitado
it-slips-after-time-the-friction-required-for-rolling-exceeds-n = desliza após { $time }: o atrito necessário ao rolamento excede μ N
maximum-angle-over-the-motion = Ângulo máximo no movimento
maximum-angle-over-the-motion-at-a-turning-point-or-at-an-end = Ângulo máximo no movimento: em um ponto de retorno ou em um extremo
maximum-ratio-of-friction-to-normal-force = Razão máxima entre atrito e força normal
minimum-angle-over-the-motion = Ângulo mínimo no movimento
minimum-angle-over-the-motion-at-a-turning-point-or-at-an-end = Ângulo mínimo no movimento: em um ponto de retorno ou em um extremo
moment-of-inertia-about-the-contact-along-the-axis = Momento de inércia em relação ao contato, ao longo do eixo
moment-of-inertia-about-the-tangent-at-the-contact = Momento de inércia em relação à tangente no contato
moments-of-inertia-given = Momentos de inércia dados
about-a-diameter = Em torno de um diâmetro
about-its-axis = Em torno do seu eixo
normal-force-and-friction = Força normal e atrito
normal-force-at-the-end = Força normal no fim
path-on-the-floor = Trajetória no piso
positive-spin-rolls-it-against-the-direction-of-its-horizontal-diameter = Uma rotação própria positiva faz rolar contra o sentido do seu diâmetro horizontal.
precession-at-the-start = Precessão no início
radii-of-gyration-given = Raios de giração dados
radius-of-the-circle-that-touches-the-floor = Raio da circunferência que toca o piso
rate-of-tilting-at-the-start = Taxa de inclinação no início
spin-at-the-start = Rotação própria no início
the-energy-is-not-conserved-to-nine-digits-the-last-digits-of-the-motion-are-unreliable = a energia não se conserva com nove algarismos: os últimos algarismos do movimento são duvidosos
the-energy-t-v-over-the-motion = a energia T + V no movimento
the-equations-i-d-i-t-cot-i-c-m-g-r-cos-i-t-i-a-i-t-cot-i-c-m-r-and-the-path-of-the-contact-r-along-1 = As equações I_d ω̇₁ = I_t ω₂² cot θ − I_c ω₂ ω₃ − m g r cos θ, I_t ω̇₂ = (I_a ω₃ − I_t ω₂ cot θ) ω₁, I_c ω̇₃ = m r² ω₁ ω₂ e a trajetória do contato, −r ψ̇ ao longo de 1, são integradas pelo método de Dormand–Prince de ordem 8
the-motion-requires-too-many-steps-the-disc-rotates-or-oscillates-too-fast-for-this-duration-make-it = o movimento exige passos demais: o disco gira ou oscila rápido demais para esta duração; encurte-a
the-normal-force-at-the-end = a força normal no fim
the-rolling-disc = O disco que rola
the-tilt-by-the-equations-in-the-axes-123 = a inclinação pelas equações nos eixos 123
thin-hoop = Aro fino
through-the-centre-of-mass-which-is-the-centre-of-the-circle = Pelo centro de massa, que é o centro da circunferência.
if-omitted-the-floor-is-assumed-to-be-rough-enough = Se omitido, supõe-se o piso áspero o bastante.

# rigid-body/rolling-stability
stability-of-an-upright-rolling-or-spinning-disc = Estabilidade de um disco em pé que rola ou gira
minimum-speed-at-which-an-upright-disc-or-hoop-keeps-rolling-or-minimum-spin-with-which-it-stays = Velocidade mínima com que um disco ou aro em pé segue rolando, ou rotação mínima com que permanece em pé no lugar; crescimento ou oscilação a uma velocidade dada.
angular-frequency-of-the-oscillation = Frequência angular da oscilação
angular-velocity-to-be-assessed = Velocidade angular, a avaliar
growth = crescimento
growth-or-oscillation-of-a-small-tilt = Crescimento ou oscilação de uma pequena inclinação
minimum-angular-velocity-about-the-vertical = Velocidade angular mínima em torno da vertical
minimum-speed-of-the-centre = Velocidade mínima do centro
limit = Limite
motion = Movimento
rate = taxa
growth-rate-a-tilt-grows-as-e-t = Taxa de crescimento: uma inclinação cresce como e^σt
growth-rate-of-a-tilt = Taxa de crescimento de uma inclinação
rolling-in-a-straight-line = Rolando em linha reta
small-tilts-at-i-a-m-r-m-r-and-i-t-m-r-m-g-r-i-t-i-a-m-r-the-tilt-grows-below-this-spin = Pequenas inclinações ε com ω₂ = Ω: (I_a + m r²) ω̇₃ = m r² Ω ε̇ e (I_t + m r²) ε̈ = (m g r − I_t Ω²) ε − (I_a + m r²) Ω ω₃; a inclinação cresce abaixo desta rotação
small-tilts-follow-k-0-stable-when-k-is-positive = Pequenas inclinações seguem ε̈ + K ε = 0: estável quando K é positivo
small-tilts-with-v-r-i-t-i-a-and-i-t-m-r-m-g-r-i-a-m-r-the-tilt-grows-below-this-speed = Pequenas inclinações ε, com ω₃ = −v/r: I_t ω̇₂ = I_a ω₃ ε̇ e (I_t + m r²) ε̈ = m g r ε − (I_a + m r²) ω₂ ω₃; a inclinação cresce abaixo desta velocidade
speed-divided-by-the-minimum-speed = Velocidade dividida pela velocidade mínima
speed-of-the-centre-to-be-assessed = Velocidade do centro, a avaliar
ratio-of-speed-to-minimum-speed = Razão entre a velocidade e a mínima
spinning-about-its-vertical-diameter = Girando em torno do seu diâmetro vertical
stiffness-of-small-tilts = Rigidez de pequenas inclinações
the-eigenvalues-of-the-linearised-equations-squared = os autovalores das equações linearizadas, ao quadrado
the-general-equation-of-small-oscillations = a equação geral das pequenas oscilações
the-general-equation-of-small-oscillations-is-at-its-limit-there = a equação geral das pequenas oscilações está no seu limite ali
unstable-it-falls-over-however-small-the-tilt = instável: ele tomba, por menor que seja a inclinação
wobble = oscilação
oscillation = oscilação

# rigid-body/spinning-disc-on-arm
disc-spinning-on-a-turning-arm = Disco que gira em um braço giratório
angular-momentum-of-a-thin-disc-that-spins-on-a-rotating-arm-its-rate-of-change-and-the-couple-that = Momento angular de um disco fino que gira em um braço giratório, sua taxa de variação e o binário exercido pelo braço.
mass-of-the-disc = Massa do disco
radius-of-the-disc = Raio do disco
angular-velocity-of-the-arm = Velocidade angular do braço
about-the-y-axis = Em torno do eixo y.
spin-of-the-disc-relative-to-the-arm = Rotação própria do disco em relação ao braço
about-the-z-axis-relative-to-the-arm = Em torno do eixo z, relativa ao braço.
angular-acceleration-of-the-arm = Aceleração angular do braço
rate-of-change-of-the-spin = Taxa de variação da rotação própria
angle-of-the-arm = Ângulo do braço
from-the-fixed-axes-to-the-axes-rotating-with-the-arm-about-y = Dos eixos fixos aos que giram com o braço, em torno de y.
distance-of-the-disc-s-centre-from-the-axis-of-the-arm = Distância do centro do disco ao eixo do braço
for-the-kinetic-energy-of-the-complete-motion-it-does-not-affect-the-angular-momentum-about-a = Para a energia cinética do movimento completo; não afeta o momento angular em relação a A.
moment-of-inertia-about-a-diameter-i-i-y = Momento de inércia em relação a um diâmetro: Iₓ = I_y
moment-of-inertia-about-a-diameter = Momento de inércia em relação a um diâmetro
moment-of-inertia-about-the-axis-of-the-disc = Momento de inércia em relação ao eixo do disco
the-axes-xyz-rotate-with-the-arm = Os eixos xyz giram com o braço
angular-velocity-of-the-disc-rotation-of-the-arm-plus-the-spin-relative-to-it = Velocidade angular do disco: rotação do braço mais a rotação própria em relação a ele
angular-velocity-of-the-disc = Velocidade angular do disco
rates-of-change-of-the-components-of-in-axes-rotating-with-the-arm = Taxas de variação das componentes de ω nos eixos que giram com o braço
angular-acceleration-of-the-disc = Aceleração angular do disco
angular-momentum-about-the-centre-x-y-and-z-are-principal-axes-whatever-the-spin-angle-of-the-disc = Momento angular em relação ao centro: x, y e z são eixos principais, qualquer que seja o ângulo de rotação própria do disco
rate-of-change-relative-to-axes-rotating-with-the-arm = Taxa de variação relativa aos eixos que giram com o braço
couple-that-the-arm-exerts-on-the-disc-m-dh-dt = Binário exercido pelo braço sobre o disco: ΣM = dH/dt
gyroscopic-couple-its-component-along-x-in-closed-form = Momento giroscópico: sua componente em x, em forma fechada
gyroscopic-couple-about-x = Momento giroscópico em torno de x
kinetic-energy-of-rotation-about-the-centre = Energia cinética de rotação em torno do centro
kinetic-energy-of-rotation = Energia cinética de rotação
angular-momentum-about-the-centre-axes-of-the-arm = Momento angular em relação ao centro, eixos do braço
dh-dt-relative-to-the-axes-of-the-arm = (dH/dt) relativa aos eixos do braço
couple-on-the-disc-axes-of-the-arm = Binário sobre o disco, eixos do braço
angular-momentum-about-the-centre-fixed-axes = Momento angular em relação ao centro, eixos fixos
couple-on-the-disc-fixed-axes = Binário sobre o disco, eixos fixos
speed-of-the-centre-on-its-circle-about-the-axis-of-the-arm = Velocidade do centro na sua circunferência em torno do eixo do braço
kinetic-energy-of-the-complete-motion = Energia cinética do movimento completo
speed-of-the-centre = Velocidade do centro
the-couple-from-euler-s-equations-in-axes-fixed-in-the-disc = o binário pelas equações de Euler em eixos fixos ao disco
the-angular-momentum-from-the-inertia-tensor-rotated-with-the-disc-r-i-r = o momento angular pelo tensor de inércia girado com o disco: R I Rᵀ ω
the-couple-from-the-difference-quotient-of-r-i-r = o binário pelo quociente de diferenças de R I Rᵀ ω
couple-on-the-disc-in-fixed-axes-over-a-revolution-of-the-arm = Binário sobre o disco em eixos fixos, em uma volta do braço
m-x-at-this-angle = M_X neste ângulo
m-z-at-this-angle = M_Z neste ângulo
the-disc-on-its-arm = O disco no braço
# rigid-body/impulse
from-the-centre-of-mass-after-impact-to-name = Do centro de massa após o impacto a { $name }
parallel-axis-theorem-moment-of-inertia-about-an-axis-through-the-newly-fixed-point = Teorema dos eixos paralelos: momento de inércia em relação a um eixo pelo ponto fixado
parallel-axis-theorem-product-of-inertia-about-the-newly-fixed-point = Teorema dos eixos paralelos: produto de inércia em relação ao ponto fixado
a-ball-and-socket-a-hook-any-rotation-about-it-is-free = Uma junta esférica, um gancho: qualquer rotação em torno dele é livre.
a-hinge-a-shaft-or-an-edge-that-is-suddenly-fixed = Uma dobradiça, um eixo ou uma aresta que é fixada subitamente.
a-point-hits-a-smooth-surface = Um ponto choca-se com uma superfície lisa
point-suddenly-fixed = Ponto fixado subitamente
about-an-axis-from-rest-calculates-the-mass-for-which-the-body-with-the-same-shape-reaches-this-speed = Em torno de um eixo, a partir do repouso: calcula-se a massa com que o corpo, com a mesma forma, atinge essa velocidade.
axis-suddenly-fixed = Eixo fixado subitamente
angle-between-the-axis-and-h-the-nutation = Ângulo entre o eixo e H: a nutação
angle-between-the-axis-and = Ângulo entre o eixo e ω
angle-between-the-axis-of-the-body-and-h = Ângulo entre o eixo do corpo e H
angle-between-the-axis-of-the-body-and = Ângulo entre o eixo do corpo e ω
angular-momentum-about-g-before-impact = Momento angular em relação a G antes do impacto
angular-momentum-about-g-its-direction-is-constant-and-the-axis-now-precesses-about-it = Momento angular em relação a G: sua direção é constante, e em torno dela o eixo passa a precessionar
angular-momentum-about-the-axis-the-constraint-has-no-moment-about-it = Momento angular em relação ao eixo: a reação do vínculo não tem momento em relação a ele
angular-momentum-about-the-point-on-the-axis-excluding-the-reaction-of-the-axis = Momento angular em relação ao ponto do eixo, sem a reação do eixo
angular-momentum-about-the-newly-fixed-point-the-impulse-there-has-no-moment-about-it = Momento angular em relação ao ponto fixado: o impulso ali não tem momento em relação a ele
angular-speed-immediately-after-impact = Velocidade angular (módulo) imediatamente após o impacto
required-angular-speed-after-impact = Velocidade angular desejada após o impacto
angular-velocity-immediately-after-impact = Velocidade angular imediatamente após o impacto
angular-velocity-immediately-after-impact-h-i-along-the-axis = Velocidade angular imediatamente após o impacto: H_λ = I_λ ω′ ao longo do eixo
any-vector-normal-to-the-surface-out-of-it = Qualquer vetor normal à superfície, para fora dela
impulses = Impulsos
change-of-the-kinetic-energy = Variação da energia cinética
coefficient-of-restitution = Coeficiente de restituição
direction-cosines-of-the-axis = Cossenos diretores do eixo
direction-of-the-instantaneous-axis = Direção do eixo instantâneo
force-of-short-duration = Força de curta duração
from-g-to-the-point-of-impact = De G ao ponto de impacto
from-the-centre-of-mass-after-impact-to-that-before = Do centro de massa após o impacto ao de antes
from-the-point-on-the-axis-to-g = Do ponto do eixo a G
from-the-newly-fixed-point-to-g = Do ponto fixado a G
magnitude = Intensidade
impulse = Impulso
impulse-of-the-surface = Impulso da superfície
impulse-of-the-surface-the-separation-velocity-of-the-point-is-times-its-approach-velocity = Impulso da superfície: a velocidade de afastamento do ponto é ε vezes a de aproximação
impulsive-reaction-of-the-constraint = Reação impulsiva do vínculo
impulse-of-name-mean-force-times-duration = Impulso de { $name }: força média vezes duração
impulse-on-a-body-in-space = Impulso sobre um corpo no espaço
impulsive-reaction-couple-of-the-axis-change-of-the-angular-momentum-about-its-point = Binário de reação impulsiva do eixo: variação do momento angular em relação ao seu ponto
impulsive-reaction-couple-of-the-axis = Binário de reação impulsiva do eixo
impulsive-reaction-change-of-the-linear-momentum-not-due-to-the-applied-impulses = Reação impulsiva: variação da quantidade de movimento não devida aos impulsos aplicados
inertia-about-the-centre-of-mass-after-impact-by-the-parallel-axis-theorem = Inércia em relação ao centro de massa após o impacto, pelo teorema dos eixos paralelos
its-mass-after-impact = Sua massa após o impacto
its-momentum-is-included-its-mass-and-inertia-are-not = Inclui-se sua quantidade de movimento, mas não sua massa nem sua inércia.
its-motion-before = Seu movimento antes
its-rotation-before = Sua rotação antes
kinetic-energy-after = Energia cinética depois
kinetic-energy-after-impact = Energia cinética após o impacto
kinetic-energy-before = Energia cinética antes
kinetic-energy-before-impact = Energia cinética antes do impacto
kinetic-energy-before-impact-including-that-of-the-projectiles = Energia cinética antes do impacto, incluída a dos projéteis
lever-arm-of-an-impulse-along-the-normal = Braço de um impulso ao longo da normal
linear-momentum-after-impact-excluding-the-support-reactions-l-j = Quantidade de movimento após o impacto, sem as reações dos apoios: L + Σ J
linear-momentum-before-impact = Quantidade de movimento antes do impacto
linear-momentum-added-by-name = Quantidade de movimento acrescentada por { $name }
centre-of-mass-including-the-projectiles = Centro de massa com os projéteis
mass-for-the-required-angular-speed = Massa para a velocidade angular desejada
mass-including-the-projectiles = Massa com os projéteis
mass-for-which-the-body-with-the-same-shape-reaches-the-required-angular-speed-is-proportional-to-1-m = Massa com que o corpo, com a mesma forma, atinge a velocidade desejada: ω′ é proporcional a 1/m
mean-force = Força média
moment-of-inertia-about-this-axis = Momento de inércia em relação a esse eixo
transverse-moment-of-inertia = Momento de inércia transversal
neglected = Desprezada
part-of-the-body = Parte do corpo
point-of-the-instantaneous-axis-nearest-to-g-r-g-v-g = Ponto do eixo instantâneo mais próximo de G: r_G + ω × v_G/ω²
point-of-the-instantaneous-axis-nearest-to-the-centre-of-mass = Ponto do eixo instantâneo mais próximo do centro de massa
position-of-the-struck-point = Posição do ponto golpeado
position-of-the-point-of-impact = Posição do ponto de impacto
rate-of-precession = Velocidade de precessão
rate-of-precession-about-h = Velocidade de precessão em torno de H
rate-of-spin = Velocidade de rotação própria
rate-of-spin-about-the-axis-a-cos = Velocidade de rotação própria em torno do eixo, ψ̇ = ω_a − φ̇ cos θ
speed-of-the-centre-of-mass-before-impact = Velocidade (módulo) do centro de massa antes do impacto
speed-of-the-centre-of-mass-just-after-impact = Velocidade (módulo) do centro de massa logo após o impacto
the-axes-are-principal-each-component-over-its-moment-of-inertia = Os eixos são principais: cada componente dividida pelo seu momento de inércia
the-body-the-impulses-on-it-and-its-motion-just-after-impact = O corpo, os impulsos sobre ele e seu movimento logo após o impacto
the-three-equations-i-h-about-g-with-the-products-of-inertia = As três equações I ω = H em relação a G, com os produtos de inércia
the-three-equations-i-h-about-the-constrained-point-with-the-products-of-inertia = As três equações I ω = H em relação ao ponto preso, com os produtos de inércia
two-principal-moments-are-equal-the-axis-of-the-third-in-the-sense-of-the-spin = Dois momentos principais são iguais: o eixo do terceiro, no sentido da rotação própria
unit-normal-of-the-surface = Normal unitária da superfície
velocity = Velocidade
velocity-along-the-instantaneous-axis = Velocidade ao longo do eixo instantâneo
velocity-of-sliding-along-the-instantaneous-axis = Velocidade de deslizamento ao longo do eixo instantâneo
velocity-of-the-centre-of-mass-just-after-impact = Velocidade do centro de massa logo após o impacto
velocity-of-the-centre-of-mass-just-after-impact-g-rotates-about-the-constrained-point = Velocidade do centro de massa logo após o impacto: G gira em torno do ponto preso
velocity-of-the-point-along-the-normal-before-impact = Velocidade do ponto ao longo da normal, antes do impacto
velocity-of-the-point-per-unit-impulse-along-the-normal = Velocidade do ponto por impulso unitário ao longo da normal
constraint-after-the-impact = Vínculo após o impacto
from-then-on-the-axis-precesses-against-the-spin-retrograde-precession-the-axial-moment-of-inertia-is = a partir daí o eixo precessiona contra a rotação própria (precessão retrógrada: o momento de inércia axial é o maior)
from-then-on-the-axis-precesses-in-the-sense-of-the-spin-direct-precession-the-axial-moment-of = a partir daí o eixo precessiona no sentido da rotação própria (precessão direta: o momento de inércia axial é o menor)
the-angular-momentum-about-o-after-before-r-j-with-all-reactions = o momento angular em relação a O: depois − antes = Σ r × J com todas as reações
the-angular-velocity-composed-of-precession-and-spin = a velocidade angular composta de precessão e rotação própria
the-body-has-no-moment-of-inertia-about-the-axis-that-is-held-its-angular-speed-there-is = o corpo não tem momento de inércia em relação ao eixo fixado: sua velocidade angular ali é indeterminada; dê-lhe uma espessura
the-change-of-the-kinetic-energy-from-the-work-of-the-impulses-j-v-v-2 = a variação da energia cinética pelo trabalho dos impulsos, J · (v + v′)/2
the-mass-for-a-required-angular-speed-is-calculated-only-for-a-body-at-rest-that-is-held-by-an-axis = a massa para uma velocidade angular desejada só é calculada para um corpo em repouso, preso por um eixo e golpeado: nos demais casos, deixe em branco a velocidade angular desejada
the-point-does-not-move-towards-the-surface-check-its-normal-which-points-out-of-the-surface-and-the = o ponto não se move em direção à superfície: verifique a normal, que aponta para fora da superfície, e o movimento antes do impacto
the-solution-substituted-into-i-h = a solução substituída em I ω = H
the-velocity-of-the-constrained-point-which-is-zero = a velocidade do ponto preso, que é zero

# rigid-body/momentum
a-point-is-fixed = Um ponto é fixo
about-an-axis = Em torno de um eixo
along-the-arm-from-its-fixed-point-to-g = Ao longo do braço, do seu ponto fixo a G
angle-between-h-g-and-zero-where-lies-along-a-principal-axis = Ângulo entre H_G e ω: nulo onde ω está em um eixo principal
angle-between-the-angular-momentum-about-a-point-of-the-line-and-the-line = Ângulo entre o momento angular em relação a um ponto da reta e a reta
angle-between-the-angular-momentum-and-the-angular-velocity = Ângulo entre o momento angular e a velocidade angular
angle-between-this-angular-momentum-and-the-line = Ângulo entre esse momento angular e a reta
angular-momentum = Momento angular
angular-momentum-about-a = Momento angular em relação a A
angular-momentum-about-a-that-about-g-plus-the-moment-of-the-linear-momentum-at-g = Momento angular em relação a A: o relativo a G mais o momento da quantidade de movimento em G
angular-momentum-about-g = Momento angular em relação a G
angular-momentum-about-g-the-inertia-matrix-times = Momento angular em relação a G: a matriz de inércia vezes ω
angular-momentum-about-a-point-of-the-line = Momento angular em relação a um ponto da reta
angular-momentum-about-the-line = Momento angular em relação à reta
angular-speed-about-the-axis-of-the-largest-moment-with-the-same-angular-momentum = Velocidade angular em torno do eixo do maior momento, com o mesmo momento angular
angular-speed-positive-by-the-right-hand-rule = Velocidade angular, positiva pela regra da mão direita
angular-velocity-from-h-g-i = Velocidade angular a partir de H_G = I ω
angular-velocity-along-its-axis = Velocidade angular, ao longo do seu eixo
angular-velocity-along-the-instantaneous-axis-with-the-given-component-along-the-axis-of-the-body = Velocidade angular: ao longo do eixo instantâneo, com a componente dada ao longo do eixo do corpo
any-vector-along-an-axis-of-the-body = Qualquer vetor ao longo de um eixo do corpo
carried-by-an-arm-rotating-about-a-point = Levado por um braço que gira em torno de um ponto
component-of-the-angular-velocity-along-it = Componente da velocidade angular ao longo dele
dropped-from-rest = Solto a partir do repouso
from-the-fixed-point-to-g = Do ponto fixo a G
from-the-point-to-g = Do ponto a G
height-of-the-fall = Altura da queda
it-rotates-about-the-line-through-them-a-disc-rolling-on-the-floor-about-a-fixed-point-of-its-axle = Gira em torno da reta que os une: um disco que rola no piso em torno de um ponto fixo do seu eixo.
its-motion = Seu movimento
its-rotation = Sua rotação
its-velocity = Sua velocidade
kinetic-energy-of-the-motion-of-g = Energia cinética do movimento de G
kinetic-energy-of-the-motion-of-the-centre-of-mass = Energia cinética do movimento do centro de massa
kinetic-energy-of-the-rotation-about-g = Energia cinética da rotação em torno de G
kinetic-energy-of-the-rotation-about-the-centre-of-mass = Energia cinética da rotação em torno do centro de massa
maximum-principal-moment-of-inertia = Momento principal de inércia máximo
linear-and-angular-momentum-of-a-body-in-space-about-its-centre-of-mass-a-point-and-a-line-and-its = Quantidade de movimento e momento angular de um corpo no espaço em relação ao centro de massa, a um ponto e a uma reta, e sua energia cinética.
linear-momentum = Quantidade de movimento
magnitude-of-the-angular-momentum-about-a = Módulo do momento angular em relação a A
magnitude-of-the-angular-momentum-about-g = Módulo do momento angular em relação a G
magnitude-of-the-linear-momentum = Módulo da quantidade de movimento
momentum-and-kinetic-energy-of-a-body = Quantidade de movimento e energia cinética de um corpo
position-of-the-first-point = Posição do primeiro ponto
position-of-the-second-point = Posição do segundo ponto
fraction-of-the-rotational-kinetic-energy-lost-by-then = Fração da energia cinética de rotação perdida até então
fraction-of-the-rotational-kinetic-energy-that-is-lost-by-then = Fração da energia cinética de rotação que se perde até então
speed-after-the-fall-from-m-g-h-m-v-2 = Velocidade depois da queda, de m g h = m v²/2
speed-of-the-centre-of-mass = Velocidade (módulo) do centro de massa
the-angular-momentum-about-it-is-calculated = Calcula-se o momento angular em relação a ela.
the-angular-momentum-about-it-is-also-calculated = Calcula-se também o momento angular em relação a ele.
the-body-rotates-freely-relative-to-the-arm-only-the-arm-moves-its-centre-of-mass = O corpo gira livremente em relação ao braço: só o braço move seu centro de massa.
the-body-its-angular-velocity-and-its-angular-momentum = O corpo, sua velocidade angular e seu momento angular
the-instantaneous-axis-the-line-through-the-two-points-at-rest = O eixo instantâneo: a reta pelos dois pontos em repouso
two-of-its-points-are-at-rest = Dois dos seus pontos estão em repouso
velocity-of-a-point = Velocidade de um ponto
velocity-of-the-centre-of-mass = Velocidade do centro de massa
velocity-of-the-centre-of-mass-along-gravity = Velocidade do centro de massa, na direção da gravidade
velocity-of-the-centre-of-mass-from-that-of-the-point = Velocidade do centro de massa, a partir da do ponto
velocity-of-the-centre-of-mass-which-rotates-with-the-arm = Velocidade do centro de massa, que gira com o braço
velocity-of-the-centre-of-mass-g-rotates-about-the-fixed-point = Velocidade do centro de massa: G gira em torno do ponto fixo
if-energy-is-dissipated-inside-the-body-and-no-couple-acts-h-g-is-conserved-the-rotation-ends-about = Se há dissipação de energia dentro do corpo e nenhum binário atua, H_G se conserva: a rotação acaba em torno do eixo de momento de inércia máximo
a-direction-has-no-length-write-any-vector-along-it-such-as-0-0-1 = uma direção não tem comprimento: escreva qualquer vetor ao longo dela, como (0; 0; 1)
the-angular-momentum-about-a-from-the-inertia-about-a-i-a-d-m-v-a = o momento angular em relação a A pela inércia em relação a A: I_A ω + d × m v_A
the-body-rotates-about-the-axis-of-its-largest-moment-no-energy-can-be-lost-at-constant-angular = o corpo gira em torno do eixo do seu maior momento: nenhuma energia pode ser perdida com o momento angular conservado
the-kinetic-energy-from-the-velocity-of-a-and-the-inertia-about-a = a energia cinética pela velocidade de A e pela inércia em relação a A
the-kinetic-energy-of-rotation-from-the-principal-moments = a energia cinética de rotação pelos momentos principais
the-line-through-the-two-points-at-rest-is-at-right-angles-to-the-axis-of-the-body-an-angular = a reta pelos dois pontos em repouso é perpendicular ao eixo do corpo: uma velocidade angular ao longo dela não tem componente ali; verifique os pontos ou dê a própria velocidade angular
the-motion-of-the-body-is-not-defined = o movimento do corpo não está definido
the-rotation-is-not-defined = a rotação não está definida

# rigid-body/rod-on-shaft
slender-rod-welded-to-a-rotating-shaft = Haste delgada soldada a um eixo giratório
angular-momentum-of-an-inclined-rod-that-rotates-with-a-shaft-its-rate-of-change-and-the-couple-that = Momento angular de uma haste inclinada que gira com um eixo, sua taxa de variação e o binário exercido pelo eixo.
mass-of-the-rod = Massa da haste
half-the-length-of-the-rod = Metade do comprimento da haste
the-rod-is-2b-long-and-welded-at-its-middle = A haste tem comprimento 2b e é soldada no ponto médio.
angle-of-the-rod = Ângulo da haste
measured-from-the-horizontal = Medido a partir da horizontal
angle-to-the-horizontal = Ângulo com a horizontal
measured-from-the-shaft = Medido a partir do eixo
angle-to-the-shaft = Ângulo com o eixo
angular-velocity-of-the-shaft = Velocidade angular do eixo
angular-acceleration-of-the-shaft = Aceleração angular do eixo
angle-of-the-shaft = Ângulo do eixo
from-the-fixed-axes-to-the-axes-rotating-with-the-shaft-about-y = Dos eixos fixos aos que giram com o eixo, em torno de y.
transverse-moment-of-inertia-of-the-rod-i-y-i-z-along-it-i-0 = Momento de inércia transversal da haste, I_y′ = I_z′; ao longo dela, Iₓ′ = 0
transverse-moment-of-inertia-of-the-rod = Momento de inércia transversal da haste
component-of-the-angular-velocity-along-the-rod = Componente da velocidade angular ao longo da haste
component-of-the-angular-velocity-transverse-to-the-rod = Componente da velocidade angular transversal à haste
angular-momentum-in-the-axes-of-the-rod-only-y-contributes = Momento angular nos eixos da haste: só ω_y′ contribui
angular-momentum-in-the-axes-rotating-with-the-shaft = Momento angular nos eixos que giram com o eixo
magnitude-of-the-angular-momentum = Módulo do momento angular
component-of-the-angular-momentum-along-the-shaft = Componente do momento angular ao longo do eixo
the-axes-xyz-rotate-with-the-shaft = Os eixos xyz giram com o eixo
rate-of-change-relative-to-axes-rotating-with-the-shaft = Taxa de variação relativa aos eixos que giram com o eixo
couple-that-the-shaft-exerts-on-the-rod-m-dh-dt = Binário exercido pelo eixo sobre a haste: ΣM = dH/dt
the-couple-that-tilts-the-shaft-in-closed-form = O binário que inclina o eixo, em forma fechada
kinetic-energy-g-is-at-rest = Energia cinética: G está em repouso
angular-momentum-about-the-midpoint-axes-of-the-shaft = Momento angular em relação ao ponto médio, eixos que giram com o eixo
dh-dt-relative-to-the-axes-of-the-shaft = (dH/dt) relativa aos eixos que giram com o eixo
couple-on-the-rod-axes-of-the-shaft = Binário sobre a haste, eixos que giram com o eixo
couple-on-the-rod-about-z = Binário sobre a haste em torno de z
angular-momentum-about-the-midpoint-fixed-axes = Momento angular em relação ao ponto médio, eixos fixos
couple-on-the-rod-fixed-axes = Binário sobre a haste, eixos fixos
at-this-angle-the-shaft-is-a-principal-axis-of-the-rod-no-couple-is-needed-to-keep-the-rod-there = neste ângulo o eixo de rotação é eixo principal da haste: não é preciso binário para mantê-la na posição
h-and-1-6-m-b-sin-2 = Ω × H e −(1/6) m b² ω² sen 2β
the-component-along-the-shaft-is-the-inertia-about-the-shaft-times = a componente ao longo do eixo é o momento de inércia em relação ao eixo vezes ω
the-angular-momentum-from-the-inertia-tensor-of-the-rotated-rod = o momento angular pelo tensor de inércia da haste girada
the-couple-from-the-difference-quotient-of-that-angular-momentum = o binário pelo quociente de diferenças desse momento angular
couple-on-the-rod-against-its-angle = Binário sobre a haste em função do seu ângulo
the-rod-in-the-plane-rotating-with-the-shaft = A haste no plano que gira com o eixo

# rigid-body/rotation-chain
chain-of-rotations = Cadeia de rotações
angular-velocity-and-acceleration-of-every-frame-of-a-chain-of-joints-and-velocity-and-acceleration = Velocidade e aceleração angulares de cada referencial de uma cadeia de juntas, e velocidade e aceleração de pontos, em quaisquer eixos.
joints = Juntas
points = Pontos
axes-of-the-answers = Eixos das respostas
name = Nome
frame-to-which-it-is-attached = Referencial a que está fixado
position-in-the-axes-of-that-frame = Posição, nos eixos desse referencial
fixed-axes = Eixos fixos
axes-of-a-frame = Eixos de um referencial
frame-of-the-chain = Referencial da cadeia
name-of-the-joint-and-of-the-frame-after-it = Nome da junta e do referencial depois dela
axis = Eixo
any-vector-along-it-in-the-preceding-frame-angles-are-positive-by-the-right-hand-rule = Qualquer vetor ao longo dele, no referencial anterior; os ângulos são positivos pela regra da mão direita.
motion-of-the-joint = Movimento da junta
origin-of-the-frame-after-the-joint = Origem do referencial depois da junta
in-the-axes-of-the-preceding-frame = Nos eixos do referencial anterior.
values-at-this-instant = Valores neste instante
angle = Ângulo
angular-velocity = Velocidade angular
angular-acceleration = Aceleração angular
relative-to-the-preceding-frame = Relativa ao referencial anterior.
harmonic-oscillation-pitch-or-roll = Oscilação harmônica: arfagem ou balanço
amplitude = Amplitude
period = Período
time-since-the-upward-passage-through-mid-position = Tempo desde a passagem ascendente pela posição média
mean-angle = Ângulo médio
turn-of-a-vehicle-on-a-circle = Curva de um veículo em um círculo
speed = Velocidade
positive-by-the-right-hand-rule-about-the-axis = Positiva pela regra da mão direita em torno do eixo.
radius-of-the-circle = Raio da circunferência
acceleration-along-the-path = Aceleração ao longo da trajetória
angle-of-rotation-so-far = Ângulo girado até este instante
the-axis-of-name-has-no-length-write-any-vector-along-it-such-as-0-0-1 = o eixo de { $name } não tem comprimento: escreva qualquer vetor ao longo dele, como (0; 0; 1)
the-motion-of-name-exceeds-the-numerical-range-check-its-units = o movimento de { $name } excede a faixa numérica: confira as unidades
unit-vector-along-the-axis-of-name-in-the-preceding-frame = Vetor unitário ao longo do eixo de { $name }, no referencial anterior
axis-of-name-in-axes-rotated-by-by = Eixo de { $name }, nos eixos girados por { $by }
angular-velocity-of-name-relative-angular-velocities-add = Velocidade angular de { $name }: as velocidades angulares relativas se somam
angular-acceleration-of-name-about-its-fixed-axis = Aceleração angular de { $name }, em torno do seu eixo fixo
angular-acceleration-of-name-the-joint-axis-is-itself-rotated-by-the-preceding-frame = Aceleração angular de { $name }: o próprio eixo da junta é girado pelo referencial anterior
angle-of-the-oscillation-at-this-time = Ângulo da oscilação neste instante
angular-velocity-of-the-oscillation = Velocidade angular da oscilação
angular-acceleration-of-the-oscillation = Aceleração angular da oscilação
the-vehicle-rotates-once-per-lap-of-the-circle = O veículo dá um giro por volta da circunferência
angular-acceleration-of-the-vehicle = Aceleração angular do veículo
angular-velocity-of-the-frame = Velocidade angular do referencial
angular-acceleration-of-the-frame = Aceleração angular do referencial
magnitude-of-the-angular-velocity-of-the-last-frame = Módulo da velocidade angular do último referencial
magnitude-of-the-angular-acceleration-of-the-last-frame = Módulo da aceleração angular do último referencial
angular-velocity-of-the-last-frame = Velocidade angular do último referencial
angular-acceleration-of-the-last-frame = Aceleração angular do último referencial
magnitude-of-the-angular-velocity = Módulo da velocidade angular
magnitude-of-the-angular-acceleration = Módulo da aceleração angular
position-of-the-origin-of-name-in-the-preceding-frame-in-axes-rotated-by-by = Posição da origem de { $name } no referencial anterior, nos eixos girados por { $by }
velocity-of-the-origin-of-name = Velocidade da origem de { $name }
acceleration-of-the-origin-of-name = Aceleração da origem de { $name }
position-of-name-in-its-frame-in-axes-rotated-by-by = Posição de { $name } no seu referencial, nos eixos girados por { $by }
velocity-of-name = Velocidade de { $name }
acceleration-of-name = Aceleração de { $name }
velocity-of-the-point = Velocidade do ponto
acceleration-of-the-point = Aceleração do ponto
the-angular-velocity-from-the-difference-quotients-of-the-axes-of-the-last-frame = a velocidade angular pelas razões incrementais dos eixos do último referencial
the-angular-acceleration-from-the-difference-quotient-of-the-angular-velocity = a aceleração angular pela razão incremental da velocidade angular
the-velocity-of-name-from-the-difference-quotient-of-its-position = a velocidade de { $name } pela razão incremental da sua posição
the-acceleration-of-name-from-the-difference-quotient-of-its-velocity = a aceleração de { $name } pela razão incremental da sua velocidade
the-frames-of-the-chain = Os referenciais da cadeia
angular-velocity-of-the-last-frame-with-the-given-accelerations = Velocidade angular do último referencial, com as acelerações dadas
time = tempo
x-of-name = x de { $name }
y-of-name = y de { $name }
z-of-name = z de { $name }
direction-cosines-of-the-axes-of-the-frames = Cossenos diretores dos eixos dos referenciais

# rigid-body/steady-rolling
disc-or-hoop-rolling-steadily-on-a-circle = Disco ou aro que rola em regime permanente em um círculo
precession-angle-or-circle-of-a-disc-or-hoop-rolling-without-slipping-inclined-to-the-floor-spin = Precessão, ângulo ou círculo de um disco ou aro que rola sem deslizar, inclinado em relação ao piso: rotação própria, força normal, atrito necessário e estabilidade do movimento.
angle-and-circle-of-the-centre = Ângulo e círculo do centro
angle-and-circle-on-the-floor = Ângulo e círculo no piso
angle-and-precession = Ângulo e precessão
angle-between-its-plane-and-the-floor = Ângulo entre o seu plano e o piso
angle-of-the-plane-to-the-floor = ângulo do plano com o piso
circle-and-speed-of-the-centre = Círculo e velocidade do centro
coefficient-of-friction-required-for-this-motion = Coeficiente de atrito necessário para este movimento
component-of-the-angular-velocity-along-the-diameter-through-the-contact = Componente da velocidade angular ao longo do diâmetro pelo contato
friction-towards-the-axis-of-the-circle = Atrito, para o eixo do círculo
friction-towards-the-axis-of-the-circle-it-changes-the-direction-of-the-velocity-of-the-centre = Atrito, para o eixo do círculo: ele muda a direção da velocidade do centro
it-would-slip-the-motion-requires-a-coefficient-of-friction-of-needed = deslizaria: o movimento requer um coeficiente de atrito de { $needed }
lean-angle-from-the-vertical-complement-to-90 = Ângulo de inclinação em relação à vertical: o complemento de 90°
moments-about-the-horizontal-diameter-i-a-m-r-i-t-cos-m-g-r-cos-0-with-sin-and-a-r = Momentos em relação ao diâmetro horizontal: (I_a + m r²) ω₂ ω₃ − I_t ω₂ φ̇ cos θ + m g r cos θ = 0 com ω₂ = φ̇ sen θ e ω₃ = −φ̇ a/r
moments-about-the-horizontal-diameter-solved-for-the-circle-of-the-centre = Momentos em relação ao diâmetro horizontal, resolvidos para o círculo do centro
no-angle-was-found-for-this-rolling-motion-the-speed-is-too-small-or-too-large-for-the-circle = não se encontrou ângulo para este rolamento; a velocidade é pequena ou grande demais para o círculo
no-slip-the-contact-point-is-at-rest-v-r-along-1 = Sem deslizamento: o ponto de contato está em repouso, v = −r ω₃ ao longo de 1
normal-force-the-height-of-the-centre-is-constant = Força normal: a altura do centro é constante
precession-against-the-angle-for-the-same-circle-of-the-centre = Precessão em função do ângulo, para o mesmo círculo do centro
radius-of-the-circle-of-the-centre = Raio do círculo do centro
radius-of-the-circle-on-the-floor = Raio do círculo no piso
radius-of-the-circle-on-the-floor-the-contact-lies-outward-of-the-centre = Raio do círculo no piso: o contato fica para fora do centro
small-oscillations-of-the-angle-k-0-derivative-of-the-moments-about-the-tangent-at-the-contact = Pequenas oscilações do ângulo, ε̈ + K ε = 0: derivada dos momentos em relação à tangente no contato, dividida por I_t + m r²
variation-of-as-the-disc-tilts-i-t-i-a-i-t-cot = Variação de ω₂ quando o disco se inclina: I_t ω̇₂ = (I_a ω₃ − I_t ω₂ cot θ) θ̇
variation-of-as-the-disc-tilts-i-a-m-r-m-r = Variação de ω₃ quando o disco se inclina: (I_a + m r²) ω̇₃ = m r² ω₂ θ̇
spin-relative-to-the-precessing-axes-cos = Rotação própria, em relação aos eixos que precessionam: ω₃ = ψ̇ + φ̇ cos θ
stable-angular-frequency-of-the-oscillation = Estável: frequência angular da oscilação
stiffness-of-small-oscillations = Rigidez das pequenas oscilações
the-centre-completes-one-revolution-in-2-a-v = O centro dá uma volta em 2π a/v
the-centre-lies-inward-of-the-contact-by-r-cos = O centro fica para dentro do contato em r cos θ
the-circle-on-the-floor-is-so-small-that-the-centre-would-be-beyond-its-axis-make-the-circle-or-the = o círculo no piso é tão pequeno que o centro ficaria além do seu eixo; aumente o círculo ou o ângulo
the-disc-on-its-circle = O disco em sua circunferência
the-upright-disc-and-a-small-tilt = O disco em pé e uma pequena inclinação
the-disc-on-its-circle-the-circle-is-not-to-scale = O disco em sua circunferência (a circunferência está fora de escala)
the-equations-of-the-rolling-disc-keep-the-angle-constant = as equações do disco que rola mantêm o ângulo constante
the-friction-from-m-a-g = o atrito por m a_G
the-normal-force-from-m-a-g = a força normal por m a_G
the-precession-is-so-fast-that-the-centre-circles-on-the-far-side-of-the-axis-the-radius-a-is = a precessão é tão rápida que o centro circula do outro lado do eixo: o raio a é negativo
the-steady-motion-is-unstable-the-angle-diverges-from-it = o movimento permanente é instável: o ângulo diverge dele
this-motion = este movimento
zero-of-the-moments-about-the-horizontal-diameter-sin-i-a-m-r-a-r-i-t-cos-m-g-r-cos = Zero dos momentos em relação ao diâmetro horizontal: φ̇² sin θ ((I_a + m r²) a/r + I_t cos θ) = m g r cos θ

# rigid-body/top-nutation
a-heavy-top-released-with-any-initial-motion-limits-and-period-of-its-nutation-mean-precession-cusps = Um pião solto com um movimento inicial qualquer: os limites da nutação, seu período, a precessão média, cúspides, laços ou ondas, e a atitude em um instante.
angle-of-the-axis-to-the-vertical-at-the-start = Ângulo inicial do eixo com a vertical
angle-to-the-vertical-at-the-instant = Ângulo com a vertical no instante
angular-momentum-about-the-axis-the-weight-has-no-moment-about-it-so-it-is-conserved = Momento angular em torno do eixo: o peso não tem momento em relação a ele, logo ele se conserva
angular-momentum-about-the-vertical = Momento angular em torno da vertical
angular-momentum-about-the-vertical-the-weight-has-no-moment-about-it-either = Momento angular em torno da vertical: o peso também não tem momento em relação a ela
angular-velocity-of-the-axis-away-from-the-vertical-at-the-start = Velocidade angular inicial com que o eixo se afasta da vertical
complete-elliptic-integral-of-the-first-kind-of-the-modulus-k-u-u-u-u-k = Integral elíptica completa de primeira espécie, de módulo k = √((u₁ − u₂)/(u₃ − u₂)) = { $k }
effective-potential-against-the-angle-of-the-axis = Potencial efetivo em função do ângulo do eixo
energy-excluding-that-of-the-spin = Energia sem a da rotação própria
energy-excluding-that-of-the-spin-i-a-which-is-conserved-separately-heights-from-the-fixed-point = Energia sem a da rotação própria, ½ I_a ω₃², que se conserva à parte; alturas a partir do ponto fixo
frequency-of-the-nutation = Frequência da nutação
heavy-top-nutation = Pião: nutação
highest-position-of-the-axis-angle-to-the-vertical = Posição mais alta do eixo, ângulo com a vertical
highest-position-of-the-axis-there-0-with-u-cos-e-k-u-1-u-h-z-h-u-2-i-t-a-cubic-in-u = Posição mais alta do eixo. Ali θ̇ = 0: com u = cos θ, (E − K u)(1 − u²) = (H_z − H₃ u)²/(2 I_t), uma cúbica em u
its-frequency = Sua frequência
its-rate-of-change-at-the-instant = Sua taxa de variação no instante
its-rate-of-change-h-z-h-cos-i-t-sin = Sua taxa de variação, (H_z − H₃ cos θ)/(I_t sen²θ)
lowest-position-of-the-axis-angle-to-the-vertical = Posição mais baixa do eixo, ângulo com a vertical
lowest-position-of-the-axis-the-next-zero-of-the-cubic = Posição mais baixa do eixo: o zero seguinte da cúbica
rate-of-the-elliptic-function-argument-cos-varies-as-sn-p-t-between-its-limits = Taxa do argumento das funções elípticas: cos θ varia como sn²(p t) entre seus limites
period-of-the-nutation = Período da nutação
period-of-the-nutation-time-from-one-lowest-position-to-the-next = Período da nutação: intervalo entre duas posições mais baixas consecutivas
precession-at-the-highest-position-it-has-the-opposite-sign-at-the-lowest-position-the-axis-traces = Precessão na posição mais alta. Na mais baixa ela tem o sinal oposto: o eixo descreve laços
precession-at-the-highest-position-it-has-the-same-sign-at-the-lowest-position-the-axis-traces-waves = Precessão na posição mais alta. Na mais baixa ela tem o mesmo sinal: o eixo descreve ondas
precession-at-the-highest-position-the-axis-is-momentarily-at-rest-there-it-traces-cusps = Precessão na posição mais alta. Ali o eixo fica momentaneamente em repouso: ele descreve cúspides
precession-at-the-highest-position-cusps = Precessão na posição mais alta: cúspides
precession-at-the-highest-position-loops = Precessão na posição mais alta: laços
precession-at-the-highest-position-waves = Precessão na posição mais alta: ondas
precession-at-the-instant = Precessão no instante
precession-at-the-lowest-position = Precessão na posição mais baixa
precession-angle-per-nutation = Ângulo de precessão por nutação
precession-angle-per-nutation-integrated-over-time-two-elliptic-integrals-of-the-third-kind = Ângulo de precessão por nutação: φ̇ integrada no tempo, duas integrais elípticas de terceira espécie
precession-since-the-start = Precessão desde o início
precession-since-the-start-by-elliptic-integrals-of-the-third-kind = Precessão desde o início, por integrais elípticas de terceira espécie
precession-steady = Precessão (estacionária)
precession-is-constant-the-top-precesses-steadily = Precessão: θ é constante, o pião tem precessão estacionária
spin-relative-to-the-axis-at-the-start = Rotação própria inicial
spin-since-the-start = Rotação própria desde o início
spin-since-the-start-t-less-the-contributions-of-the-precession = Rotação própria desde o início: ω₃ t menos as contribuições da precessão
motion-of-the-axis-and-path-of-its-tip = Movimento do eixo e trajetória da sua ponta
third-zero-of-the-cubic-in-cos = Terceiro zero da cúbica em cos θ
third-zero-of-the-cubic-above-1-to-which-no-real-angle-corresponds = Terceiro zero da cúbica, acima de 1, ao qual não corresponde ângulo real
tip-along-x = ponta ao longo de X
tip-along-y = ponta ao longo de Y
tip-of-the-axis-seen-from-above = Ponta do eixo, vista de cima
if-given-the-attitude-at-this-time-after-the-start-is-also-calculated = Se informado, calcula-se também a atitude neste tempo após o início.
zero-for-a-top-released-with-its-axis-at-rest = Zero para um pião solto com o eixo em repouso.
angle-about-the-vertical = ângulo em torno da vertical
cos-u-u-u-sn-p-t-t-from-the-lowest-position-on = cos θ = u₂ + (u₁ − u₂) sn² p(t − t₂), a partir da posição mais baixa
energy-at-the-instant-is-that-at-the-start = a energia no instante é a do início
highest = mais alta
lowest = mais baixa
nutation-needs-the-transverse-moment-of-inertia-give-it-about-the-fixed-point-or-the-centre-of-mass = a nutação requer o momento de inércia transversal: informe-o em relação ao ponto fixo ou ao centro de massa
the-angular-momentum-about-the-vertical-is-that-at-the-start = o momento angular em torno da vertical é o do início
the-angle-at-the-start-by-the-elliptic-functions = o ângulo inicial pelas funções elípticas
the-axis-approaches-the-vertical-asymptotically-change-the-spin-or-the-initial-state-a-little = o eixo se aproxima assintoticamente da vertical: mude um pouco a rotação ou o estado inicial
the-axis-starts-on-the-vertical-where-precession-is-not-defined-start-slightly-off-it = o eixo parte da vertical, onde a precessão não é definida: comece um pouco ao lado
the-limit-substituted-into-the-cubic = o limite substituído na cúbica
the-precession-angle-per-nutation-by-equal-weight-quadrature = o ângulo de precessão por nutação, por quadratura de pesos iguais
the-sum-of-the-three-zeros-e-k-h-2-i-t-k = a soma dos três zeros, E/K + H₃²/(2 I_t K)
tip-of-a-unit-axis = ponta de um eixo unitário
# rigid-body/steady-rolling
# rigid-body/spinning-disc-on-arm

# rigid-body/turn-indicator
angle-of-a-yoke-with-a-spinning-rotor-and-two-springs-in-a-level-turn-or-the-rate-of-turn-indicated = Ângulo do garfo com um rotor girante e duas molas em uma curva nivelada, ou a velocidade angular da curva que um ângulo indica.
angle-of-the-yoke = Ângulo do garfo
angle-of-the-yoke-against-the-rate-of-turn = Ângulo do garfo em função da velocidade angular da curva
angular-velocity-of-the-aircraft-about-the-vertical = Velocidade angular da aeronave em torno da vertical
couple-of-the-two-springs-on-the-yoke-k-sin-cos-since-their-ends-move-by-d-2-sin-with-lever-arms-of-d = Binário das duas molas sobre o garfo: K sen θ cos θ, pois suas pontas se deslocam (d/2) sen θ com braços (d/2) cos θ
distance-between-the-springs = Distância entre as molas
each-acts-at-half-this-distance-from-the-axis-of-the-yoke = Cada uma atua à metade dessa distância do eixo do garfo.
force-of-each-spring = Força de cada mola
force-of-each-spring-one-is-longer-by-d-2-sin-the-other-shorter = Força de cada mola: uma se alonga (d/2) sen θ, a outra se encurta
gyroscopic-couple-on-the-tilted-rotor = Momento giroscópico sobre o rotor inclinado
gyroscopic-couple-with-the-axle-level = Momento giroscópico com o eixo do rotor nivelado
moment-of-inertia-transverse-to-the-axle = Momento de inércia transversal ao eixo do rotor
moment-of-inertia-of-a-disc-about-a-diameter = Momento de inércia de um disco em relação a um diâmetro
moments-of-inertia = Momentos de inércia
rate-of-turn = Velocidade angular da curva
rate-of-turn-the-root-of-i-a-i-a-i-t-sin-k-sin-that-is-zero-at-0 = Velocidade angular da curva: a raiz de I_a ω Ω + (I_a − I_t) Ω² sen θ = K sen θ que é nula em θ = 0
relative-to-the-yoke = Relativa ao garfo.
sine-of-the-angle-of-the-yoke = Seno do ângulo do garfo
sine-of-the-angle-of-the-yoke-i-a-i-a-i-t-sin-cos-k-sin-cos = Seno do ângulo do garfo: (I_a ω + (I_a − I_t) Ω sen θ) Ω cos θ = K sen θ cos θ
speed-and-radius = Velocidade e raio
speed-of-the-aircraft = Velocidade da aeronave
stiffness-of-each-spring = Rigidez de cada mola
the-indicator-shows-an-angle = O indicador mostra um ângulo
the-yoke-of-the-indicator-from-behind = O garfo do indicador visto de trás
turn-indicator-of-an-aircraft = Indicador de curva de uma aeronave
no-rate-of-turn-holds-the-yoke-at-that-angle-the-springs-are-too-stiff-for-the-rotor = nenhuma velocidade angular da curva mantém o garfo nesse ângulo: as molas são rígidas demais para o rotor
the-couple-of-the-springs = o binário das molas
the-springs-are-too-soft-the-rotor-tilts-the-yoke-until-its-axle-is-vertical-a-slower-rotor-a-wider = as molas são flexíveis demais: o rotor vira o garfo até seu eixo ficar vertical; um rotor mais lento, molas mais afastadas ou mais rígidas o seguram

# rigid-body/two-bladed-rotor
amplitude-of-the-component-at-twice-per-revolution = Amplitude da parcela que pulsa duas vezes por volta
amplitude-of-the-pulsating-part = Amplitude da parcela pulsante
angle-of-the-blades = Ângulo das pás
at-an-angular-velocity = Com uma velocidade angular
couple-about-the-precession-axis = Binário em torno do eixo de precessão
couple-about-the-spin-axis = Binário em torno do eixo de rotação própria
couple-about-the-spin-axis-which-books-neglect-it-keeps-the-spin-constant = Binário em torno do eixo de rotação própria, que os livros desprezam: mantém a rotação constante
couple-about-the-normal-to-spin-and-precession = Binário em torno da normal à rotação própria e à precessão
couple-about-the-normal-to-spin-and-precession-euler-s-equations-in-the-axes-of-the-blades-rotated = Binário em torno da normal à rotação própria e à precessão: equações de Euler nos eixos das pás, giradas de volta por χ
couple-on-a-two-bladed-rotor-whose-carrier-turns-components-about-the-spin-axis-the-precession-axis = Binário sobre um rotor de duas pás cujo veículo gira: componentes segundo a rotação própria, a precessão e a normal a ambas, variação com o ângulo das pás, e média.
couple-on-the-rotor-spin-precession-normal = Binário sobre o rotor (rotação própria, precessão, normal)
couple-on-the-rotor-over-a-revolution-of-the-blades = Binário sobre o rotor em uma volta das pás
from-the-precession-axis-in-the-sense-of-the-spin = A partir do eixo de precessão, no sentido da rotação própria.
gyroscopic-couple-of-a-two-bladed-propeller = Momento giroscópico de uma hélice de duas pás
maximum-resultant-over-a-revolution = Resultante máxima em uma volta
maximum-resultant-twice-per-revolution-with-slender-blades-where-they-lie-along-the-precession-axis = Resultante máxima, duas vezes por volta: com pás delgadas, onde elas ficam ao longo do eixo de precessão
minimum-resultant-over-a-revolution = Resultante mínima em uma volta
minimum-resultant-a-quarter-of-a-revolution-later = Resultante mínima, um quarto de volta depois
length-from-tip-to-tip = Comprimento de ponta a ponta
mass-of-both-blades = Massa das duas pás
mean-couple = Binário médio
mean-over-a-revolution-the-couple-of-a-symmetric-rotor-with-the-same-moment-of-inertia-about-its-axis = Média em uma volta: o binário de um rotor simétrico com o mesmo momento de inércia em relação ao seu eixo
moment-of-inertia-about-the-spin-axis = Momento de inércia em relação ao eixo de rotação própria
moment-of-inertia-about-the-line-across-the-blades = Momento de inércia em relação à linha transversal às pás
moment-of-inertia-about-the-line-of-the-blades = Momento de inércia em relação à linha das pás
moment-of-inertia-of-the-rod-about-the-spin-axis-and-across-the-blades-along-them-it-is-zero = Momento de inércia da haste em relação ao eixo de rotação própria, e transversal às pás; ao longo delas é nulo
on-a-curve = Em uma curva
radius-of-the-curve = Raio da curva
reaction-on-the-carrier-spin-precession-normal = Reação sobre o veículo (rotação própria, precessão, normal)
reaction-on-the-carrier-equal-and-opposite = Reação sobre o veículo: igual e oposta
relative-to-the-carrier-about-x = Relativa ao veículo, em torno de x.
resultant-normal-to-the-axle = Resultante normal ao eixo do rotor
resultant-of-the-couple-normal-to-the-axle-it-bends-the-shaft = Resultante do binário normal ao eixo do rotor: flete o eixo
slender-blades = Pás delgadas
blades-over-one-revolution-axle-along-x-precession-about-y = As pás em uma volta: eixo ao longo de x, precessão em torno de y
the-moment-of-inertia-along-them-is-neglected = O momento de inércia ao longo delas é desprezado.
three-principal-moments-of-inertia = Três momentos principais de inércia
uniform-slender-rod = Haste delgada uniforme
difference-between-the-moments-of-inertia-across-and-along-the-blades = Diferença entre os momentos de inércia transversal e longitudinal às pás
these-moments-of-inertia-violate-the-triangle-inequality-name-is-larger-than-the-sum-of-the-other-two = estes momentos de inércia violam a desigualdade triangular: { $name } é maior que a soma dos outros dois

# rigid-body/two-wheeler-lean
opposite-to-the-wheels = Contrário ao das rodas
lean-angle-of-a-motorcycle-in-a-turn-with-the-gyroscopic-couples-of-wheels-and-engine-the-required = Ângulo com que uma motocicleta se inclina na curva, com os binários giroscópicos das rodas e do motor, o atrito necessário e a velocidade para uma dada inclinação.
angular-velocity-of-the-turn = Velocidade angular da curva
find = Determinar
axles = Eixos
moment-of-the-centrifugal-force = Momento da força centrífuga
moment-of-the-centrifugal-force-about-the-line-of-contact = Momento da força centrífuga em relação à linha de contato
moment-of-the-weight = Momento do peso
moment-of-the-weight-which-balances-both = Momento do peso, que equilibra os dois
engine = Motor
friction-coefficient = Coeficiente de atrito
friction-coefficient-of-the-tyres = Coeficiente de atrito dos pneus
required-friction-coefficient-of-the-tyres = Coeficiente de atrito necessário nos pneus
required-friction-of-the-tyres-ratio-of-centripetal-force-to-weight-independent-of-the-lean = Atrito necessário nos pneus: razão entre a força centrípeta e o peso, independente da inclinação
from-behind-in-a-turn-to-the-right-r-is-not-to-scale = Vista de trás, em uma curva à direita (R fora de escala)
gear-ratio = Relação de transmissão
gyroscopic-couple-which-tends-to-right-the-vehicle = Momento giroscópico, que tende a endireitar o veículo
height-of-the-centre-of-mass = Altura do centro de massa
lean-angle-against-speed = Ângulo de inclinação em função da velocidade
lean-angle-from-the-vertical = Ângulo de inclinação em relação à vertical
lean-angle-from-the-vertical-found-numerically-the-couples-to-be-balanced-depend-on-the-lean-itself = Ângulo de inclinação em relação à vertical, obtido numericamente: os momentos a equilibrar dependem da própria inclinação
yaw-less-pitch-moment-of-inertia-of-the-whole-vehicle = Momento de inércia de guinada menos o de arfagem do veículo inteiro
with-wheels-and-rider-about-axes-through-g-the-one-about-the-vehicle-s-own-vertical-axis-less-the-one = Com rodas e piloto, em relação a eixos por G: o do eixo normal do veículo menos o do transversal. Os livros o desprezam; é pequeno diante de m h².
couple-due-to-the-turning-of-the-leaning-vehicle-itself-as-for-a-rotor-without-spin = Binário devido ao giro do próprio veículo inclinado, como o de um rotor sem rotação própria
couple-due-to-the-turning-of-the-leaning-vehicle-itself = Binário devido ao giro do próprio veículo inclinado
the-gyroscopic-couples-from-the-difference-quotient-of-the-angular-momentum = os binários giroscópicos pelo quociente de diferenças do momento angular
lean-of-a-two-wheeler-in-a-turn = Inclinação de um veículo de duas rodas na curva
lean-angle-of-a-vehicle-without-rotating-parts-on-the-same-circle = Ângulo de inclinação de um veículo sem partes girantes no mesmo círculo
lean-angle-without-the-gyroscopic-couples = Ângulo de inclinação sem os binários giroscópicos
same-sense-as-the-wheels = No mesmo sentido das rodas
mass-with-rider = Massa com o piloto
moment-of-inertia-of-each-wheel = Momento de inércia de cada roda
moment-of-inertia-of-its-rotating-parts = Momento de inércia das suas partes girantes
of-the-centre-of-mass = Do centro de massa.
radius-of-the-circle-of-the-centre-of-mass = Raio da circunferência do centro de massa
radius-of-the-wheels = Raio das rodas
speed-at-which-the-tyres-slide = Velocidade em que os pneus deslizam
speed-at-which-the-tyres-slide-on-that-circle = Velocidade em que os pneus deslizam nessa circunferência
speed-for-that-lean = Velocidade para essa inclinação
engine-speed-divided-by-wheel-speed = Rotação do motor dividida pela das rodas.
speed-of-the-wheels = Velocidade das rodas
square-of-the-speed-m-g-h-sin-m-r-g-h-i-v-r-cos-with-v-r = Quadrado da velocidade: m g h sen θ = (m Ω² R_G h + I v Ω/r) cos θ com Ω = v/R
with-the-vehicle-upright = Com o veículo na vertical.
tangent-of-the-lean-m-g-h-sin-m-v-h-r-i-v-r-r-cos = Tangente da inclinação: m g h sen θ = (m v² h/R + I v²/(r R)) cos θ
radius-measured = Raio medido
the-centre-of-mass-then-runs-on-the-smaller-circle-of-radius-r-h-sin = O centro de massa percorre então a circunferência menor, de raio R − h sen θ.
the-lean-at-a-given-speed = A inclinação para uma velocidade dada
the-speed-for-a-given-lean = A velocidade para uma inclinação dada
to-the-centre-of-mass = Até o centro de massa
to-the-wheel-path = Até a trajetória das rodas
rotating-parts-referred-to-the-wheel-speed-their-angular-momentum-is-i-v-r = Partes girantes, referidas à rotação das rodas: seu momento angular é I v/r
at-that-lean-the-centre-of-mass-is-over-the-centre-of-the-turn-write-a-larger-radius = com essa inclinação o centro de massa fica sobre o centro da curva: escreva um raio maior
lean = Inclinação
no-lean-balances-the-couples-the-speed-is-too-high-for-this-radius = nenhuma inclinação equilibra os binários: a velocidade é alta demais para este raio
the-couples-about-the-line-of-contact-balance = os momentos em relação à linha de contato se equilibram
the-angular-momentum-of-the-engine-opposes-that-of-the-wheels-so-strongly-that-the-vehicle-would-lean = o momento angular do motor é tão contrário ao das rodas que o veículo se inclinaria para fora: nenhuma velocidade dá essa inclinação
the-radius-of-the-wheel-path-must-be-above-the-height-of-the-centre-of-mass-which-would-otherwise = o raio da trajetória das rodas deve ser maior que a altura do centro de massa, que de outro modo se inclinaria sobre o centro da curva
the-tyres-slide-required-friction-coefficient-needed-available-friction = os pneus deslizam: coeficiente de atrito necessário { $needed }, disponível { $friction }
with-wheels-and-engine = com rodas e motor

# rigid-body/wheel-loads
about-an-axis-transverse-to-the-axle-it-matters-only-on-a-banked-road-and-little = Em torno de um eixo transversal ao das rodas. Só importa em pista inclinada, e pouco.
above-the-road-normal-to-it = Acima da pista, na direção normal a ela.
transverse-opposite-to-the-wheels = Transversal, em sentido contrário ao das rodas
transverse-same-sense-as-the-wheels = Transversal, no mesmo sentido das rodas
sum-of-the-wheel-loads-normal-to-the-road = Soma das cargas das rodas, normal à pista
longitudinal-clockwise-seen-from-the-front = Longitudinal, horário visto de frente
longitudinal-clockwise-seen-from-the-rear = Longitudinal, horário visto de trás
angle-of-the-road-or-the-track-which-falls-to-the-inside-the-superelevation-of-a-railway = Ângulo da pista ou da via, que desce para o lado interno; a superelevação de uma ferrovia.
angular-velocity-of-the-engine = Velocidade angular do motor
angular-velocity-of-the-vehicle-on-its-curve = Velocidade angular do veículo na sua curva
bank = Inclinação da pista
overturning-couple-per-square-of-speed-c-k-v-less-m-g-h-sin-on-a-bank = Binário de tombamento por quadrado da velocidade: C = K v² (menos m g h sen β em pista inclinada)
distance-between-the-left-and-the-right-wheels-the-gauge-of-a-railway = Distância entre as rodas esquerdas e direitas; na ferrovia, a bitola.
distance-of-the-centre-of-mass-behind-the-front-axle = Distância do centro de massa atrás do eixo dianteiro
each-pair-with-its-axle-mass-and-radius-of-gyration = Cada rodeiro: massa e raio de giração
each-pair-with-its-axle-moment-of-inertia = Cada rodeiro: momento de inércia
each-wheel-mass-and-radius-of-gyration = Cada roda: massa e raio de giração
each-wheel-moment-of-inertia = Cada roda: momento de inércia
engine-or-motors = Motor ou motores
with-four-wheels-on-a-rigid-body-it-is-indeterminate-one-half-if-nothing-is-known-otherwise-as = Com quatro rodas e carroceria rígida fica indeterminada: metade se nada se sabe; senão, conforme a distribuição pelas molas.
gyroscopic-couple-of-the-engine = Momento giroscópico do motor
gyroscopic-couple-of-the-engine-which-adds-to-that-of-the-wheels = Momento giroscópico do motor, que se soma ao das rodas
gyroscopic-couple-of-the-engine-which-is-subtracted-from-that-of-the-wheels = Momento giroscópico do motor, que se subtrai do das rodas
gyroscopic-couple-of-the-engine-in-this-turn-it-loads-the-front-axle-and-unloads-the-rear-one = Momento giroscópico do motor: nesta curva carrega o eixo dianteiro e alivia o traseiro
gyroscopic-couple-of-the-engine-in-this-turn-it-loads-the-rear-axle-and-unloads-the-front-one = Momento giroscópico do motor: nesta curva carrega o eixo traseiro e alivia o dianteiro
gyroscopic-couple-of-the-wheels = Momento giroscópico das rodas
gyroscopic-couple-of-the-wheels-it-tilts-the-vehicle-outwards-about-its-longitudinal-axis = Momento giroscópico das rodas: tomba o veículo para fora, em torno do seu eixo longitudinal
load-of-each-inner-wheel = Carga de cada roda interna
load-of-each-outer-wheel = Carga de cada roda externa
load-of-the-front-axle-moments-about-the-rear-one = Carga do eixo dianteiro: momentos em relação ao traseiro
load-of-the-front-inner-wheel = Carga da roda dianteira interna
load-of-the-front-outer-wheel = Carga da roda dianteira externa
load-of-the-rear-axle = Carga do eixo traseiro
load-of-the-rear-inner-wheel = Carga da roda traseira interna
load-of-the-rear-outer-wheel = Carga da roda traseira externa
static-load-of-the-first-wheel-to-lift = Carga estática da primeira roda a levantar
load-on-each-outer-wheel-due-to-the-couple-of-the-wheels = Carga em cada roda externa devida ao binário das rodas
load-transfer-from-the-inner-to-the-outer-side = Transferência de carga do lado interno para o externo
load-transfer-from-the-inner-to-the-outer-side-sum-of-all-wheels-of-a-side = Transferência de carga do lado interno para o externo, soma das rodas de um lado
load-on-each-outer-wheel-due-to-the-couple-of-the-wheels-alone = Carga em cada roda externa devida só ao binário das rodas
loads-on-the-wheels-of-a-car-a-trolley-or-a-rail-axle-in-a-level-or-banked-curve-with-the-gyroscopic = Cargas nas rodas de um automóvel, de um bonde ou de um rodeiro em curva plana ou inclinada, com os binários giroscópicos das rodas e do motor, e as velocidades em que uma roda levanta ou o veículo desliza.
mass-of-a-pair = Massa de um rodeiro
mass-of-a-wheel = Massa de uma roda
moment-of-inertia-of-a-pair = Momento de inércia de um rodeiro
moment-of-inertia-of-a-wheel = Momento de inércia de uma roda
moment-of-inertia-of-all-wheels-about-their-axles = Momento de inércia de todas as rodas em relação aos seus eixos
moment-of-inertia-of-the-wheels = Momento de inércia das rodas
of-all-parts-that-rotate-at-the-same-speed = De todas as partes que giram com a mesma rotação.
one-axle = Um eixo
overturning-couple-of-the-side-force = Momento de tombamento da força lateral
overturning-couple-of-the-side-force-the-centrifugal-force-at-the-height-h = Momento de tombamento da força lateral: a força centrífuga à altura h
radius-of-gyration-of-a-pair = Raio de giração de um rodeiro
radius-of-gyration-of-a-wheel = Raio de giração de uma roda
shaft-and-sense = Eixo e sentido
load-transfer-at-the-front-axle = Transferência de carga no eixo dianteiro
share-of-the-overturning-couple-carried-by-the-front-axle = Parcela do eixo dianteiro no binário de tombamento
side-force-of-the-road = Força lateral da pista
side-force-of-the-road-parallel-to-its-surface-towards-the-inside = Força lateral da pista, paralela à sua superfície, para o lado interno
speed-at-which-the-load-vanishes-n-n-v = Velocidade em que a carga se anula: N₀ = n v²
speed-at-which-the-front-inner-wheel-lifts = Velocidade em que a roda dianteira interna levanta
speed-at-which-the-front-outer-wheel-lifts = Velocidade em que a roda dianteira externa levanta
speed-at-which-the-inner-wheels-lift = Velocidade em que as rodas internas levantam
speed-at-which-the-outer-wheels-lift = Velocidade em que as rodas externas levantam
speed-at-which-the-rear-inner-wheel-lifts = Velocidade em que a roda traseira interna levanta
speed-at-which-the-rear-outer-wheel-lifts = Velocidade em que a roda traseira externa levanta
speed-at-which-the-side-force-reaches-the-friction-s-p = Velocidade em que a força lateral atinge o atrito: S = µ P
speed-at-which-the-vehicle-slides-outwards = Velocidade em que o veículo desliza para fora
the-vehicle-from-behind-and-from-the-left-r-is-not-to-scale = O veículo visto de trás e pela esquerda (R fora de escala)
transverse-moment-of-inertia-of-each-pair-of-wheels = Momento de inércia transversal de cada rodeiro
two-axles-centre-of-mass-given = Dois eixos, centro de massa dado
two-axles-centre-of-mass-in-the-middle = Dois eixos, centro de massa no meio
load-reduction-per-unit-of-speed-squared = Redução da carga por quadrado da velocidade
wheel-loads-against-speed = Cargas das rodas em função da velocidade
wheel-loads-in-a-turn = Cargas das rodas na curva
wheelbase = Distância entre eixos
if-omitted-only-the-limits-are-calculated = Se omitida, calculam-se só os limites.
a-wheel-has-lifted-the-road-cannot-pull-and-the-loads-are-those-that-would-keep-it-down = uma roda levantou: a pista não pode puxar, e as cargas são as que a manteriam no chão
a-wheel-lifts = uma roda levanta
a-wheel-lifts-before-the-vehicle-slides-it-overturns = uma roda levanta antes que o veículo deslize: ele tomba
an-engine-along-the-vehicle-shifts-load-between-the-axles-choose-two-axles-with-the-centre-of-mass = um motor longitudinal transfere carga entre os eixos: escolha dois eixos com o centro de massa dado, e escreva a distância entre eixos
the-load-is-zero-at-the-lifting-speed = a carga é nula na velocidade em que a roda levanta
no-wheel-lifts-at-any-speed = nenhuma roda levanta, a velocidade alguma
on-this-bank-the-vehicle-does-not-slide-outwards-at-any-speed = nesta inclinação o veículo não desliza para fora a velocidade alguma
the-bank-is-so-steep-that-the-vehicle-tips-over-to-the-inside-at-rest = a pista é tão inclinada que o veículo em repouso tomba para dentro
the-centre-of-mass-is-not-between-the-axles-so-the-vehicle-tips-over-at-rest-write-its-distance = o centro de massa não está entre os eixos, e o veículo tomba em repouso: escreva sua distância atrás do eixo dianteiro, de zero à distância entre eixos
the-couple-of-the-wheels-from-the-difference-quotient-of-r-i-r = o binário das rodas pelo quociente de diferenças de R I Rᵀ ω
the-moments-of-the-wheel-loads-about-the-long-axis-balance-the-couples = os momentos das cargas das rodas em relação ao eixo longitudinal equilibram os binários
the-side-force-is-above-the-friction-the-vehicle-slides-at-this-speed = a força lateral excede o atrito: o veículo desliza a esta velocidade
the-wheel-loads-sum-to-the-total = as cargas das rodas somam o total

# rigid-body/rate-of-change
given-name = { $given_name }
rate-of-change-of-angular-momentum = Taxa de variação do momento angular
dh-dt-dh-dt-relative-h-of-a-body-on-a-chain-of-joints-in-a-chosen-moving-frame-and-the-inertia-force = dH/dt = (dH/dt) relativa + Ω × H de um corpo em uma cadeia de juntas, em um referencial móvel escolhido, e a força e o binário de inércia em qualquer ponto.
joints-that-move-it = Juntas que o movem
moving-frame = Referencial móvel
all-vectors-are-resolved-along-its-axes = Todos os vetores são decompostos nos seus eixos.
reference-point-for-moments = Ponto de referência dos momentos
the-centre-of-mass-g = O centro de massa G
the-fixed-origin-o = A origem fixa O
another-fixed-point-a = Outro ponto fixo A
position-from-o-in-the-axes-of-the-moving-frame = Posição a partir de O, nos eixos do referencial móvel
mass-of-the-whole-body = Massa do corpo inteiro
moment-of-inertia-of-the-body-about-g = Momento de inércia do corpo em relação a G
product-of-inertia-of-the-body-about-g-such-as-i-xy-xy-dm = Produto de inércia do corpo em relação a G, como I_xy = ∫ xy dm
centre-of-mass-g-from-the-origin-of-the-last-frame-in-the-axes-of-the-moving-frame = Centro de massa G a partir da origem do último referencial, nos eixos do referencial móvel
acceleration-of-the-centre-of-mass = Aceleração do centro de massa
centre-of-mass-g-from-the-reference-point-for-moments = Centro de massa G a partir do ponto de referência dos momentos
angular-momentum-about-the-point = Momento angular em relação ao ponto
moment-of-all-forces-about-the-point-dh-dt-with-the-point-fixed = Momento de todas as forças em relação ao ponto: dH/dt com o ponto fixo
inertia-force-opposite-to-the-acceleration-of-g = Força de inércia, oposta à aceleração de G
corresponding-inertia-couple-at-the-point = Binário de inércia correspondente no ponto
angular-momentum-along-the-axis-of-the-last-joint = Momento angular ao longo do eixo da última junta
magnitude-of-the-moment = Módulo do momento
moment-of-all-forces-about-the-point = Momento de todas as forças em relação ao ponto
dh-dt-about-g = dH/dt em relação a G
inertia-force = Força de inércia
inertia-couple-at-the-point = Binário de inércia no ponto
over-half-a-revolution-the-transverse-component-reverses = Em meia volta a componente transversal se inverte
change-of-the-angular-momentum-over-half-a-revolution = Variação do momento angular em meia volta
dh-dt-about-g-from-euler-s-equations-i-h = dH/dt em relação a G pelas equações de Euler: I α + ω × H
rates-of-change-of-the-components-of-in-the-axes-of-the-moving-frame = Taxas de variação das componentes de ω nos eixos do referencial móvel
angular-velocity-of-the-body-relative-to-the-moving-frame = Velocidade angular do corpo relativa ao referencial móvel
contribution-of-the-changing-moments-and-products-of-inertia-in-these-axes-zero-for-a-body-of = Contribuição da variação dos momentos e produtos de inércia nesses eixos; nula para um corpo de revolução em torno do próprio eixo
rate-of-change-relative-to-the-moving-frame = Taxa de variação relativa ao referencial móvel
dh-dt-relative-to-the-moving-frame-about-g = (dH/dt) relativa ao referencial móvel, em relação a G
rate-of-change-of-the-angular-momentum-about-g-in-fixed-axes = Taxa de variação do momento angular em relação a G em eixos fixos
the-angular-momentum-from-the-inertia-tensor-rotated-with-the-body-r-i-r = o momento angular pelo tensor de inércia girado com o corpo: R I Rᵀ ω
dh-dt-from-the-difference-quotient-of-r-i-r = dH/dt pela razão incremental de R I Rᵀ ω
dh-dt-about-g-in-the-fixed-axes-over-one-revolution-of-the-first-joint = dH/dt em relação a G nos eixos fixos ao longo de uma volta da primeira junta
angular-momentum-and-its-rate-of-change = Momento angular e sua taxa de variação

# rigid-body/reactions
reactions-on-a-rotating-body = Reações em um corpo em rotação
forces-and-couples-of-bearings-hinges-welds-wires-and-contacts-on-a-body-that-turns-about-a-shaft-or = Forças e binários de mancais, articulações, engastes, fios e contatos em um corpo que gira em torno de um eixo ou em uma cadeia de juntas, por d'Alembert.
one-for-a-body-on-a-shaft-a-chain-for-a-body-carried-by-a-moving-support = Uma para um corpo em um eixo; uma cadeia para um corpo levado por um suporte móvel.
drive-of-the-last-joint = Acionamento da última junta
axes-of-supports-loads-and-reactions = Eixos dos apoios, cargas e reações
supports = Apoios
loads = Cargas
acceleration-of-gravity-in-the-fixed-axes = Aceleração da gravidade, nos eixos fixos
zero-to-neglect-the-weight = Zero para desprezar o peso.
given-motion-its-couple-is-calculated = Movimento dado; calcula-se o seu binário
given-couple-about-the-axis-the-acceleration-is-calculated = Binário dado em torno do eixo; calcula-se a aceleração
couple-about-the-axis-of-the-last-joint = Binário em torno do eixo da última junta
zero-for-a-body-that-turns-freely = Zero para um corpo que gira livremente.
type-of-load = Tipo de carga
a-force = uma força
a-couple = Um binário
point-that-it-acts-on = Ponto em que atua
point-of-application = Ponto de aplicação
moment = Momento
point = Ponto
from-the-origin-of-the-axes-of-the-supports = A partir da origem dos eixos dos apoios.
kind-of-support = Tipo de apoio
bearing = Mancal
two-forces-normal-to-the-shaft = Duas forças transversais ao eixo.
direction-of-the-shaft = Direção do eixo
bearing-that-also-carries-the-axial-force = Mancal que também recebe a força axial
three-forces = Três forças.
ball-and-socket = Rótula
clevis = Articulação com pino
three-forces-and-couples-normal-to-its-pin = Três forças e binários transversais ao pino.
direction-of-the-pin = Direção do pino
weld = Solda
three-forces-and-three-couples = Três forças e três binários.
wire-cable-or-rod-with-a-joint-at-each-end = Fio, cabo ou haste articulada nas duas pontas
one-force-along-it = Uma força ao longo dele.
direction-from-the-body-along-the-wire = Direção do fio, a partir do corpo
contact-with-a-plane-smooth-or-sliding = Contato com um plano, liso ou deslizando
one-force-tilted-from-the-normal-by-the-friction = Uma força, inclinada da normal pelo atrito.
normal-of-the-plane-towards-the-body = Normal do plano, voltada para o corpo
coefficient-of-friction = Coeficiente de atrito
direction-in-which-the-body-slides = Direção em que o corpo desliza
no-effect-without-friction = Sem efeito na ausência de atrito.
contact-with-a-plane-without-sliding = Contato com um plano, sem deslizamento
three-forces-the-required-friction-is-calculated = Três forças; calcula-se o atrito necessário.
couple-about-a-direction = Binário em torno de uma direção
a-drive-or-a-key-that-lets-the-point-move = Um acionamento ou uma chaveta que deixa o ponto mover-se.
direction = Direção
acceleration-of-gravity-in-axes-rotated-by-by = Aceleração da gravidade nos eixos girados por { $by }
acceleration-of-the-centre-of-mass-excluding-that-of-the-last-joint = Aceleração do centro de massa, excluída a da última junta
acceleration-of-the-centre-of-mass-including-that-of-the-last-joint = Aceleração do centro de massa, incluída a da última junta
angular-acceleration-of-the-body-including-that-of-the-last-joint = Aceleração angular do corpo, incluída a da última junta
angular-acceleration-of-the-last-joint = Aceleração angular da última junta
coefficient-of-friction-required-to-keep-name-from-sliding = Coeficiente de atrito necessário para { $name } não deslizar
driving-torque = Torque motor
driving-torque-about-the-axis-of-the-last-joint-from-the-same-equations = Torque motor em torno do eixo da última junta, pelas mesmas equações
support-couple = Binário do apoio
couple-of-name-from-the-same-equations = Binário de { $name }, pelas mesmas equações
dynamic-reaction = Reação dinâmica
static-reaction = Reação estática
support-reactions = Reações dos apoios
forces-to-be-balanced-by-the-supports = Forças a equilibrar pelos apoios
friction-force-of-name = Força de atrito de { $name }
inertia-couple = Binário de inércia
inertia-couple-opposite-to-the-rate-of-change-of-the-angular-momentum = Binário de inércia, oposto à taxa de variação do momento angular
inertia-force-at-g = Força de inércia em G
magnitude-of-the-reaction = Módulo da reação
magnitude-of-the-reaction-of-name = Módulo da reação de { $name }
magnitudes-of-the-reactions-against-the-speed = Módulos das reações em função da velocidade
centre-of-mass-g-from-the-origin-of-the-axes-of-the-supports = Centro de massa G a partir da origem dos eixos dos apoios
centre-of-mass-g-from-the-origin-of-the-last-frame-in-the-axes-of-the-supports = Centro de massa G a partir da origem do último referencial, nos eixos dos apoios
moment-of-inertia-about-the-axis-of-the-last-joint = Momento de inércia em relação ao eixo da última junta
moment-of-weight-and-loads-about-the-origin-of-the-axes-of-the-supports = Momento do peso e das cargas em relação à origem dos eixos dos apoios
moments-about-the-axis-of-the-last-joint-about-which-the-supports-exert-none-t-m-e-m-a-j = Momentos em torno do eixo da última junta, em torno do qual os apoios não exercem nenhum: T + M − e · (Ḣ + ρ × m a) = J θ̈
moments-to-be-balanced-by-the-supports-about-the-origin-of-their-axes = Momentos a equilibrar pelos apoios, em relação à origem dos seus eixos
normal-force-of-name = Força normal de { $name }
origin-of-the-last-frame-in-the-axes-of-the-supports = Origem do último referencial, nos eixos dos apoios
rate-of-change-of-the-angular-momentum-about-g-without-that-acceleration = Taxa de variação do momento angular em relação a G sem essa aceleração
rate-of-change-relative-to-axes-rotating-with-the-body = Taxa de variação relativa aos eixos que giram com o corpo
rate-of-change-of-the-angular-momentum-about-g-with-h-for-axes-rotating-with-the-body = Taxa de variação do momento angular em relação a G, com Ω × H para eixos que giram com o corpo
reaction = Reação
reaction-in-the-fixed-axes = Reação nos eixos fixos
reaction-of-name-in-the-fixed-axes = Reação de { $name } nos eixos fixos
reaction-of-name-to-weight-and-loads-at-rest-with-the-body-restrained-by-a-couple-about-the-last-axis = Reação de { $name } ao peso e às cargas em repouso, com o corpo retido por um binário em torno do último eixo
reaction-of-name-from-the-six-equations-of-equilibrium-with-the-inertia-force-and-couple = Reação de { $name }, pelas seis equações de equilíbrio com a força e o binário de inércia
reactions-in-the-fixed-axes-over-one-revolution-of-name = Reações nos eixos fixos ao longo de uma volta de { $name }
sum-of-weight-and-loads = Soma do peso e das cargas
support = Apoio
tension = Tração
tension-of-name = Tração de { $name }
the-body-on-its-supports = O corpo em seus apoios
weight-of-the-body-at-g = Peso do corpo, em G
dynamic-part-of-the-reaction-of-name = Parcela dinâmica da reação de { $name }
a-direction-of-the-support-name-has-no-length-write-any-vector-along-it-such-as-1-0-0 = uma direção do apoio { $name } não tem comprimento: escreva qualquer vetor ao longo dela, como (1; 0; 0)
the-resultant-of-all-forces-equals-the-difference-quotient-of-the-momentum = a resultante de todas as forças é igual à razão incremental da quantidade de movimento
the-sum-of-all-moments-equals-the-difference-quotient-of-the-angular-momentum = a soma de todos os momentos é igual à razão incremental do momento angular
the-body-has-no-moment-of-inertia-about-the-axis-of-the-last-joint-a-couple-cannot-determine-its = o corpo não tem momento de inércia em relação ao eixo da última junta: um binário não determina a sua aceleração
the-contact-name-would-have-to-pull-contact-is-lost-and-the-motion-changes = o contato { $name } teria de puxar: perde-se o contato e o movimento muda
the-driving-torque-is-given-and-the-acceleration-of-the-last-joint-too-leave-that-at-zero-or-let-the = são dados o torque motor e também a aceleração da última junta: deixe esta em zero, ou deixe o torque ser calculado
the-forces-of-the-supports-balance-all-others = as forças dos apoios equilibram todas as outras
the-moments-of-the-supports-balance-all-others = os momentos dos apoios equilibram todos os outros
the-positions-or-the-loads-exceed-the-numerical-range-check-their-units = as posições ou as cargas excedem a faixa numérica: confira as unidades
the-supports-are-statically-indeterminate-count-of-their-unknowns-unknowns-are-too-many-for-the-six = os apoios são estaticamente indeterminados: { $count } das suas { $unknowns } incógnitas são demais para as seis equações, e { $names } podem tensionar-se mutuamente sem carga alguma; libere um deles, como uma força axial ou um binário
the-supports-hold-the-body-against-turning-about-name-use-the-given-motion-with-its-acceleration = os apoios impedem o corpo de girar em torno de { $name }: use o movimento dado, com a sua aceleração
the-supports-leave-the-body-free-to-move-along-axis-and-this-motion-with-these-loads-requires-a-force = os apoios deixam o corpo livre para mover-se ao longo de { $axis }, e este movimento com estas cargas requer uma força ali: acrescente um apoio que resista a ela
the-supports-leave-the-body-free-to-turn-about-axis-and-this-motion-with-these-loads-requires-a = os apoios deixam o corpo livre para girar em torno de { $axis }, e este movimento com estas cargas requer um momento ali: acrescente um apoio ou um acionamento, ou deixe a aceleração ser calculada
the-supports-leave-count-of-the-six-motions-free-no-load-does-work-in-them-now-but-nothing-restrains = os apoios deixam livres { $count } dos seis movimentos: nenhuma carga realiza trabalho neles agora, mas nada restringe o corpo ali
the-wire-name-would-have-to-push-it-goes-slack-and-the-motion-changes = o fio { $name } teria de empurrar: ele afrouxa e o movimento muda

# rigid-body/dynamic-equilibrium
hinged-body-on-a-rotating-shaft = Corpo articulado em um eixo que gira
equilibrium-angle-of-a-rod-plate-or-particle-hinged-to-a-rotating-shaft-or-the-speed-for-a-given = Ângulo de equilíbrio de uma haste, placa ou partícula articulada a um eixo giratório, ou a velocidade para um ângulo dado; sua estabilidade e as forças na articulação.
forces-grow-with-it-angle-and-speed-do-not-depend-on-it = As forças crescem com ela; ângulo e velocidade não dependem dela.
distance-of-the-pin-from-the-axis-of-the-shaft = Distância do pino ao eixo de rotação
slender-rod-or-plate-hung-by-an-edge = Haste delgada, ou placa suspensa por uma aresta
particle-on-a-light-rod = Partícula em uma haste leve
body-symmetrical-about-the-line-from-the-pin-to-g = Corpo simétrico em relação à linha do pino a G
distance-of-g-from-the-pin = Distância de G ao pino
radius-of-gyration-along-the-line-m-k-dm-from-the-pin = Raio de giração ao longo da linha: m k² = ∫ ξ² dm a partir do pino
radius-of-gyration-normal-to-the-line-m-k-dm = Raio de giração transversal à linha: m k² = ∫ η² dm
angle-of-the-body = Ângulo do corpo
the-inertia-forces-grow-with-dm-dm = As forças de inércia crescem com ∫ ξ² dm − ∫ η² dm
maximum-moment-of-the-weight-about-the-pin = Momento máximo do peso em relação ao pino
speed-above-which-the-body-leaves-the-vertical-cos-1 = Velocidade acima da qual o corpo deixa a vertical: cos θ = 1
speed-above-which-the-body-leaves-the-vertical = Velocidade acima da qual o corpo deixa a vertical
distance-of-g-from-the-axis-of-the-shaft = Distância de G ao eixo de rotação
force-of-the-pin-towards-the-shaft-it-keeps-g-on-its-circle = Força do pino em direção ao eixo: mantém G em seu círculo
force-of-the-pin-upwards = Força do pino para cima
force-of-the-pin-towards-the-shaft = Força do pino em direção ao eixo
the-moments-of-the-inertia-forces-and-of-the-weight-about-the-pin = os momentos das forças de inércia e do peso em relação ao pino
the-potential-of-weight-and-centrifugal-forces-is-stationary-there = o potencial do peso e das forças centrífugas é estacionário ali
dm-along-the-line-from-the-pin = ∫ ξ² dm ao longo da linha, a partir do pino
dm-normal-to-the-line = ∫ η² dm transversal à linha
the-lengths-and-the-speed-are-too-disparate-for-an-angle-to-be-found = os comprimentos e a velocidade são díspares demais para se achar um ângulo
a-body-hinged-on-the-axis-itself-hangs-straight-down-at-every-speed-give-another-angle-or-the-speed = um corpo articulado no próprio eixo pende na vertical em qualquer velocidade: dê outro ângulo, ou a velocidade
moment-of-the-inertia-forces-about-the-pin-per-unit = Momento das forças de inércia em relação ao pino, por unidade de ω²
no-speed-holds-the-body-at-this-angle-the-inertia-forces-lift-it-away-from-the-shaft-but-never-to-the = nenhuma velocidade mantém o corpo neste ângulo: as forças de inércia o afastam do eixo, mas nunca até o nível do pino
speed-at-which-the-moments-about-the-pin-cancel = Velocidade em que os momentos em relação ao pino se cancelam
moments-about-the-pin-d-sin-cos-m-g-r-sin-which-gives-cos = Momentos em relação ao pino: D ω² sen θ cos θ = m g r sen θ, o que dá cos θ
equilibrium-angle-of-the-body = Ângulo de equilíbrio do corpo
too-slow-to-leave-the-vertical-cos-would-exceed-1 = Lento demais para deixar a vertical: cos θ seria maior que 1
root-of-m-a-r-cos-d-sin-cos-m-g-r-sin-between-the-downward-vertical-and-the-horizontal = Raiz de ω² (m a r cos θ + D sen θ cos θ) = m g r sen θ entre a vertical descendente e a horizontal
stiffness-of-the-restoring-moment = Rigidez do momento restaurador
angular-frequency-of-small-oscillations-about-this-angle-at-constant-speed = Frequência angular das pequenas oscilações em torno deste ângulo, com a rotação constante
angular-frequency-of-small-oscillations = Frequência angular das pequenas oscilações
the-body-does-not-stay-at-this-angle-a-small-push-drives-it-further-away = o corpo não permanece neste ângulo: um pequeno empurrão o afasta ainda mais
the-body-and-the-shaft = O corpo e o eixo
couple-required-to-hold-the-body-at-an-angle = Binário necessário para manter o corpo em um ângulo
equilibrium = Equilíbrio
angle-against-the-speed-of-the-shaft = Ângulo em função da velocidade do eixo

# rigid-body/rate-of-change, rigid-body/rotation-chain
transport-term-of-due-to-the-rotation-of-the-body-relative-to-the-moving-frame = Termo de transporte de ω devido à rotação do corpo em relação ao referencial móvel
angular-velocity-of-name-about-its-fixed-axis = Velocidade angular de { $name }, em torno do seu eixo fixo

# rigid-body/reactions
speed-at-which-the-force-of-name-is-zero-its-static-part-plus-a-part-proportional-to = Velocidade em que a força de { $name } se anula: parte estática mais parte proporcional a ω²
speed-at-which-the-support-force-is-zero = Velocidade em que a força no apoio se anula
the-force-of-name-at-the-speed-at-which-it-vanishes = a força de { $name } na velocidade em que se anula

# Topics
inertia-and-momentum = Inércia e quantidade de movimento
motion-in-space = Movimento no espaço
bodies-on-rotating-shafts = Corpos em rotação em torno de um eixo
gyroscopes-and-vehicles = Giroscópios e veículos
free-bodies-and-tops = Corpos livres e piões
rolling-bodies = Rolamento sem deslizamento

### Published cases

# dipping_rail.toml
locomotive-at-95-km-h = Locomotiva a 95 km/h
one-rail-dips-by-6-mm-in-0-1-s-in-simple-harmonic-motion = Um trilho rebaixa-se 6 mm em 0,1 s, em movimento harmônico simples.
dip-of-10-m-with-the-couple-of-the-roll-acceleration = Rebaixo de 10 m com o binário da aceleração de rolagem
closed-form-c-i-a-2v-d-t-w-and-2-t-w = forma fechada: C = I_a (2v/D) (πδ/t)/w e α = 2π²δ/(t² w)
v-20-m-s-t-0-5-s-40-rad-s-8-0-005-1-6-rad-s = v = 20 m/s, t = 0,5 s, ω = 40 rad/s, α = 8π² · 0,005/1,6 rad/s².
level-track = Via nivelada
closed-form-no-dip-no-couple = forma fechada: sem rebaixo, sem binário
wheels-at-rest = Rodas paradas
a-dip-of-a-given-length-is-passed-in-v = um rebaixo de dado comprimento é percorrido em λ/v

# dynamic_equilibrium.toml
rod-hinged-on-the-axis-of-a-shaft = Haste articulada sobre o eixo de rotação
closed-form-cos-3-g-2-l-as-in-the-entrance-examination-of-the-jee = forma fechada: cos θ = 3 g/(2 ω² L), como no exame de admissão JEE
l-0-6-m-at-7-rad-s-cos-14-715-29-4-0-500510-it-leaves-the-vertical-at-3-g-2l-4-95227-rad-s = L = 0,6 m a 7 rad/s: cos θ = 14,715/29,4 = 0,500510; deixa a vertical a √(3 g/2L) = 4,95227 rad/s.
the-same-rod-below-its-critical-speed = A mesma haste abaixo da sua velocidade crítica
closed-form-it-hangs-straight-down-when-3-g-2-l = forma fechada: pende na vertical quando ω² < 3 g/(2 L)
small-oscillations-at-p-3-g-2-l-24-525-16-s = Pequenas oscilações com p² = 3 g/(2 L) − ω² = 24,525 − 16 s⁻².
speed-for-a-rod-at-60 = Velocidade para uma haste a 60°
closed-form-3-g-2-l-cos = forma fechada: ω² = 3 g/(2 L cos θ)
l-0-6-m-2-24-525-small-oscillations-with-p-sin = L = 0,6 m: ω² = 2 · 24,525; pequenas oscilações com p² = ω² sen² θ.
conical-pendulum = Pêndulo cônico
closed-form-cos-g-l = forma fechada: cos θ = g/(ω² L)
l-0-981-m-so-that-l-2-g-at-20-rad-s-60 = L = 0,981 m, de modo que ω² L = 2 g a √20 rad/s: θ = 60°.
chair-of-a-merry-go-round = Cadeira de um carrossel
closed-form-tan-a-l-sin-g = forma fechada: tan θ = ω² (a + L sen θ)/g
a-4-m-l-5-m-at-45-9-81-4-3-535534-small-oscillations-with-p-g-cos-a-sin-l-cos-2-l = a = 4 m, L = 5 m a 45°: ω² = 9,81/(4 + 3,535534); pequenas oscilações com p² = (g cos θ + ω² (a sen θ − L cos 2θ))/L.
chair-of-a-merry-go-round-from-its-speed = Cadeira de um carrossel, a partir da velocidade
inverse-of-the-preceding-case-9-81-4-5-2 = Inverso do caso anterior: ω² = 9,81/(4 + 5/√2).
thick-bar-on-the-axis = Barra grossa sobre o eixo
closed-form-cos-g-r-k-k = forma fechada: cos θ = g r/(ω² (k_ξ² − k_η²))
r-0-2-m-k-0-06-m-k-0-01-m-at-8-rad-s-cos-1-962-3-2-c-1-962-0-05-s-small-oscillations-with-p-sin-0-05 = r = 0,2 m, k_ξ² = 0,06 m², k_η² = 0,01 m² a 8 rad/s: cos θ = 1,962/3,2, ω_c² = 1,962/0,05 s⁻²; pequenas oscilações com p² = ω² sen² θ · 0,05/0,07.
angle-above-the-horizontal-through-the-pin = Ângulo acima da horizontal pelo pino
closed-form-cos-3-g-2-l-is-positive = forma fechada: cos θ = 3 g/(2 ω² L) é positivo
rod-on-the-axis-hanging-down = Haste sobre o eixo, pendente na vertical
closed-form-it-remains-there-at-any-speed = forma fechada: permanece ali a qualquer velocidade

# edge_mill.toml
roller-of-350-kg = Rolo de 350 kg
edge-runner-chile-mill-in-closed-form-n-m-g-m-r-2 = moinho de galgas (moinho chileno) em forma fechada: N = m g + m r Ω²/2
the-contact-force-of-the-disc-is-3433-5-492-1875-n-for-any-arm-the-hinge-pulls-the-arm-down-with-492 = A força de contato do disco é 3433,5 + 492,1875 N para qualquer braço; a articulação puxa o braço para baixo com 492,1875 N.
twice-the-weight = O dobro do peso
closed-form-m-g-i-a-r = forma fechada: m g = I_a Ω²/r
for-a-solid-roller-2-g-r-19-62-0-5-rad-s-two-rollers-press-with-4-m-g-the-edges-slip-at-b-2 = Para um rolo maciço Ω = √(2 g/r): √(19,62/0,5) rad/s. Dois rolos pressionam com 4 m g; as bordas escorregam a Ω b/2.
mill-at-rest = Moinho em repouso
closed-form-at-rest-the-contact-force-equals-the-weight-of-the-roller = forma fechada: em repouso a força de contato é igual ao peso do rolo
less-than-the-weight = Menos que o peso
the-force-is-m-g-i-a-r = a força é m g + I_a Ω²/r

# free_axisymmetric.toml
flat-body-8-rad-s-at-25 = Corpo achatado, 8 rad/s a 25°
tan-t-r-a-h-g-i-t-1-r-a-beer-johnston-dynamics-18-3 = tan θ = ω_t/(r ω_a), φ̇ = H_G/I_t, ψ̇ = (1 − r) ω_a: Beer & Johnston, Dynamics, §18.3
spin-and-precession-have-opposite-senses-retrograde = Rotação própria e precessão têm sentidos opostos: retrógrada.
satellite-struck-by-a-meteorite-motion-after-the-impact = Satélite atingido por um meteorito, movimento após o impacto
beer-johnston-dynamics-sample-problem-18-6 = Beer & Johnston, Dynamics, problema resolvido 18.6
two-thin-discs-of-0-8-m-each-m-2-on-a-light-rod-of-1-6-m-i-a-0-32-m-and-i-t-0-8-m-in-m-r-0-4-spinning = Dois discos finos de 0,8 m, cada um com m/2, em uma haste leve de 1,6 m: I_a = 0,32 m e I_t = 0,8 m em m², r = 0,4. Girando a 60 rpm, recebe m₀ v₀ a = 1,6 m: ω_t = 2 rad/s.
plate-thrown-at-45 = Placa lançada a 45°
g-r-fowles-g-l-cassiday-analytical-mechanics-problem-9-9-thin-square-plate-at-45-to-its-axis-one = G. R. Fowles, G. L. Cassiday, Analytical Mechanics, problema 9.9: placa quadrada fina, ω a 45° do seu eixo, uma volta por segundo
the-earth = A Terra
g-r-fowles-g-l-cassiday-analytical-mechanics-problem-9-13-i-s-i-1-00327-at-0-2-to-the-axis = G. R. Fowles, G. L. Cassiday, Analytical Mechanics, problema 9.13: I_s/I = 1,00327, ω a 0,2″ do eixo
euler-s-period-of-a-rigid-earth-1-0-00327-days-the-actual-chandler-period-is-longer-since-the-earth = Período de Euler de uma Terra rígida, 1/0,00327 dias; o período real, de Chandler, é mais longo, pois a Terra não é rígida.
capsule-of-2-mg = Cápsula de 2 Mg
r-c-hibbeler-engineering-mechanics-dynamics-12th-ed-problem-21-71-by-tan-t-r-a-h-g-i-t-1-r-a = R. C. Hibbeler, Engineering Mechanics: Dynamics, 12ª ed., problema 21-71, por tan θ = ω_t/(r ω_a), φ̇ = H_G/I_t, ψ̇ = (1 − r) ω_a
space-station-of-four-shells-at-20 = Estação espacial de quatro cascas, a 20°
j-l-meriam-l-g-kraige-engineering-mechanics-dynamics-sample-problem-7-9 = J. L. Meriam, L. G. Kraige, Engineering Mechanics: Dynamics, problema resolvido 7/9
four-thin-shells-of-mass-m-and-radius-r-2-r-from-the-hub-i-zz-56-3-m-r-and-i-xx-32-3-m-r-here-m-1-kg = Quatro cascas finas de massa m e raio r, a 2 r do cubo: I_zz = 56/3 m r² e I_xx = 32/3 m r²; aqui m = 1 kg e r = 1 m. A estação dá uma volta de rotação própria em 4 s.
space-station-of-four-shells-small-nutation = Estação espacial de quatro cascas, nutação pequena
precession-revolutions-per-spin-revolution-at-a-small-tilt-i-zz-i-xx-i-zz-the-sign-shows-that-their = Voltas de precessão por volta da rotação própria, com pequena inclinação, φ̇/ψ̇ = I_zz/(I_xx − I_zz); o sinal mostra que têm sentidos opostos.
free-body-of-a-regression-test = Corpo livre de um teste de regressão
kynema-fmb-regression-test-of-a-precessing-body-i-1-1-0-5-0-5-0-5-1-attitude-after-5-s = Kynema-FMB, teste de regressão de um corpo em precessão: I = (1; 1; 0,5), ω₀ = (0,5; 0,5; 1), atitude após 5 s
the-closed-form-a-rotation-about-h-after-a-rotation-about-the-axis-agrees-with-integration-to-twelve = A forma fechada, uma rotação em torno de H depois de uma rotação em torno do eixo, concorda com a integração em doze algarismos.
stored-value-from-a-second-order-method-with-steps-of-0-01-s-the-closed-form-is-0-630514 = Valor guardado de um método de segunda ordem com passos de 0,01 s; a forma fechada é −0,630514.
stored-value-from-a-second-order-method-with-steps-of-0-01-s-the-closed-form-is-0-604805 = Valor guardado de um método de segunda ordem com passos de 0,01 s; a forma fechada é 0,604805.
stored-value-from-a-second-order-method-with-steps-of-0-01-s-the-closed-form-is-0-303124 = Valor guardado de um método de segunda ordem com passos de 0,01 s; a forma fechada é −0,303124.
the-same-body-by-its-closed-form = O mesmo corpo, pela forma fechada
rotation-by-h-t-i-t-about-h-after-rotation-by-1-r-z-t-about-z = rotação de |H| t/I_t em torno de H, depois da rotação de (1 − r) ω_z t em torno de z
spacecraft-of-9000-kg-m-5-s-later = Espaçonave de 9000 kg·m², 5 s depois
pennsylvania-state-university-aersp-309-homework-11-problem-1-values-from-the-closed-form = Pennsylvania State University, AERSP 309, lista 11, problema 1; valores pela forma fechada
relative-to-the-body-precesses-about-the-axis-at-r-1-a-2-16-rad-s-the-spin-with-the-opposite-sign = Em relação ao corpo, ω precessiona em torno do eixo a (r − 1) ω_a = 2,16 rad/s, a rotação própria com o sinal oposto.
the-flat-body-by-its-angular-momentum = O corpo achatado, pelo momento angular
the-first-case-with-h-g-i-t = o primeiro caso, com H_G = I_t φ̇
the-flat-body-by-its-precession = O corpo achatado, pela precessão
inverse-of-the-first-case = inverso do primeiro caso
ball = Esfera
with-equal-moments-of-inertia-is-along-h = com momentos de inércia iguais, ω fica ao longo de H
i-a-above-twice-the-transverse-moment = I_a acima do dobro do momento transversal
i-z-i-x-i-y-for-a-thin-plate-and-less-for-every-other-body = I_z = I_x + I_y para uma placa fina, e menor para qualquer outro corpo
spin-of-a-ball = Rotação própria de uma esfera
a-sphere-does-not-spin-about-an-axis-while-it-rotates-about-h = uma esfera não tem rotação própria em torno de um eixo enquanto gira em torno de H
angular-momentum-of-a-ratio = Momento angular a partir de uma razão
h-g-without-the-moments-of-inertia-does-not-determine-the-angular-velocity = H_G sem os momentos de inércia não determina a velocidade angular

# free_triaxial.toml
body-of-1-2-and-3-kg-m = Corpo de 1, 2 e 3 kg·m²
l-d-landau-e-m-lifshitz-mechanics-37-the-solution-by-elliptic-functions = L. D. Landau, E. M. Lifshitz, Mechanics, §37: a solução por funções elípticas
integration-agrees-to-twelve-digits = A integração concorda em doze algarismos.
flips-about-the-intermediate-axis = Inversões em torno do eixo intermediário
growth-rate-i-i-i-i-i-i-and-half-period-2-k-k-p-landau-lifshitz-mechanics-37 = taxa de crescimento ω₂ √((I₂ − I₁)(I₃ − I₂)/(I₁ I₃)) e meio período 2 K(k)/p: Landau & Lifshitz, Mechanics, §37
spun-about-the-intermediate-axis-with-a-disturbance-of-0-001-rad-s-about-the-other-two-like-a-tennis = Girado em torno do eixo intermediário com uma perturbação de 0,001 rad/s em torno dos outros dois, como uma raquete ou uma porca borboleta.
beside-the-unstable-axis-10-s = Ao lado do eixo instável, 10 s
taylor-series-to-thirty-digits = série de Taylor com trinta algarismos
beside-the-unstable-axis-100-s = Ao lado do eixo instável, 100 s
telephone-spun-about-its-intermediate-axis = Telefone girado em torno do eixo intermediário
polhode-around-the-axis-of-the-smallest-moment = Polódia em torno do eixo do menor momento
euler-s-equations-by-taylor-series-to-twenty-digits-and-h-2-t-i-on-the-separatrix = equações de Euler por série de Taylor com vinte algarismos, e H² = 2 T I na separatriz
the-moment-about-x-is-the-intermediate-one = O momento em torno de x é o intermediário.
growth-rate-of-a-homogeneous-box-i-b-i-a-i-c-i-b-i-a-i-c = taxa de crescimento de um paralelepípedo homogêneo, ω √((I_b − I_a)(I_c − I_b)/(I_a I_c))
n-0-2-kg-75-mm-by-150-mm-by-8-mm-spun-about-its-intermediate-axis-the-shorter-one-in-its-plane-at-one = 0,2 kg, 75 mm por 150 mm por 8 mm, girado em torno do eixo intermediário, o mais curto do seu plano, a uma volta e meia por segundo.
body-of-revolution = Corpo de revolução
with-i-x-i-y-the-elliptic-functions-are-circular-period-2-1-r-z = com I_x = I_y as funções elípticas são circulares: período 2π/|ψ̇|, ψ̇ = (1 − r) ω_z
the-free-body-of-rigid-body-free-axisymmetric-at-5-s-is-rotated-by-2-5-rad-about-z-in-the-opposite = O corpo livre de rigid-body/free-axisymmetric: ω em 5 s está girada de 2,5 rad em torno de z, no sentido contrário.
permanent-rotation = Rotação permanente
a-body-spinning-exactly-about-a-principal-axis-continues-to-do-so = um corpo posto a girar exatamente em torno de um eixo principal continua assim
separatrix = Separatriz
h-2-t-i-with-the-intermediate-moment-6-2-2-12-4-1 = H² = 2 T I com o momento intermediário: 6 · 2 · 2² = 12 · 4 · 1²
y-goes-from-a-to-a-as-a-hyperbolic-tangent-a-1-6-6-2-8-4-5-5-and-p-4-6-6-8-a-z-with-a-z-1-8-2-12-6-11 = ω_y vai de −A a A como uma tangente hiperbólica: A² = 1 + 6 · 6 · 2²/(8 · 4) = 5,5 e p = √(4 · 6/(6 · 8)) A_z com A_z² = 1 + 8 · 2/(12 · 6) = 11/9.
moments-of-inertia-of-no-real-body = Momentos de inércia que nenhum corpo real tem
each-moment-of-inertia-is-at-most-the-sum-of-the-other-two = cada momento de inércia é no máximo a soma dos outros dois
what-does-not-turn-has-no-motion = o que não gira não tem movimento

# gyroscopic_couple.toml
ship-that-steers-to-the-left = Navio em curva para a esquerda
rotor-of-3500-kg-clockwise-seen-from-the-stern-part-a-the-bow-is-raised-the-reaction-points-to = Rotor de 3500 kg, horário visto da popa; item (a). A proa se levanta: a reação aponta para boreste, −y.
ship-that-pitches-bow-falling = Navio que arfa, proa descendo
part-b-simple-harmonic-12-in-all-period-40-s-the-bow-is-pushed-to-port-the-reaction-points-up = Item (b): harmônico simples, 12° ao todo, período de 40 s. A proa é empurrada para bombordo: a reação aponta para cima.
aircraft-that-turns-to-the-left = Aeronave em curva para a esquerda
engine-and-propeller-clockwise-seen-from-the-rear-the-nose-is-raised = Motor e hélice, horários vistos de trás: o nariz se levanta.
turbine-of-a-ship-that-turns-to-the-left = Turbina de um navio em curva para a esquerda
the-bow-is-raised = A proa se levanta.
the-book-takes-0-37-rad-s-for-the-precession-which-is-0-3704-rad-s = o livro toma 0,37 rad/s para a precessão, que é 0,3704 rad/s
largest-couple-and-acceleration-of-a-pitching-ship = Binário e aceleração máximos de um navio que arfa
n-20-t-6-in-30-s-with-the-bow-rising-and-the-rotor-clockwise-from-the-stern-the-bow-goes-to-starboard = 20 t, ±6° em 30 s. Com a proa subindo e o rotor horário visto da popa, a proa vai para boreste.
pitching-ship-12-in-all = Navio que arfa, 12° ao todo
khurmi-gupta-theory-of-machines-ch-14-example-14-9 = Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.9
the-same-ship-steers = O mesmo navio em curva
n-16-1-knots-of-1855-m-h-on-100-m-the-couple-of-the-turn-is-m-k-v-r-500-100-16-1-1855-3600-100-n-m = 16,1 nós de 1855 m/h em 100 m; o binário da curva é m k² ω v/R = 500 · 100π · (16,1 · 1855/3600)/100 N·m.
ship-that-turns-to-the-right = Navio em curva para a direita
ship-whose-bow-rises = Navio cuja proa sobe
ship-that-rolls = Navio que balança
turbine-on-a-turn-to-port = Turbina em uma curva para bombordo
freemathhelp-com-thread-110138 = freemathhelp.com, tópico 110138
the-thread-has-no-answer-m-k-2v-d-810-150-0-005-n-m-the-bow-is-raised = O tópico não traz resposta: m k² ω · 2v/D = 810 · 150π · 0,005 N·m. A proa se levanta.
flywheel-on-a-ship = Volante em um navio
irodov-problems-in-general-physics-ship-with-a-flywheel-on-a-fore-and-aft-shaft = Irodov, Problems in General Physics, navio com um volante em um eixo longitudinal
bearings-of-a-ship-s-turbine = Mancais da turbina de um navio
meriam-kraige-dynamics-sample-problem-7-8 = Meriam & Kraige, Dynamics, problema resolvido 7/8
counter-clockwise-seen-from-the-stern-turn-to-port-at-25-knots-12-85-m-s-a-is-the-bearing-aft-0-6-m = Anti-horário visto da popa, curva para bombordo a 25 nós, 12,85 m/s. A é o mancal de trás, a 0,6 m de G, como mostram os sinais publicados.
the-book-rounds-both-shares-to-three-digits = o livro arredonda as duas parcelas a três algarismos
disc-between-bearings = Disco entre mancais
disc-at-the-middle-of-a-100-mm-span-precession-of-60-rpm-about-the-vertical-the-sense-is-the-one-for = Disco no meio de um vão de 100 mm, precessão de 60 rpm em torno da vertical. O sentido é aquele em que A empurra para cima e B para baixo.
the-book-rounds-the-moment-of-inertia-to-0-014-kg-m = o livro arredonda o momento de inércia para 0,014 kg·m²
disc-on-an-overhung-axle = Disco em um eixo em balanço
precession-about-an-axis-at-60-to-the-axle = Precessão em torno de um eixo a 60° do eixo do rotor
closed-form-i-a-sin-i-a-i-t-sin-cos = forma fechada: I_a ω Ω sen θ + (I_a − I_t) Ω² sen θ cos θ
i-a-2-i-t-1-2-kg-m-50-rad-s-4-rad-s-200-3-0-8-16-3-4-n-m-about-y-on-the-carrier = I_a = 2, I_t = 1,2 kg·m², ω = 50 rad/s, Ω = 4 rad/s: 200√3 + 0,8 · 16 · √3/4 N·m, em torno de −y do veículo.
engine-across-a-rolling-ship = Motor transversal em um navio que balança
closed-form-i-a-a-2-t-and-i-t-a-2-t = forma fechada: I_a ω A 2π/T e I_t A (2π/T)²
a-0-1-rad-t-2-s-p-0-1-rad-s-and-0-1-rad-s-100-200-0-1-n-m-and-60-0-1-n-m = A = 0,1 rad, T = 2π s: ω_p = 0,1 rad/s e α = 0,1 rad/s²; 100 · 200 · 0,1 N·m e 60 · 0,1 N·m.
no-spin-and-no-second-support = Sem rotação própria e sem segundo apoio
the-sum-of-moments-only-a-rotating-angular-momentum-supports-the-axle = a soma dos momentos: só um momento angular que gira sustenta o eixo
bearings-without-a-mass = Mancais sem massa informada
the-bearing-forces-include-the-weight = as forças nos mancais incluem o peso

# heavy_top.toml
top-of-0-5-kg-at-35-160-rad-s = Pião de 0,5 kg a 35°, 160 rad/s
the-quadratic-of-steady-precession-i-t-i-a-cos-i-a-k-0-beer-johnston-dynamics-18-3 = a equação do segundo grau da precessão estacionária (I_t − I_a) cos θ φ̇² − I_a ψ̇ φ̇ + K = 0, Beer & Johnston, Dynamics, §18.3
moments-of-inertia-about-the-tip-in-the-equations-of-motion-integrated-from-either-precession-the = Momentos de inércia em relação à ponta. Nas equações do movimento, integradas a partir de qualquer das duas precessões, o ângulo permanece constante. A frequência angular das pequenas nutações é √(V″/I_t), com o potencial efetivo V(θ).
the-same-top-by-its-angular-velocity-about-the-axis = O mesmo pião, pela velocidade angular em torno do eixo
the-quadratic-of-steady-precession-i-t-cos-i-a-k-0-goldstein-classical-mechanics-5-7 = a equação do segundo grau da precessão estacionária I_t cos θ φ̇² − I_a ω₃ φ̇ + K = 0, Goldstein, Classical Mechanics, §5-7
sleeping-top = Pião adormecido
stability-of-the-upright-top-i-a-4-i-t-k-goldstein-classical-mechanics-5-7 = estabilidade do pião em pé, I_a² ω₃² ≥ 4 I_t K: Goldstein, Classical Mechanics, §5-7
a-hundredth-of-a-degree-off-the-vertical-represents-the-upright-position-what-happens-5-above-and = Um centésimo de grau fora da vertical representa a posição vertical. O que acontece 5 % acima e abaixo do limiar está entre os casos de rigid-body/top-nutation.
spin-for-a-precession-of-5-228-rad-s = Rotação própria para uma precessão de 5,228 rad/s
top-of-30-rev-s-fast = Pião de 30 rev/s, rápido
horizontal-axis = Eixo horizontal
at-90-the-quadratic-is-linear-k-i-a = com θ = 90° a equação do segundo grau é linear: φ̇ = K/(I_a ψ̇)
the-fast-top-formula-is-exact-here-the-transverse-moment-is-given-about-the-centre-of-mass-4-10-0-5-0 = A fórmula do pião rápido é exata aqui. O momento transversal é dado em relação ao centro de massa: 4·10⁻⁴ + 0,5 · 0,06² kg·m².
without-spin-i-a-i-t-cos-k = sem rotação própria (I_a − I_t) cos θ φ̇² = K
a-hanging-top-can-precess-without-spin-in-either-sense = Um pião pendurado pode precessionar sem rotação própria, nos dois sentidos.
the-first-case-with-80-rad-s-the-threshold-is-104-16-rad-s = o primeiro caso com 80 rad/s: o limiar é 104,16 rad/s
no-spin = Sem rotação própria
a-top-that-does-not-spin-falls = um pião sem rotação própria cai
no-precession = Sem precessão
a-top-whose-axis-does-not-precess-falls = um pião cujo eixo não precessiona cai

# impulse.toml
meteorite-striking-a-spinning-satellite = Meteorito que atinge um satélite em rotação
the-satellite-is-modelled-as-two-thin-discs-of-radius-a-800-mm-each-of-half-its-mass-joined-by-a = O satélite é modelado como dois discos finos de raio a = 800 mm, cada um com metade da sua massa, unidos por uma haste leve de comprimento 2a; gira a 60 rpm. O meteorito, de um milésimo da sua massa, bate com um braço a em relação a G a 2000 m/s, e sua massa é desprezada depois. m = 1000 kg é escolhida aqui; ela se cancela.
hanging-plate-struck-at-a-corner = Placa suspensa golpeada em um canto
beer-johnston-dynamics-sample-problem-18-1 = Beer & Johnston, Dynamics, problema resolvido 18.1
the-plate-hangs-from-two-wires-and-is-struck-at-right-angles-to-itself-the-wires-exert-no-impulse-in = A placa pende de dois fios e é golpeada perpendicularmente a si mesma; os fios não exercem impulso nessa direção. O livro dá letras: v_G = −F Δt/m k, |ω_x| = 6 F Δt/(m b), |ω_y| = 6 F Δt/(m a); m = 12 kg, a = 0,5 m, b = 0,3 m, F Δt = 4 N·s são escolhidos aqui. Os sinais dependem do canto.
disc-that-falls-on-a-hook = Disco que cai sobre um gancho
hibbeler-engineering-mechanics-dynamics-11th-ed-problem-21-30 = Hibbeler, Engineering Mechanics: Dynamics, 11ª ed., problema 21-30
n-19-lb-1-5-ft-in-diameter-falls-flat-from-a-height-of-2-5-ft-a-hook-catches-its-rim-g-32-2-ft-s-as = 19 lb, 1,5 ft de diâmetro, cai deitado de uma altura de 2,5 ft; um gancho o prende pela borda. g = 32,2 ft/s² como no livro.
plate-on-a-ball-and-socket-struck-at-a-corner = Placa sobre rótula golpeada em um canto
hibbeler-engineering-mechanics-dynamics-11th-ed-problem-21-31 = Hibbeler, Engineering Mechanics: Dynamics, 11ª ed., problema 21-31
square-plate-of-4-kg-and-200-mm-hanging-by-a-corner-o-60-n-s-along-x-at-the-adjacent-corner-the = Placa quadrada de 4 kg e 200 mm, pendurada por um canto O; 60 N·s ao longo de −x no canto adjacente. O impulso em si não está na página disponível; seu valor decorre da reação publicada.
square-plate-seized-along-an-edge = Placa quadrada presa de repente por uma aresta
huston-liu-dynamics-of-mechanical-systems-9-12 = Huston & Liu, Dynamics of Mechanical Systems, §9.12
the-plate-turns-about-its-diagonal-then-an-edge-is-suddenly-fixed-with-m-1-kg-a-1-m-1-rad-s-the-speed = A placa gira em torno da diagonal; depois uma aresta é fixada de repente. Com m = 1 kg, a = 1 m, Ω = 1 rad/s, a velocidade depois é a razão √2/8, e o momento angular em relação à aresta é o coeficiente √2/24 de m a² Ω.
weight-of-a-hollow-cube-from-its-angular-impulse = Peso de um cubo oco a partir do impulso angular
beer-johnston-dynamics-sculpture-cube-of-18-1 = Beer & Johnston, Dynamics, cubo (escultura) do §18.1
a-hollow-cube-of-six-sheets-of-5-ft-rotates-about-its-vertical-diagonal-12-5-lbf-for-1-2-s-at-a = Um cubo oco de seis chapas de 5 ft gira em torno da sua diagonal vertical. 12,5 lbf durante 1,2 s em um canto, perpendicularmente ao plano da diagonal e do canto; depois uma volta leva 5 s, 12 rpm. Seu raio de giração é a √(5/18) = 2,635231 ft em relação a todo eixo por G; as 100 lb se cancelam.
rod-struck-at-its-end = Haste golpeada na extremidade
closed-form-v-g-j-m-6-j-m-l-the-instantaneous-axis-lies-l-6-beyond-the-middle = forma fechada: v_G = J/m, ω = 6 J/(m L); o eixo instantâneo fica L/6 além do meio
level-rod-whose-end-hits-a-smooth-floor = Haste horizontal cuja extremidade bate em um piso liso
closed-form-j-1-m-v-4 = forma fechada: J = (1 + ε) m v/4
m-2-kg-l-1-2-m-v-4-m-s-0-j-2-n-s-v-g-3-m-s-down-3-v-2-l = m = 2 kg, L = 1,2 m, v = 4 m/s, ε = 0: J = 2 N·s, v_G = 3 m/s para baixo, ω = 3 v/(2 L).
ball-that-bounces-with-0-8 = Bola que quica com ε = 0,8
closed-form-v-v = forma fechada: v′ = ε v
putty-that-sticks-to-the-end-of-a-rod = Massa de vidraceiro que gruda na extremidade de uma haste
closed-form-momenta-of-rod-and-putty-together = forma fechada: quantidades de movimento da haste e da massa de vidraceiro juntas
rod-of-2-kg-and-1-2-m-struck-at-its-end-by-0-5-kg-of-putty-at-10-m-s-normal-to-the-rod-g-moves-by-0 = Haste de 2 kg e 1,2 m, atingida na extremidade por 0,5 kg de massa de vidraceiro a 10 m/s, na direção normal à haste: G desloca-se 0,12 m, I = 0,384 kg·m², H = 2,4 kg·m²/s.
point-moving-away-from-the-surface = Ponto que se afasta da superfície
rod-held-along-its-own-axis = Haste presa ao longo do próprio eixo
mass-for-a-wanted-speed-of-a-body-without-a-fixed-axis = Massa para uma velocidade desejada de um corpo sem eixo fixo

# mass_properties.toml
three-rods-along-the-axes = Três hastes ao longo dos eixos
closed-form-three-equal-rods-m-l-at-right-angles-welded-at-their-ends = forma fechada: três hastes iguais m, L em ângulo reto, soldadas pelas extremidades
about-o-i-x-2-m-l-3-no-products-about-g-at-l-6-from-each-plane-i-x-m-l-2-i-xy-m-l-12-principal = Em relação a O: I_x = 2 m L²/3, sem produtos. Em relação a G, a L/6 de cada plano: I_x = m L²/2, I_xy = −m L²/12; momentos principais m L²/2 ± …: 2 m L²/3 em relação à reta (1; 1; 1), 5 m L²/12 transversalmente a ela.
u-shaped-rod = Haste em U
hibbeler-engineering-mechanics-dynamics-11th-ed-problem-21-13 = Hibbeler, Engineering Mechanics: Dynamics, 11ª ed., problema 21-13
two-legs-of-1-ft-joined-by-a-cross-piece-of-1-ft-1-5-lb-ft = Duas pernas de 1 ft unidas por uma travessa de 1 ft, 1,5 lb/ft.
solid-cone-about-a-generator = Cone maciço em relação a uma geratriz
hibbeler-engineering-mechanics-dynamics-11th-ed-problem-21-12 = Hibbeler, Engineering Mechanics: Dynamics, 11ª ed., problema 21-12
the-line-runs-through-the-apex-along-a-generator-the-page-shows-g-32-2-ft-s-but-its-0-0962-needs-the = A reta passa pelo vértice ao longo de uma geratriz. A página mostra g = 32,2 ft/s², mas o seu 0,0962 exige a libra-massa (g = 32,174): com 32,2 seria 0,0961.
solid-cone-about-a-generator-in-si = Cone maciço em relação a uma geratriz, no SI
hibbeler-engineering-mechanics-dynamics-14th-ed-in-si-units-problem-21-9 = Hibbeler, Engineering Mechanics: Dynamics, 14ª ed. em unidades do SI, problema 21-9
n-3-20-m-r-4-h-r-r-h-3-10-m-r-h-r-h-2-08125-1-0125 = 3/20 m (r² + 4 h²) r²/(r² + h²) + 3/10 m r² h²/(r² + h²) = 2,08125 + 1,0125.
slender-rod-about-its-end = Haste delgada em relação à extremidade
standard-tables-of-mass-moments-of-inertia-meriam-kraige-dynamics-table-d-4-per-unit-mass = tabelas usuais de momentos de inércia de massa (Meriam & Kraige, Dynamics, tabela D/4), por unidade de massa
quarter-of-a-ring-about-its-centre = Quarto de anel em relação ao seu centro
thin-half-disc-about-the-centre-of-its-circle = Meio disco fino em relação ao centro do seu círculo
thin-rectangular-plate-about-a-corner = Placa retangular fina em relação a um canto
thin-right-angled-triangle-about-its-right-angle = Triângulo retângulo fino em relação ao ângulo reto
half-cylinder-about-the-middle-of-its-axis = Meio cilindro em relação ao meio do seu eixo
cone-about-its-apex = Cone em relação ao vértice
conical-shell-about-its-apex = Casca cônica em relação ao vértice
hemispherical-shell-about-its-centre = Casca semiesférica em relação ao centro
paraboloid-about-its-vertex = Paraboloide em relação ao vértice
tetrahedron-about-its-corner = Tetraedro em relação ao canto
bent-plate = Placa dobrada
meriam-kraige-dynamics-sample-problem-7-6-the-moments-used-in-its-solution = Meriam & Kraige, Dynamics, problema resolvido 7/6: os momentos da sua resolução
part-a-125-mm-by-100-mm-in-the-plane-yz-part-b-75-mm-by-150-mm-parallel-to-xz-at-y-125-mm-70-kg-m-i = Parte A, 125 mm por 100 mm, no plano yz; parte B, 75 mm por 150 mm, paralela a xz em y = 125 mm; 70 kg/m². I_xy = m_B · 37,5 mm · 125 mm.
hollow-cube-of-six-sheets = Cubo oco de seis chapas
beer-johnston-dynamics-sculpture-cube-of-18-1-i-0-2778-m-a-about-any-line-through-g = Beer & Johnston, Dynamics, cubo (escultura) do §18.1: I = 0,2778 m a² em relação a qualquer reta por G
with-m-1-kg-and-a-1-m-the-numbers-are-those-of-m-a-all-axes-through-g-are-equivalent-5-18-m-a = Com m = 1 kg e a = 1 m os números são os de m a². Todos os eixos por G são equivalentes: 5/18 m a².
hollow-box-of-six-plates = Caixa oca de seis placas
beer-johnston-dynamics-problem-18-7-the-box-of-problem-18-6-made-of-plates = Beer & Johnston, Dynamics, problema 18.7: o paralelepípedo do problema 18.6, feito de placas
base-0-3-m-by-0-3-m-height-0-6-m-5-kg-over-10-a-of-plate-i-37-60-m-a-and-i-z-3-10-m-a = Base de 0,3 m por 0,3 m, altura de 0,6 m, 5 kg em 10 a² de placa. Iₓ = 37/60 m a² e I_z = 3/10 m a².
spoked-wheel = Roda de raios
closed-form-rim-hub-and-two-rods-through-the-middle = forma fechada: aro, cubo e duas hastes pelo meio
i-z-0-75-2-12-0-004-i-0-375-1-12-2-3-0-004-0-0064-12 = I_z = 0,75 + 2/12 + 0,004; Iₓ = 0,375 + 1/12 + 2 (3 · 0,004 + 0,0064)/12.
satellite-of-two-discs = Satélite de dois discos
beer-johnston-dynamics-sample-problem-18-6-its-moments-of-inertia = Beer & Johnston, Dynamics, problema resolvido 18.6: seus momentos de inércia
i-z-m-a-2-i-i-y-5-m-a-4-with-m-1000-kg-a-0-8-m = I_z = m a²/2, Iₓ = I_y = 5 m a²/4 com m = 1000 kg, a = 0,8 m.
square-plate-with-a-round-hole = Placa quadrada com furo circular
closed-form-a-hole-is-a-negative-mass = forma fechada: um furo é uma massa negativa
m-10-0-4-kg-about-o-i-z-10-6-0-4-0-04-2-0-04-and-i-10-12-0-4-0-01 = m = 10 − 0,4 π kg; em relação a O, I_z = 10/6 − 0,4 π (0,04/2 + 0,04) e Iₓ = 10/12 − 0,4 π · 0,01.
disc-with-its-axis-along-1-1-1 = Disco com o eixo ao longo de (1; 1; 1)
closed-form-i-i-t-1-i-a-i-t = forma fechada: I = I_t 1 + (I_a − I_t) λ λᵀ
plate-rotated-by-an-euler-angle-of-45 = Placa girada de um ângulo de Euler de 45°
closed-form-mohr-circle-of-the-plate = forma fechada: círculo de Mohr da placa
the-long-side-lies-along-1-1-0-i-xy-m-a-12-m-b-12-2-0 = O lado maior fica ao longo de (−1; 1; 0): I_xy = (m a²/12 − m b²/12)/2 < 0.
triangle-on-its-edge = Triângulo em pé sobre um lado
closed-form-the-triangular-plate-in-the-plane-zx-its-legs-along-z-and-x = forma fechada: a placa triangular no plano zx, com os catetos ao longo de z e x
leg-a-along-z-leg-b-along-x-i-zx-m-a-b-36-about-g-and-m-a-b-12-about-the-right-angle = Cateto a ao longo de z, cateto b ao longo de x: I_zx = −m a b/36 em relação a G e m a b/12 em relação ao ângulo reto.
inertia-known-about-a-point-required-about-g = Inércia conhecida em relação a um ponto, pedida em relação a G
closed-form-parallel-axis-theorem-back-to-g = forma fechada: teorema dos eixos paralelos, de volta a G
m-10-kg-d-0-2-0-2-0-2-m-each-moment-loses-0-8-each-product-0-4-kg-m = m = 10 kg, d = (0,2; 0,2; 0,2) m: cada momento perde 0,8, cada produto 0,4 kg·m².
inertia-given-by-radii-of-gyration = Inércia dada pelos raios de giração
closed-form-i-m-k = forma fechada: I = m k²
k-y-0-4-m-and-a-distance-of-0-3-m-k-l-0-5-m = k_y = 0,4 m e uma distância de 0,3 m: k_L = 0,5 m.
a-hole-as-large-as-the-body = Um furo tão grande quanto o corpo
a-moment-larger-than-the-two-others = Um momento maior que os dois outros
refusal-the-triangle-inequality = recusa: a desigualdade triangular
products-of-inertia-too-large-for-the-moments = Produtos de inércia grandes demais para os momentos
refusal-not-positive-definite = recusa: não é definida positiva
density-of-a-line = Massa específica de uma linha
a-bore-wider-than-the-cylinder = Um furo mais largo que o cilindro
sphere-about-a-corner = Esfera em relação a um canto
line-without-direction = Reta sem direção

# momentum.toml
disc-on-an-axle-rolling-about-a-fixed-point = Disco em um eixo, rolando em torno de um ponto fixo
beer-johnston-dynamics-sample-problem-18-2 = Beer & Johnston, Dynamics, problema resolvido 18.2
disc-of-radius-r-at-the-end-of-an-axle-og-of-length-l-which-is-pivoted-at-o-the-disc-spins-at-about = Disco de raio r na ponta de um eixo OG de comprimento L, articulado em O; o disco gira a ω₁ em torno do eixo e rola no piso: O e o ponto de contato estão em repouso. O livro dá letras; m = 3 kg, r = 150 mm, L = 400 mm, ω₁ = 20 rad/s são escolhidos aqui: ω_y = −r ω₁/L, H_Oz = 0, T = m r² (6 + r²/L²) ω₁²/8.
box-turning-about-its-diagonal = Paralelepípedo que gira em torno da diagonal
beer-johnston-dynamics-problem-18-6-9th-to-12th-ed = Beer & Johnston, Dynamics, problema 18.6 (9ª à 12ª ed.)
solid-box-a-by-a-by-2a-with-m-1-kg-a-1-m-and-1-rad-s-the-magnitude-is-the-coefficient-of-m-a = Paralelepípedo maciço de a por a por 2a. Com m = 1 kg, a = 1 m e ω = 1 rad/s, o módulo é o coeficiente de m a² ω.
hollow-box-turning-about-its-diagonal = Caixa oca que gira em torno da diagonal
beer-johnston-dynamics-problem-18-7-the-box-of-problem-18-6-made-of-six-plates = Beer & Johnston, Dynamics, problema 18.7: o paralelepípedo do problema 18.6, feito de seis placas
no-published-answer-i-i-y-37-60-m-a-i-z-3-10-m-a-h-g-m-a-2-37-60-6-10-6-its-angle-to-the-diagonal = Sem resposta publicada. Iₓ = I_y = 37/60 m a², I_z = 3/10 m a²: |H_G| = m a² ω √(2 (37/60)² + (6/10)²)/√6, seu ângulo com a diagonal arccos((37/60 · 2 + 6/10 · 2)/(√6 √(2 (37/60)² + (6/10)²))).
bent-plate-on-a-shaft = Placa dobrada em um eixo
meriam-kraige-dynamics-sample-problem-7-6 = Meriam & Kraige, Dynamics, problema resolvido 7/6
part-a-in-the-plane-yz-part-b-parallel-to-xz-at-y-125-mm-70-kg-m-30-rad-s-about-z-h-o-i-zx-i-yz-i-z = Parte A no plano yz, parte B paralela a xz em y = 125 mm, 70 kg/m², 30 rad/s em torno de z. H_O = (−I_zx; −I_yz; I_z) ω.
three-particles-on-a-shaft = Três partículas em um eixo
meriam-kraige-dynamics-problem-7-53 = Meriam & Kraige, Dynamics, problema 7/53
particles-m-at-b-0-b-0-b-2b-and-on-the-axis-on-light-rods-30-rad-s-in-the-sense-z-with-m-1-kg-and-b-1 = Partículas m em (b; 0; b), em (0; b; 2b) e no eixo, em hastes leves; 30 rad/s no sentido −z. Com m = 1 kg e b = 1 m.
three-particles-on-a-shaft-linear-momentum = Três partículas em um eixo: quantidade de movimento
the-page-prints-2-m-b-its-own-lines-give-2-m-b-here-m-1-kg-b-1-m-and-1-rad-s = A página imprime √2 m b ω²; suas próprias linhas dão √2 m b ω. Aqui m = 1 kg, b = 1 m e ω = 1 rad/s.
disc-on-an-arm-welded-to-a-shaft = Disco em um braço soldado a um eixo
beer-johnston-statics-and-dynamics-8th-ed-problem-18-46 = Beer & Johnston, Statics and Dynamics, 8ª ed., problema 18.46
the-disc-spins-at-16-rad-s-about-y-on-the-arm-the-shaft-turns-at-8-rad-s-about-x-the-sheet-states-15 = O disco gira a 16 rad/s em torno de y no braço, o eixo gira a 8 rad/s em torno de x. A folha escreve uma vez 15 rad/s; só 16 rad/s dá os seus 23,5 J (15 daria 22,3 J).
beer-johnston-dynamics-10th-11th-ed-disc-of-problems-18-5-18-99-and-18-105 = Beer & Johnston, Dynamics, 10ª/11ª ed., disco dos problemas 18.5, 18.99 e 18.105
i-m-r-4-0-0225-i-z-m-r-2-0-045-kg-m-h-c-i-j-i-z-k = Iₓ = m r²/4 = 0,0225, I_z = m r²/2 = 0,045 kg·m²: H_C = Iₓ ω₁ j + I_z ω₂ k.
slender-satellite-that-ends-in-a-flat-spin = Satélite esbelto que acaba girando transversalmente
major-axis-rule-energy-is-lost-at-constant-angular-momentum-explorer-1 = regra do eixo maior: perde-se energia com o momento angular constante (Explorer 1)
f-1-2-10-6-rad-s-fraction-of-the-energy-lost-1-1-2-6-tables-print-the-speed-as-1-9999999999999998 = ω_f = 1,2 · 10/6 rad/s; fração da energia perdida 1 − 1,2/6. As tabelas imprimem a velocidade como 1,9999999999999998, que é o arredondamento de 2.
angular-velocity-from-the-angular-momentum = Velocidade angular a partir do momento angular
closed-form-i-with-one-product-of-inertia = forma fechada: I⁻¹ com um produto de inércia
i-2-i-y-3-i-z-4-i-xy-1-kg-m-3-5-1-5-5-5-2-5-5-2-4-3-2-rad-s = Iₓ = 2, I_y = 3, I_z = 4, I_xy = 1 kg·m²: ω = ((3 · 5 + 1 · 5)/5; (5 + 2 · 5)/5; 2) = (4; 3; 2) rad/s.
rolling-wheel = Roda que rola
closed-form-t-3-4-m-v = forma fechada: T = 3/4 m v²
a-disc-of-10-kg-and-0-5-m-radius-rolls-at-4-m-s-the-point-of-contact-is-fixed-t-120-j-l-40-n-s-about = Um disco de 10 kg e 0,5 m de raio rola a 4 m/s: o ponto de contato é fixo. T = 120 J, L = 40 N·s, em relação ao ponto de contato 3/2 m r v = 30 kg·m²/s.
rod-turning-about-its-own-axis = Haste girando em torno do próprio eixo
an-axis-without-direction = Um eixo sem direção
points-at-rest-on-a-line-perpendicular-to-the-axis = Pontos em repouso sobre uma reta perpendicular ao eixo

# motion.toml
heavy-top-after-2-s = Pião após 2 s
br-ls-cardona-arnold-2012-heavy-top-benchmark-with-the-reference-values-that-kynema-prints = Brüls, Cardona & Arnold (2012), problema de referência do pião, com os valores de referência que o Kynema imprime
the-centre-of-mass-is-1-m-along-y-from-the-fixed-point-and-the-moments-are-about-the-centre-of-mass = O centro de massa está a 1 m do ponto fixo ao longo de y, e os momentos são em relação ao centro de massa. O Kynema integra com um método de segunda ordem e passos de 2 µs: sua posição erra por 1,6e-6 m. Aceleração angular em relação ao ponto fixo e aceleração do centro de massa em t = 0: um teste irmão parte, em vez disso, de −692,307 rad/s² e −0,654 m/s², que são ω_y ω_z e −g/15, e não as acelerações deste pião.
the-published-position-comes-from-a-second-order-method = A posição publicada vem de um método de segunda ordem.
angular-velocity-of-the-heavy-top-after-2-s = Velocidade angular do pião após 2 s
br-ls-cardona-arnold-2012-heavy-top-benchmark-converged-value-of-exudyn-explicit-lie-group = Brüls, Cardona & Arnold (2012), problema de referência do pião, valor convergido do EXUDYN (integradores explícitos em grupos de Lie)
the-y-component-is-published-converged-to-2e-9-rad-s-the-other-two-are-listed-here-as-computed = O valor publicado é a componente em Y, convergida até 2e-9 rad/s; as outras duas constam aqui como calculadas.
angular-velocity-of-the-heavy-top-after-10-ms = Velocidade angular do pião após 10 ms
the-y-component-is-published-the-other-two-are-listed-here-as-computed = O valor publicado é a componente em Y; as outras duas constam aqui como calculadas.
fast-top-released-at-0-05-rad = Pião rápido solto a 0,05 rad
simo-wong-1991-heavy-symmetrical-top-as-given-in-the-solfec-validation-manual = Simo & Wong (1991), pião simétrico pesado, conforme o manual de validação do Solfec
the-axis-starts-at-rest-and-nutates-between-0-05-rad-cos-0-99875-as-published-and-a-root-of-the-cubic = O eixo parte do repouso e nuta entre 0,05 rad (cos θ = 0,99875, como publicado) e uma raiz da cúbica da integral da energia, 0,0545516902 rad. Nenhum corpo real de 20 kg com o centro de massa a 1 m do ponto tem 5 kg·m² em relação a ele; o movimento depende só de m g l.
free-body-of-revolution-after-5-s = Corpo de revolução livre após 5 s
closed-form-a-rotation-by-h-t-i-t-about-h-after-one-by-1-i-a-i-t-z-t-about-z = forma fechada: uma rotação de |H| t/I_t em torno de H, depois de uma de (1 − I_a/I_t) ω_z t em torno de z
with-i-t-1-i-a-0-5-kg-m-and-0-5-0-5-1-rad-s = Com I_t = 1, I_a = 0,5 kg·m² e ω = (0,5; 0,5; 1) rad/s.
free-body-of-revolution-after-5-s-coarse-integration = Corpo de revolução livre após 5 s, integração grosseira
kynema-regression-test-of-a-precessing-free-body-test-precession = Kynema, teste de regressão de um corpo livre em precessão (test_precession)
the-moments-are-1-1-and-0-5-kg-m = Os momentos são 1, 1 e 0,5 kg·m².
the-published-value-comes-from-a-second-order-method-with-10-ms-steps-and-is-kept-as-a-regression = O valor publicado vem de um método de segunda ordem com passos de 10 ms e é mantido como valor de regressão; a forma fechada dá −0,630514.
the-published-values-come-from-a-second-order-method-with-10-ms-steps-the-closed-form-gives-0-604805 = Os valores publicados vêm de um método de segunda ordem com passos de 10 ms; a forma fechada dá 0,604805; −0,303124; −0,380498.
spinning-up-about-the-axis-of-revolution = Aceleração em torno do eixo de revolução
closed-form-z-z0-m-t-i-a-and-the-transverse-component-rotates-by-i-a-i-t-i-t-z-dt = forma fechada: ω_z = ω_z0 + M t/I_a, e a componente transversal gira de (I_a − I_t)/I_t ∫ω_z dt
examination-question-manchester-1999-with-numbers-chosen-here = Questão de exame (Manchester, 1999) com números escolhidos aqui.
body-near-its-unstable-axis-after-10-s = Corpo perto do seu eixo instável após 10 s
euler-s-equations-by-a-taylor-series-in-30-digits = equações de Euler por uma série de Taylor com 30 algarismos
moments-1-2-and-3-kg-m-rotating-about-the-intermediate-axis-with-small-components-about-the-others = Momentos 1, 2 e 3 kg·m², girando em torno do eixo intermediário com pequenas componentes em torno dos outros.
compound-pendulum-released-from-the-horizontal = Pêndulo físico solto na horizontal
closed-form-2-m-g-a-sin-j-for-a-fall-by = forma fechada: ω² = 2 m g a sen φ/J para uma queda de φ
ends-when-its-line-has-fallen-by-60-at-150-to-the-upward-vertical = Termina quando sua linha caiu 60°, a 150° da vertical para cima.
harmonic-torque-about-a-principal-axis = Torque harmônico em torno de um eixo principal
closed-form-m-i-1-cos-t = forma fechada: ω = M/(I Ω) (1 − cos Ω t)
from-rest-with-m-0-8-n-m-i-2-kg-m-3-rad-s-t-2-s-with-phase-0-the-torque-is-a-sine-entered-with-zero = A partir do repouso, com M = 0,8 N·m, I = 2 kg·m², Ω = 3 rad/s, t = 2 s; com fase 0 o torque é um seno. Dado com produtos de inércia nulos.
products-of-inertia-of-no-real-body = Produtos de inércia que nenhum corpo real tem
closed-form-the-moments-1-2-of-the-plane-xy-are-not-both-positive = forma fechada: os momentos 1 ± 2 do plano xy não são ambos positivos
rod-released-from-the-horizontal-about-its-end = Haste solta na horizontal, em torno da extremidade
closed-form-3-g-sin-l-for-a-fall-by = forma fechada: ω² = 3 g sen φ/l para uma queda de φ
the-rod-is-defined-as-a-whole-along-x-from-its-end-at-the-origin-at-the-end-it-has-fallen-through-60 = A haste é definida por inteiro, ao longo de x a partir da extremidade na origem; no fim ela caiu 60°, com ω² = 3 · 9,81 · sen 60°/0,8.

# rate_of_change.toml
dumbbell-on-a-vertical-axis = Haltere em um eixo vertical
university-of-manchester-pc167-sheet-4-question-1 = University of Manchester, PC167, folha 4, questão 1
particles-of-1-5-kg-at-0-4-m-on-either-side-on-a-light-rod-50-from-the-z-axis-at-12-rad-s-h-2-m-l-sin = Partículas de 1,5 kg a 0,4 m de cada lado em uma haste leve, a 50° do eixo z, a 12 rad/s: H = 2 m l² ω sen θ, M = 2 m l² ω² sen θ cos θ. Posições no plano xz.
oblique-rod-on-an-axle = Haste oblíqua em um eixo
irodov-problems-in-general-physics-oblique-rod-rotating-on-an-axle = Irodov, Problems in General Physics, haste oblíqua que gira em um eixo
published-in-symbols-m-1-12-m-l-sin-along-the-axle-m-sin-change-over-half-a-revolution-1-12-m-l-sin-2 = Publicado em símbolos: M = (1/12) m l² ω sen θ, ao longo do eixo M sen θ, variação em meia volta (1/12) m l² ω sen 2θ, momento (1/24) m l² ω² sen 2θ. Aqui m = 2 kg, l = 0,8 m, θ = 65°, ω = 10 rad/s.
rod-of-example-4 = Haste do exemplo 4
riul-unit-ii-example-4 = Riul, Unidade II, exemplo 4
m-2-kg-b-0-4-m-10-rad-s-the-rod-25-below-the-horizontal-towards-x-m-z-1-6-m-b-sin-50 = m = 2 kg, b = 0,4 m, ω = 10 rad/s, a haste 25° abaixo da horizontal, no sentido de x: M_z = −(1/6) m b² ω² sen 50°.
disc-on-an-arm-r-0-203-m = Disco em um braço, r = 0,203 m
riul-unit-ii-example-3 = Riul, Unidade II, exemplo 3
here-r-0-203-m-the-notes-print-h-3-63-r-j-21-78-r-k-the-radius-is-given-in-a-lost-figure-of-which = Aqui r = 0,203 m: as notas imprimem H = 3,63 r² j + 21,78 r² k; o raio está em uma figura perdida, da qual só se conhece a cota 0,406 m.
disc-on-an-arm-r-0-1015-m = Disco em um braço, r = 0,1015 m
here-r-0-1015-m-the-notes-print-h-3-63-r-j-21-78-r-k-the-radius-is-given-in-a-lost-figure-of-which = Aqui r = 0,1015 m: as notas imprimem H = 3,63 r² j + 21,78 r² k; o raio está em uma figura perdida, da qual só se conhece a cota 0,406 m.
disc-on-an-arm-r-0-406-m = Disco em um braço, r = 0,406 m
here-r-0-406-m-the-notes-print-h-3-63-r-j-21-78-r-k-the-radius-is-given-in-a-lost-figure-of-which = Aqui r = 0,406 m: as notas imprimem H = 3,63 r² j + 21,78 r² k; o raio está em uma figura perdida, da qual só se conhece a cota 0,406 m.
plate-welded-to-an-accelerating-shaft = Placa soldada a um eixo acelerado
university-homework-square-plate-on-a-vertical-shaft-at-30 = Lista de exercícios universitária, placa quadrada em um eixo vertical a 30°
a-plate-of-1-kg-and-side-2-m-is-welded-at-the-midpoint-o-of-an-edge-y-along-its-centre-line-30-from = Uma placa de 1 kg e lado 2 m é soldada pelo meio O de uma borda, y ao longo de sua linha média, a 30° do eixo; 3 rad/s, crescendo a 5 rad/s².
the-same-disc-from-axes-fixed-in-it = O mesmo disco, em eixos fixos nele
closed-form-i-z-turned-by-90-about-z = forma fechada: I_z ω₁ω₂ girado de 90° em torno de z
disc-of-4-kg-and-0-2-m-on-an-arm-at-5-rad-s-spinning-at-10-rad-s-a-quarter-of-a-revolution-later-the = Disco de 4 kg e 0,2 m em um braço a 5 rad/s, girando a 10 rad/s, um quarto de volta depois: o binário 4 i do braço é −4 j do disco.
four-boxes-on-precession-nutation-and-spin = Quatro paralelepípedos em precessão, nutação e rotação própria
this-program-four-boxes-on-the-chain-3-1-3-with-accelerations-checked-against-the-difference-quotient = este programa: quatro paralelepípedos na cadeia 3-1-3 com acelerações, comparados com a razão incremental de R I Rᵀ ω
no-published-answer-in-axes-that-are-neither-the-fixed-axes-nor-the-body-axes-about-the-fixed-origin = Sem resposta publicada. Em eixos que não são nem os fixos nem os do corpo, em relação à origem fixa.
the-same-four-boxes-in-fixed-axes = Os mesmos quatro paralelepípedos nos eixos fixos
this-program-the-components-of-the-same-vectors-in-the-fixed-axes = este programa: as componentes dos mesmos vetores nos eixos fixos
axis-without-length = Eixo sem comprimento
an-axis-must-have-a-direction = um eixo deve ter uma direção

# reactions.toml
shaft-with-one-arm-that-swings-down = Eixo com um braço que cai
hibbeler-engineering-mechanics-dynamics-14th-ed-problem-21-46-21-41-of-the-12th = Hibbeler, Engineering Mechanics: Dynamics, 14ª ed., problema 21-46 (21-41 da 12ª)
rods-of-5-kg-m-a-shaft-of-3-m-between-a-which-also-takes-the-axial-force-and-b-and-a-branch-of-1-m-at = Hastes de 5 kg/m: um eixo de 3 m entre A, que recebe também a força axial, e B, e um ramo de 1 m a 1 m de A, horizontal neste instante, com o eixo girando livremente a 2 rad/s. O livro dá os módulos das forças transversais; elas apontam do ramo para o eixo, aqui ao longo de −y.
two-spheres-on-opposite-arms = Duas esferas em braços opostos
meriam-kraige-dynamics-4th-ed-problem-7-75 = Meriam & Kraige, Dynamics, 4ª ed., problema 7/75
published-in-symbols-m-r-3-at-each-bearing-in-opposite-senses-here-m-2-kg-r-0-25-m-40-rad-s-shaft-of = Publicado em símbolos: m R ω²/3 em cada mancal, em sentidos opostos. Aqui m = 2 kg, R = 0,25 m, ω = 40 rad/s, eixo de 0,9 m.
plate-that-turns-about-its-diagonal = Placa que gira em torno da diagonal
analytic-couple-m-a-b-b-a-12-a-b-forces-couple-a-b-of-the-kind-of-manchester-pc167-sheet-4 = analítico: binário m a b (b² − a²) ω²/12(a² + b²), forças binário/√(a² + b²); do tipo de Manchester PC167, folha 4
plate-of-4-kg-0-3-m-by-0-5-m-on-bearings-at-the-ends-of-a-diagonal-at-25-rad-s = Placa de 4 kg, 0,3 m por 0,5 m, em mancais nas extremidades de uma diagonal, a 25 rad/s.
skewed-disc-on-its-shaft = Disco inclinado em relação ao seu eixo
disc-of-30-kg-and-0-6-m-diameter-1-out-of-square-at-1200-rev-min-it-is-rigidly-fixed-to-the-shaft = Disco de 30 kg e 0,6 m de diâmetro, 1° fora de esquadro, a 1200 rev/min. É fixado rigidamente ao eixo.
ship-s-rotor-in-a-turn = Rotor de navio em curva
course-handout-on-gyroscopes-example-4-3 = Apostila de curso sobre giroscópios, exemplo 4.3
rotor-of-1000-kg-the-statement-says-100-the-solution-takes-1000-k-200-mm-5000-rev-min-clockwise-seen = Rotor de 1000 kg (o enunciado diz 100, a solução toma 1000), k = 200 mm, 5000 rev/min, horário visto de trás, em uma curva para a esquerda de 500 m a 30 m/s; mancais afastados de 1,2 m. x para a frente, y para bombordo, z para cima; o rotor é posto sobre o eixo da curva, pois a apostila omite a força centrípeta. O mancal com a maior força é calculado aqui: o de trás.
plate-of-1-kg-and-side-2-m-welded-by-the-middle-o-of-an-edge-y-along-its-middle-line-30-from-the = Placa de 1 kg e lado de 2 m soldada pelo meio O de uma aresta; y ao longo da sua linha média, a 30° do eixo, z normal a ela; 3 rad/s, crescendo a 5 rad/s²; sem peso. Nos eixos da placa.
rod-held-at-60-by-a-wire = Haste mantida a 60° por um fio
beer-johnston-dynamics-sample-problem-18-3 = Beer & Johnston, Dynamics, problema resolvido 18.3
rod-of-8-ft-and-40-lbf-pinned-at-a-to-an-axle-that-turns-at-15-rad-s-about-the-vertical-y-held-by-a = Haste de 8 ft e 40 lbf, articulada em A a um eixo que gira a 15 rad/s em torno da vertical y, mantida por um fio horizontal em B; g = 32,2 ft/s².
multiplied-from-rounded-components-of-the-angular-momentum = multiplicado a partir de componentes arredondadas do momento angular
shaft-with-two-rods-driven-from-rest = Eixo com duas hastes, acionado a partir do repouso
beer-johnston-dynamics-sample-problem-18-4-with-its-layout-assumed = Beer & Johnston, Dynamics, problema resolvido 18.4, com a disposição suposta
rods-of-100-mm-and-300-g-on-a-light-shaft-of-600-mm-along-y-at-a-quarter-of-it-along-z-at-three = Hastes de 100 mm e 300 g em um eixo leve de 600 mm: ao longo de y a um quarto dele, ao longo de z a três quartos; 6 N·m; as forças do movimento a 1200 rev/min. À mão: α = 6/(2 · 0,3 · 0,1²/3) = 3000 rad/s², m r ω² = 236,87 N e m r α = 45 N repartidos na razão 3 : 1.
disc-on-an-axle-that-rolls-on-the-floor = Disco em um eixo, rolando no piso
beer-johnston-dynamics-sample-problems-18-2-and-18-5 = Beer & Johnston, Dynamics, problemas resolvidos 18.2 e 18.5
disc-of-3-kg-and-150-mm-on-a-light-axle-of-400-mm-with-a-ball-and-socket-at-o-rolling-on-a-level = Disco de 3 kg e 150 mm em um eixo leve de 400 mm com uma rótula em O, rolando em um piso nivelado a 20 rad/s em torno do eixo: precessiona a r ω₁/L = 7,5 rad/s. A velocidade constante, o piso exerce só uma força normal.
rod-of-example-4-as-a-weld = Haste do exemplo 4, como solda
unbalanced-rotor-between-bearings-a-quarter-turn-later = Rotor desbalanceado entre mancais, um quarto de volta depois
closed-form-m-g-2-and-m-e-2-at-each-bearing = forma fechada: m g/2 e m e ω²/2 em cada mancal
n-10-kg-at-1-mm-from-the-axis-100-rad-s-with-its-heavy-side-up-49-05-n-from-the-weight-and-50-n-from = 10 kg a 1 mm do eixo, 100 rad/s, com o lado pesado para cima: 49,05 N do peso e 50 N do movimento em cada mancal.
box-on-a-turntable = Caixa em uma plataforma giratória
closed-form-r-g = forma fechada: µ = ω² r/g
at-0-3-m-from-the-axis-and-3-rad-s-it-requires-a-friction-of-2-7-9-81-not-to-slide = A 0,3 m do eixo e 3 rad/s, precisa de um atrito de 2,7/9,81 para não deslizar.
sled-pulled-over-a-sliding-floor = Trenó puxado, deslizando sobre um piso
closed-form-n-m-g-friction-n-against-the-sliding = forma fechada: N = m g, atrito µ N contra o deslizamento
a-force-of-10-n-at-the-contact-on-a-particle-of-2-kg-that-a-table-rotates-at-0-rad-s-the-wire-carries = Uma força de 10 N no contato, sobre uma partícula de 2 kg que uma mesa gira a 0 rad/s; o fio suporta o que o atrito de 0,2 não equilibra.
hanging-rod-retained-by-a-wire = Haste pendente retida por um fio
closed-form-the-wire-force-is-zero-at-3-g-2-l-cos-and-m-l-3-sin-m-g-tan-2-at-another-speed = forma fechada: a força no fio é nula com ω² = 3 g/(2 L cos θ), e m L ω²/3 · sen θ − m g tan θ/2 a outra velocidade
rod-of-1-kg-and-0-6-m-hinged-on-the-axis-60-from-the-downward-vertical-with-a-horizontal-wire-from = Haste de 1 kg e 0,6 m articulada sobre o eixo, a 60° da vertical descendente, com um fio horizontal da sua ponta ao eixo; a 10 rad/s, 17,320508 − 8,495709 N.
shaft-kept-from-turning-by-a-key = Eixo impedido de girar por uma chaveta
closed-form-the-couple-of-the-key-is-m-g-e = forma fechada: o binário da chaveta é m g e
n-10-kg-at-0-1-m-to-the-side-of-the-shaft-at-rest-10-9-81-0-1-n-m-about-x = 10 kg a 0,1 m ao lado do eixo, em repouso: 10 · 9,81 · 0,1 N·m em torno de x.
two-bearings-that-both-take-the-axial-force = Dois mancais que recebem ambos a força axial
closed-form-one-equation-along-the-shaft-for-two-forces = forma fechada: uma só equação ao longo do eixo para duas forças
overhung-rotor-on-one-bearing = Rotor em balanço em um só mancal
closed-form-no-support-resists-the-transverse-moment = forma fechada: nenhum apoio resiste ao momento transversal
free-couple-on-a-welded-plate = Binário livre em uma placa soldada
closed-form-a-weld-does-not-let-it-turn = forma fechada: uma solda não o deixa girar

# rod_on_shaft.toml
rod-welded-to-a-vertical-shaft-at-30 = Haste soldada a um eixo vertical, a 30°
the-notes-print-m-1-6-m-b-sin-2-k-and-h-g-1-3-m-b-cos-sin-i-cos-j-in-symbols-the-numbers-are-chosen = As notas imprimem M = −(1/6) m b² ω² sen 2β k e H_G = (1/3) m b² ω cos β (sen β i + cos β j) em símbolos; os números são escolhidos aqui. Com m b² = 0,54 kg·m² e ω = 20 rad/s: M_z = −36 sen 60° N·m, H_G = 1,8 √3 (1/2 i + √3/2 j) kg·m²/s. O ângulo é medido a partir da horizontal.
rod-at-25-to-the-horizontal = Haste a 25° da horizontal
the-published-formula-with-m-2-kg-b-0-4-m-10-rad-s-m-z-16-3-sin-50-n-m = A fórmula publicada com m = 2 kg, b = 0,4 m, ω = 10 rad/s: M_z = −(16/3) sen 50° N·m.
published-in-symbols-with-the-angle-from-the-axle-and-the-length-l-2b-m-1-12-m-l-sin-along-the-axle-m = Publicado em símbolos, com o ângulo θ a partir do eixo e o comprimento l = 2b: M = (1/12) m l² ω sen θ, ao longo do eixo M sen θ, momento sobre o eixo (1/24) m l² ω² sen 2θ. Aqui m = 2 kg, l = 0,8 m, θ = 65°, ω = 10 rad/s.
horizontal-rod-with-angular-acceleration = Haste horizontal com aceleração angular
closed-form-m-i-j-for-a-principal-axis = forma fechada: M = I α j para um eixo principal
at-0-the-shaft-is-a-principal-axis-no-couple-tilts-it-and-i-0-18-50-n-m-accelerates-the-rod = Com β = 0 o eixo de rotação é um eixo principal: nenhum binário o inclina, e I α = 0,18 · 50 N·m acelera a haste.

# rolling_cone.toml
solid-cone-of-25-rolling-at-2-2-rad-s = Cone maciço de 25° rolando a 2,2 rad/s
landau-lifshitz-mechanics-32-problem-7-with-numbers-chosen-here = Landau & Lifshitz, Mechanics, §32, problema 7, com números escolhidos aqui
t-3-m-h-1-5-cos-40-the-normal-force-must-stay-between-the-apex-and-the-edge-of-the-base-0-4414-m-away = T = 3 m h² φ̇² (1 + 5 cos² α)/40. A força normal deve ficar entre o vértice e a borda da base, a 0,4414 m.
conical-shell-given-by-its-angular-velocity = Casca cônica dada pela velocidade angular
closed-form-t-i-a-cos-i-t-sin-2-x-n-l-cos-2-t-tan-m-g-l-cos-g = forma fechada: T = (I_a cos² α + I_t sen² α) ω²/2, x_N = l cos α + 2 T tan α/(m g), μ = φ̇² l cos α/g
n-30-h-0-3-m-m-1-kg-i-a-m-r-2-i-t-m-r-4-h-2-through-the-apex-4-cot-30-rad-s = α = 30°, h = 0,3 m, m = 1 kg: I_a = m r²/2, I_t = m (r²/4 + h²/2) pelo vértice; ω = 4 cot 30° rad/s.
cone-about-to-tip = Cone na iminência de tombar
closed-form-m-g-s-l-cos-i-a-cos-i-t-sin-cot = forma fechada: m g (s − l cos α) = (I_a cos² α + I_t sen² α) cot α φ̇²
the-solid-cone-of-25-at-the-precession-that-brings-the-normal-force-to-the-edge-of-its-base = O cone maciço de 25° na precessão que leva a força normal à borda da sua base.

# rolling_motion.toml
rolling-coin-after-0-5-s = Moeda que rola, após 0,5 s
rill-schaeffer-2010-rolling-coin-with-the-value-published-in-the-exudyn-test = Rill & Schaeffer (2010), moeda que rola, com o valor publicado no teste do EXUDYN
thin-disc-of-10-mm-tilted-by-1-from-the-vertical-released-with-1800-s-about-the-vertical-exudyn-calls = Disco fino de 10 mm inclinado de 1° da vertical, solto com 1800°/s em torno da vertical. O EXUDYN chama os seus momentos (1/2; 1/4; 1/4) m r² de momentos de um anel; são os de um disco fino. Seu valor vem de um cálculo com amortecimento numérico; convergido, x = 2,004947 mm, y = 2,596923 mm.
the-published-value-comes-from-a-run-with-numerical-damping-the-converged-value-is-0-002004947-m = O valor publicado vem de um cálculo com amortecimento numérico; o valor convergido é 0,002004947 m.
the-same-coin-to-all-digits = A mesma moeda, com todos os algarismos
the-equations-of-the-rolling-disc-by-a-runge-kutta-method-with-5000-steps = as equações do disco que rola, por um método de Runge–Kutta com 5000 passos
disc-on-a-steady-circle = Disco em círculo, em regime permanente
closed-form-g-cos-sin-3-a-2-r-cos-4-here-over-half-a-revolution = forma fechada: φ̇² = g cos θ/(sen θ (3 a/2 + r cos θ/4)), aqui ao longo de meia volta
r-0-3-m-a-2-m-70-1-086320525-rad-s-a-r-cos-after-half-a-revolution-the-contact-is-2-a-r-cos-4-2052121 = r = 0,3 m, a = 2 m, θ = 70°: φ̇ = 1,086320525 rad/s, ψ̇ = −φ̇ (a/r + cos θ). Após meia volta o contato está 2 (a + r cos θ) = 4,2052121 m à esquerda de onde começou.
upright-disc-rolling-straight-on = Disco em pé rolando em linha reta
closed-form-x-v-t = forma fechada: x = v t
at-2-m-s-twice-the-minimum-speed-nothing-tilts-it = A 2 m/s, o dobro da velocidade mínima, nada o inclina.
disc-that-falls-over-from-rest-and-lifts-off = Disco que tomba do repouso e salta
closed-form-a-disc-released-on-its-edge-falls-about-the-tangent-at-the-contact-m-g-r-cos-i-t-m-r = forma fechada: um disco solto apoiado na borda tomba em torno da tangente no contato, θ̈ = −m g r cos θ/(I_t + m r²)
with-i-t-m-r-4-4-5-g-cos-80-r-at-the-start-then-8-5-g-r-sin-80-sin-the-normal-force-m-g-z-is-gone = Com I_t = m r²/4: θ̈ = −(4/5) g cos 80°/r no início, depois θ̇² = (8/5)(g/r)(sen 80° − sen θ). A força normal m (g + z̈) se anula onde 0,2 + 2,4 sen² θ = 1,6 sen 80° sen θ, em 28,98°, muito antes de ele ficar deitado.
disc-that-lies-flat-from-the-start = Disco deitado desde o início
closed-form-3-is-below-the-angle-that-counts-as-flat = forma fechada: 3° está abaixo do ângulo que conta como deitado

# rolling_stability.toml
disc-rolling-straight-on = Disco rolando em linha reta
closed-form-v-g-r-3-for-a-thin-disc-routh = forma fechada: v² = g r/3 para um disco fino (Routh)
the-eigenvalues-of-the-equations-linearised-by-differences-are-at-their-limit-there-too = Os autovalores das equações, linearizadas por diferenças, também estão no seu limite ali.
disc-spinning-about-its-vertical-diameter = Disco girando em torno do seu diâmetro vertical
closed-form-g-5-r-4-for-a-thin-disc = forma fechada: Ω² = g/(5 r/4) para um disco fino
stable-above-5-1147-rad-s-at-4-rad-s-a-tilt-grows = Estável acima de 5,1147 rad/s; a 4 rad/s uma inclinação cresce.
hoop-spinning-about-its-vertical-diameter = Aro girando em torno do seu diâmetro vertical
closed-form-g-3-r-2-for-a-thin-hoop = forma fechada: Ω² = g/(3 r/2) para um aro fino
hoop-rolling-straight-on-by-its-radii-of-gyration = Aro rolando em linha reta, pelos raios de giração
closed-form-v-g-r-4-for-a-thin-hoop = forma fechada: v² = g r/4 para um aro fino
k-a-r-and-k-t-r-2 = k_a = r e k_t = r/√2.

# rotation_chain.toml
disc-on-a-tilted-motor = Disco em um motor inclinado
the-disc-turns-at-120-rev-min-about-the-axis-z-of-the-motor-and-the-motor-at-60-rev-min-about-an-axis = O disco gira a 120 rev/min em torno do eixo z do motor, e o motor a 60 rev/min em torno de um eixo no plano yz, 30° acima de y. O programa que acompanha o problema imprime a componente errada da aceleração (0); o vetor tem 68,4 rad/s² em x.
disc-on-a-bent-arm = Disco em um braço dobrado
meriam-kraige-dynamics-sample-problem-7-5 = Meriam & Kraige, Dynamics, problema resolvido 7/5
the-arm-turns-at-3-rad-s-about-the-vertical-which-lies-in-its-plane-yz-at-30-from-z-the-disc-spins-at = O braço gira a 3 rad/s em torno da vertical, que fica no seu plano yz a 30° de z; o disco gira a 8 rad/s em torno de y.
crane-that-turns-and-raises-its-boom = Guindaste que gira e levanta a lança
beer-johnston-dynamics-crane-of-the-sample-problems-of-chapter-15 = Beer & Johnston, Dynamics, guindaste dos problemas resolvidos do cap. 15
the-cab-turns-at-0-30-rad-s-about-the-vertical-y-the-boom-of-12-m-is-at-30-and-rises-at-0-50-rad-s = A cabine gira a 0,30 rad/s em torno da vertical y; a lança de 12 m está a 30° e sobe a 0,50 rad/s em relação à cabine.
multiplied-from-rounded-velocities = multiplicado a partir de velocidades arredondadas
arm-and-disc-of-example-3 = Braço e disco do exemplo 3
the-arm-turns-at-4-rad-s-about-y-the-disc-at-12-rad-s-about-the-z-axis-of-the-arm-4-j-12-k-4-j-12-k = O braço gira a 4 rad/s em torno de y, o disco a 12 rad/s em torno do eixo z do braço: ω = 4 j + 12 k, α = 4 j × 12 k = 48 i rad/s².
precession-nutation-and-spin-in-the-axes-of-the-body = Precessão, nutação e rotação própria nos eixos do corpo
closed-form-sin-sin-cos-y-sin-cos-sin-z-cos-and-their-rates = forma fechada: ωₓ = φ̇ sen θ sen ψ + θ̇ cos ψ, ω_y = φ̇ sen θ cos ψ − θ̇ sen ψ, ω_z = φ̇ cos θ + ψ̇, e suas taxas de variação
euler-angles-about-z-x-and-z-the-components-of-in-axes-fixed-in-the-body-are-the-derivatives-of-those = Ângulos de Euler em torno de z, x′ e z″; as componentes de α nos eixos fixos no corpo são as derivadas das de ω. φ = 0,3 rad não influi.
rotor-of-a-ship-that-pitches = Rotor de um navio que arfa
closed-form-a-p-cos-pt-a-p-sin-pt-j-j-i = forma fechada: θ̇ = A p cos pt, θ̈ = −A p² sen pt, α = θ̈ j + θ̇ j × Ω i
pitching-of-6-with-a-period-of-20-s-2-s-after-mid-position-the-rotor-turns-at-2000-rev-min-about-the = Arfagem de ±6° com período de 20 s, 2 s depois da posição média; o rotor gira a 2000 rev/min em torno do eixo longitudinal. Visto do navio.
wheel-of-a-car-in-a-bend = Roda de um automóvel em curva
closed-form-v-r-k-i = forma fechada: α = v/R k × ω i
n-80-km-h-on-a-circle-of-50-m-to-the-left-the-wheel-rotating-at-600-rev-min-about-the-axis-that = 80 km/h em um círculo de 50 m para a esquerda, a roda girando a 600 rev/min em torno do eixo que aponta para a esquerda, y. Seu centro move-se com o carro, a 50 m do centro da curva.

# spinning_disc_on_arm.toml
disc-on-an-arm-m-3-63-kg = Disco em um braço, m = 3,63 kg
the-notes-print-h-3-63-r-j-21-78-r-k-the-radius-is-given-in-a-figure-that-is-no-longer-available-only = As notas imprimem H = 3,63 r² j + 21,78 r² k. O raio é dado em uma figura que não está mais disponível (dela só se conhece 0,406 m): supõe-se aqui 0,203 m, a metade disso. Com ele r² = 0,041209 m².
disc-of-150-mm-on-arm-abc = Disco de 150 mm no braço ABC
the-published-moments-of-inertia-a-quarter-and-a-half-of-m-r = Os momentos de inércia publicados; um quarto e metade de m r².
kinetic-energy-of-a-disc-on-a-shaft-and-arm = Energia cinética de um disco em eixo e braço
there-the-shaft-turns-about-x-and-the-disc-spins-about-y-here-these-axes-are-called-y-and-z-the = Lá o eixo gira em torno de x e o disco em torno de y; aqui esses eixos chamam-se y e z. O centro está afastado do eixo 180 mm em cada uma de duas direções: √2 · 180 mm.
disc-of-example-3-a-quarter-turn-later-spinning-up = Disco do exemplo 3 um quarto de volta depois, acelerando
closed-form-m-a-i-z-i-i-d-j-i-z-k-turned-by-90-about-y = forma fechada: M_A = I_z ω₁ω₂ i + I_d α₁ j + I_z α₂ k, girado de 90° em torno de y
with-m-r-0-16-kg-m-i-d-0-04-and-i-z-0-08-kg-m-at-90-the-x-axis-of-the-arm-points-along-z-and-its-z = Com m r² = 0,16 kg·m², I_d = 0,04 e I_z = 0,08 kg·m². Em φ = 90° o eixo x do braço aponta para −Z e o seu eixo z para X.

# steady_rolling.toml
thin-hoop-at-62-on-a-circle-of-0-9-m = Aro fino a 62° em um círculo de 0,9 m
hibbeler-dynamics-11th-ed-problem-21-69-solutions-manual-the-numbers-are-chosen-here = Hibbeler, Dynamics, 11ª ed., problema 21-69, manual de soluções; os números são escolhidos aqui
the-manual-gives-a-formula-its-own-moment-equation-m-a-r-sin-m-g-r-cos-m-r-2-a-r-cos-r-sin-m-r-2-a-r = O manual dá uma fórmula. A sua própria equação dos momentos, m a φ̇² r sen θ − m g r cos θ = −(m r²/2) ((a + r cos θ)/r) φ̇² sen θ − (m r²/2)(a/r) φ̇² sen θ, leva a 2 g cos θ = φ̇² sen θ (4 a + r cos θ); a linha impressa em seguida só conserva (a + r cos θ).
an-algebra-error-between-two-printed-lines-4a-r-cos-became-a-r-cos-with-the-moment-equation-as = Um erro de álgebra entre duas linhas impressas: 4a + r cos θ virou a + r cos θ. Com a equação dos momentos como impressa, φ̇ = 1,6752 rad/s, que também deixa θ em repouso nas equações do aro que rola; e em um círculo grande tan(inclinação) = 2 v²/(g a), como deve ser para um aro.
the-same-hoop-by-its-moment-equation = O mesmo aro, pela equação dos momentos
closed-form-2-g-cos-sin-4-a-r-cos-for-a-hoop-its-oscillation-by-the-eigenvalues-of-the-linearised = forma fechada: φ̇² = 2 g cos θ/(sen θ (4 a + r cos θ)) para um aro; a sua oscilação pelos autovalores das equações do movimento linearizadas, independentemente do programa
disc-at-70-from-its-speed = Disco a 70°, a partir da velocidade
closed-form-g-cos-sin-3-a-2-r-cos-4-for-a-disc = forma fechada: φ̇² = g cos θ/(sen θ (3 a/2 + r cos θ/4)) para um disco
the-speed-is-the-value-given-by-the-formula-for-70 = A velocidade é o valor dado pela fórmula para θ = 70°.
coin-wobbling-about-a-centre-at-rest-at-10 = Moeda que bamboleia com o centro em repouso, a 10°
closed-form-with-the-centre-at-rest-a-disc-precesses-with-4-g-r-sin = forma fechada: com o centro em repouso, um disco precessiona com φ̇² = 4 g/(r sen θ)
final-stage-of-the-motion-of-a-coin-on-a-table-radius-37-5-mm = Fase final do movimento de uma moeda em uma mesa, raio de 37,5 mm.
hoop-on-a-large-circle = Aro em um círculo grande
closed-form-tan-lean-2-v-g-a-for-a-hoop-whose-circle-is-much-larger-than-itself = forma fechada: tan(inclinação) = 2 v²/(g a) para um aro cujo círculo é muito maior que ele mesmo
at-a-lean-of-10-on-a-circle-of-3-km-v-g-a-tan-10-2-to-one-part-in-10 = Com inclinação de 10° em um círculo de 3 km: v² = g a tan 10°/2, a uma parte em 10⁵.

# top_nutation.toml
axis-released-from-rest-at-35 = Eixo solto do repouso a 35°
zeros-of-the-cubic-of-energy-and-angular-momenta-goldstein-classical-mechanics-5-7 = zeros da cúbica da energia e dos momentos angulares, Goldstein, Classical Mechanics, §5-7
the-axis-is-momentarily-at-rest-at-its-highest-position-cusps-for-a-fast-top-the-frequency-would-be-i = O eixo fica momentaneamente em repouso na sua posição mais alta: cúspides. Para um pião rápido a frequência seria I_a ω₃/(2π I_t) = 4,63 Hz; aqui fica bem abaixo.
looping-precession = Precessão com laços
zeros-of-the-cubic-period-and-precession-by-quadrature-to-twenty-digits = zeros da cúbica; período e precessão por quadratura com vinte algarismos
looping-precession-from-arbitrary-initial-conditions = Precessão com laços a partir de condições iniciais quaisquer
released-downwards-and-backwards = Solto para baixo e para trás.
unidirectional-precession = Precessão unidirecional
sleeping-top-5-above-its-threshold = Pião adormecido, 5 % acima do limiar
released-0-1-mrad-off-the-vertical-the-same-from-the-integrated-equations = solto a 0,1 mrad da vertical; o mesmo pelas equações integradas
sleeping-top-5-below-its-threshold = Pião adormecido, 5 % abaixo do limiar
it-wakes-up-falls-to-36-and-comes-back = Ele desperta, cai até 36° e volta.
top-of-simo-and-wong = Pião de Simo e Wong
j-c-simo-k-k-wong-unconditionally-stable-algorithms-for-rigid-body-dynamics-int-j-numer-meth-eng-31 = J. C. Simo, K. K. Wong, Unconditionally stable algorithms for rigid body dynamics, Int. J. Numer. Meth. Eng. 31 (1991); posição mais baixa pela cúbica
m-20-g-1-and-l-1-moments-of-inertia-5-and-1-about-the-fixed-point-cosine-of-the-angle-after-10-s-0 = M = 20, g = 1 e l = 1, momentos de inércia 5 e 1 em relação ao ponto fixo. Cosseno do ângulo após 10 s: 0,998530450481.
fast-top-of-the-multibody-benchmarks-2-s = Pião rápido dos problemas de referência de multicorpos, 2 s
o-br-ls-a-cardona-m-arnold-lie-group-generalized-time-integration-of-constrained-flexible-multibody = O. Brüls, A. Cardona, M. Arnold, Lie group generalized-α time integration of constrained flexible multibody systems, Mechanism and Machine Theory 48 (2012), pião; altura do centro de massa em 2 s por integração com treze algarismos, −0,673022269560 m
i-a-0-46875-and-i-t-0-234375-15-1-kg-m-released-with-its-axis-level-with-precession-4-61538-rad-s-its = I_a = 0,46875 e I_t = 0,234375 + 15 · 1² kg·m². Solto na horizontal com precessão de −4,61538 rad/s: seu eixo passa a 0,00004° do ponto mais baixo.
top-without-spin-a-pendulum = Pião sem rotação própria, um pêndulo
half-the-period-of-a-pendulum-released-from-the-horizontal-4-k-1-2-l-g-2 = metade do período de um pêndulo solto na horizontal, 4 K(1/√2) √(l/g)/2
steady-precession = Precessão estacionária
the-slow-root-of-i-t-cos-i-a-k-0 = a raiz lenta de I_t cos θ φ̇² − I_a ω₃ φ̇ + K = 0
transverse-moment-unknown = Momento transversal desconhecido
nutation-depends-on-it = a nutação depende dele

# turn_indicator.toml
level-turn-at-800-km-h = Curva nivelada a 800 km/h
disc-of-200-g-40-mm-10-000-rpm-the-springs-of-500-n-m-100-mm-apart-and-the-radius-of-600-m-complete = Disco de 200 g, 40 mm, 10 000 rpm; as molas de 500 N/m, afastadas de 100 mm, e o raio de 600 m completam os dados.
level-turn-corrected = Curva nivelada, corrigida
closed-form-sin-i-a-2-k-d-2-i-a-i-t = forma fechada: sen θ = I_a ω Ω/(2 k (d/2)² − (I_a − I_t) Ω²)
the-gyroscopic-couple-with-the-axle-horizontal-is-0-062056-n-m-the-part-i-a-i-t-changes-the-angle-in = O momento giroscópico com o eixo do rotor horizontal é 0,062056 N·m. A parte (I_a − I_t) Ω² altera o ângulo no quinto algarismo.
the-indicator-shows-30 = O indicador mostra 30°
closed-form-with-i-a-i-t-i-a-k-sin = forma fechada: com I_a = I_t, I_a ω Ω = K sen θ
n-0-001-100-2-100-0-05-0-5-n-m = 0,001 · 100 · Ω = 2 · 100 · 0,05² · 0,5 N·m.
springs-that-are-too-soft = Molas flexíveis demais
sin-cannot-be-above-1 = sen θ não pode ser maior que 1

# two_bladed_rotor.toml
airscrew-with-two-blades = Hélice de duas pás
n-250-lb-ft-with-g-32-2-ft-s-1600-rpm-150-mph-on-500-ft-the-book-measures-the-blade-angle-from-the = 250 lb·ft² com g = 32,2 ft/s², 1600 rpm, 150 mph em 500 ft. O livro mede as pás a partir do eixo do binário (37°); aqui elas estão a 53° do eixo da precessão: T (1 − cos 2·37°) e T sen 2·37°.
small-component-about-the-axle = Pequena componente em torno do eixo do rotor
closed-form-i-sin-2-2-which-the-book-neglects = forma fechada: I Ω² sen 2χ / 2, que o livro despreza
the-same-propeller-0-44-rad-s = A mesma hélice, 0,44 rad/s.
rod-of-12-kg = Haste de 12 kg
closed-form-a-uniform-rod-blades-parallel-and-normal-to-the-precession-axis = forma fechada: uma haste uniforme, com as pás paralelas e normais ao eixo de precessão
m-l-12-4-kg-m-100-rad-s-and-0-5-rad-s-2-200-n-m-with-the-blades-along-the-axis-of-the-precession-0 = m L²/12 = 4 kg·m², 100 rad/s e 0,5 rad/s: 2 · 200 N·m com as pás ao longo do eixo de precessão, 0 com elas transversais a ele; 200 · √2 a 45°.
symmetric-rotor-as-a-limit = Rotor simétrico como caso-limite
closed-form-with-i-b-i-c-there-is-no-pulsation = forma fechada: com I_b = I_c não há pulsação
i-a-i-b-i-c-for-every-body = I_a ≤ I_b + I_c para todo corpo

# two_wheeler_lean.toml
motorcycle-at-90-km-h = Motocicleta a 90 km/h
speed-for-a-lean-of-45 = Velocidade para uma inclinação de 45°
closed-form-v-g-r-1-i-m-r-h = forma fechada: v² = g R/(1 + I/(m r h))
i-m-r-h-3-5-45-with-the-same-motorcycle-v-490-5-1-7-90-m-s = I/(m r h) = 3,5/45 com a mesma motocicleta: v = √(490,5/(1 + 7/90)) m/s.
without-rotating-parts = Sem partes girantes
closed-form-tan-v-g-r = forma fechada: tan θ = v²/(g R)
v-g-r-45-and-the-tyres-require-1 = v² = g R: 45°, e os pneus precisam de µ = 1.
radius-to-the-track = Raio até o rastro
closed-form-the-speed-for-a-lean-substituted-back = forma fechada: a velocidade para uma inclinação, substituída de volta
at-30-the-centre-of-mass-moves-on-a-radius-of-10-0-5-m-v-g-tan-30-10-9-5-without-rotating-parts = A 30° o centro de massa percorre um raio de 10 − 0,5 m: v² = g tan 30° · 10²/9,5; sem partes girantes.
engine-that-turns-against-the-wheels = Motor que gira ao contrário das rodas
closed-form-i-2-i-w-g-i-e-0-leaves-the-lean-of-a-particle = forma fechada: I = 2 I_w − G I_e = 0 deixa a inclinação de uma partícula
with-the-moments-of-inertia-of-the-whole-vehicle = Com os momentos de inércia do veículo inteiro
closed-form-m-g-h-sin-m-v-h-r-i-v-r-r-cos-j-sin-cos-substituted-back = forma fechada: m g h sen θ = (m v² h/R + I v²/(r R)) cos θ + J Ω² sen θ cos θ, substituída de volta
n-45-j-10-kg-m-v-m-g-h-m-h-r-i-r-r-10-sin-45-r-with-m-h-150-kg-m-i-3-5-kg-m = θ = 45°, J = −10 kg·m²: v² = m g h/(m h/R + I/(r R) − 10 sen 45°/R²) com m h = 150 kg·m, I = 3,5 kg·m².
track-within-the-height-of-the-centre-of-mass = Rastro de raio menor que a altura do centro de massa
the-centre-of-mass-must-stay-on-its-side-of-the-turn = o centro de massa deve ficar do seu lado da curva

# wheel_loads.toml
car-that-turns-to-the-right = Automóvel em curva para a direita
wheels-1-and-3-are-the-inner-ones-1-and-2-in-front-engine-train-of-75-kg-k-100-mm-at-four-times-the = As rodas 1 e 3 são as internas, 1 e 2 as da frente. Conjunto do motor de 75 kg, k = 100 mm, a quatro vezes a rotação das rodas, horário visto de frente. As cargas calculadas equilibram os binários C_W + C_O = 4666,7 N·m; as publicadas, só 2334 N·m.
the-companion-halves-every-load-twice-c-2w-is-already-the-share-of-one-wheel-with-both-sides-at-2-c = o complemento divide cada carga ao meio duas vezes: C/(2w) já é a parcela de uma só roda; com os dois lados em 2 · C/(2w) os momentos em relação ao eixo longitudinal se equilibram
the-companion-halves-every-load-twice = o complemento divide cada carga ao meio duas vezes
car-that-turns-to-the-right-corrected-loads = Automóvel em curva para a direita, cargas corrigidas
moments-about-the-long-and-the-cross-axis-of-khurmi-gupta-example-14-12 = momentos em relação aos eixos longitudinal e transversal de Khurmi & Gupta, exemplo 14.12
trolley-car-with-motors-against-the-wheels = Bonde com motores que giram ao contrário das rodas
two-axles-of-18-kg-m-two-motors-of-12-kg-m-at-five-times-their-speed-in-the-opposite-sense-the = Dois eixos de 18 kg·m², dois motores de 12 kg·m² a cinco vezes a sua rotação, em sentido contrário. As cargas publicadas diferem das calculadas em metade da parcela giroscópica.
the-companion-halves-the-gyroscopic-share-twice-and-the-centrifugal-one-once-7131-74-n-holds-the = o complemento divide a parcela giroscópica ao meio duas vezes e a centrífuga uma; 7131,74 N mantém os momentos em equilíbrio
the-companion-halves-the-gyroscopic-share-twice-and-the-centrifugal-one-once-5130-76-n-holds-the = o complemento divide a parcela giroscópica ao meio duas vezes e a centrífuga uma; 5130,76 N mantém os momentos em equilíbrio
trolley-car-corrected-loads = Bonde, cargas corrigidas
moments-about-the-long-axis-of-khurmi-gupta-example-14-10 = momentos em relação ao eixo longitudinal de Khurmi & Gupta, exemplo 14.10
m-g-4-3333-33-331-85-n-m-2-1-5-m = m g/4 ± (3333,33 − 331,85) N·m/(2 · 1,5 m).
car-with-its-engine-in-the-rear-the-limit = Automóvel com motor traseiro: o limite
engine-at-three-times-the-speed-of-the-wheels-in-the-same-sense-transverse-to-the-car = Motor a três vezes a rotação das rodas, no sentido delas, transversal ao automóvel.
rail-axle-on-a-banked-curve = Rodeiro em curva inclinada
pair-of-wheels-of-200-kg-with-2000-kg-on-it-superelevation-8 = Rodeiro de 200 kg com 2000 kg sobre ele; superelevação de 8°.
rail-axle-with-its-transverse-moment-of-inertia = Rodeiro com seu momento de inércia transversal
closed-form-i-a-cos-i-a-i-t-sin-cos-for-khurmi-gupta-example-14-13 = forma fechada: I_a ω Ω cos β − (I_a − I_t) Ω² sen β cos β para Khurmi & Gupta, exemplo 14.13
with-i-t-i-a-2-the-couple-falls-from-381-961-to-381-650-n-m = Com I_t = I_a/2 o binário cai de 381,961 para 381,650 N·m.
extra-load-from-the-spin-of-the-wheels = Carga adicional devida à rotação das rodas
beer-johnston-dynamics-wheel-of-a-car-on-a-flat-curve-ch-18 = Beer & Johnston, Dynamics, roda de um automóvel em curva plana, cap. 18
each-wheel-22-kg-575-mm-across-k-225-mm-95-km-h-on-150-m-the-mass-of-1200-kg-and-the-height-of-0-5-m = Cada roda com 22 kg, 575 mm de diâmetro, k = 225 mm; 95 km/h em 150 m. A massa de 1200 kg e a altura de 0,5 m completam os dados e não entram na resposta.
the-solution-rounds-an-intermediate-result = a solução arredonda um resultado intermediário
sliding-or-overturning = Deslizamento ou tombamento
closed-form-v-g-r-w-2h-and-v-g-r = forma fechada: v² = g R w/(2h) e v² = µ g R
without-rotating-parts-the-wheels-lift-at-9-81-100-1-5-m-s-and-slide-at-0-64-981-m-s = Sem partes girantes as rodas levantam a √(9,81 · 100 · 1,5) m/s e deslizam a √(0,64 · 981) m/s.
bank-without-side-force = Pista inclinada sem força lateral
closed-form-at-tan-v-g-r-the-road-pushes-along-its-normal-alone = forma fechada: com tan β = v²/(g R) a pista empurra apenas ao longo da sua normal
n-45-v-g-r-all-loads-are-equal-m-g-2-4 = β = 45°, v² = g R: todas as cargas são iguais, m g √2/4.
centre-of-mass-behind-the-rear-axle = Centro de massa atrás do eixo traseiro
a-vehicle-at-rest-needs-its-centre-of-mass-between-its-axles = um veículo em repouso precisa ter o centro de massa entre os eixos
c-i-for-a-ship-with-a-rotor-of-2-2-t-and-320-mm-at-200-rpm = C = I ω Ω, para um navio com rotor de 2,2 t e 320 mm a 200 rpm
a-rotor-that-turns-clockwise-seen-from-aft-lowers-the-bow-in-a-turn-to-the-right-its-reaction-points = Um rotor que gira no sentido horário visto da popa abaixa a proa em uma curva para a direita: sua reação aponta para bombordo, +y.
the-ship-turns-to-starboard-since-the-reaction-points-down = O navio vira para boreste, pois a reação aponta para baixo.
the-ship-rolls-about-an-axis-along-the-axle-so-there-is-no-couple = O navio balança em torno de um eixo ao longo do eixo do rotor: não há binário.
m-g-l-i-a-for-a-top-of-0-50-kg-at-30-rev-s = φ̇ = m g l/(I_a ψ̇), para um pião de 0,50 kg a 30 rev/s
clockwise-seen-from-above-is-negative-the-precession-has-the-sense-of-the-spin = Horário visto de cima é negativo; a precessão tem o sentido da rotação própria.
i-2-k-d-2-sin-for-the-data-of-a-problem-of-beer-johnston-dynamics = I ω Ω = 2 k (d/2)² sen θ, para os dados de um problema de Beer & Johnston, Dynamics
the-centre-of-mass-lies-beyond-the-edge-of-the-base-measured-along-the-line-of-contact-the-cone-tips = o centro de massa está além da borda da base, medido ao longo da geratriz de contato: o cone tomba parado; escreva um centro de massa mais próximo do vértice
wheels-by-mass-and-radius-of-gyration-engine-seen-from-the-rear = Rodas por massa e raio de giração, motor visto de trás
c-w-4-m-k-v-r-r-c-e-i-g-v-r-r-sides-share-m-v-h-r-c-w-w-axles-c-e-l = C_w = 4 m k² v²/(r R), C_e = I G v²/(r R): os lados repartem (m v² h/R + C_w)/w, os eixos C_e/L
counter-clockwise-seen-from-ahead-in-a-turn = Anti-horário visto da frente, em uma curva
the-reaction-on-the-carrier-is-i-with-towards-the-viewer-who-sees-it-counter-clockwise = a reação sobre o veículo é I ω × Ω, com ω para o observador que o vê no sentido anti-horário
clockwise-seen-from-the-right-in-a-turn = Horário visto da direita, em uma curva
counter-clockwise-seen-from-above-bow-rising = Anti-horário visto de cima, proa subindo
counter-clockwise-seen-from-below-left-side-falling = Anti-horário visto de baixo, lado esquerdo descendo
slab-on-a-ball-and-socket-and-three-wires-turned-by-a-couple = Placa sobre uma rótula e três fios, solicitada por um binário
moments-about-the-ball-t-m-g-2-m-y-t-0-4-m-g-m-x-0-8-t-m-z = momentos em relação à rótula: T₁ = m g/2 + M_y, T₂ = (0,4 m g − M_x)/0,8, T₃ = −M_z
ring-quarter-disc-and-ellipse = Coroa, quarto de disco e elipse
plates-m-r-r-4-m-r-4-and-xy-dm-m-r-2-about-the-corner-g-at-4r-3-m-b-4-and-m-a-4 = placas: m(R² + r²)/4; m R²/4 e ∫xy dm = m R²/2π no canto, G em 4R/3π; m b²/4 e m a²/4
hollow-sphere-hemisphere-and-ellipsoid-of-one-density = Esfera oca, hemisfério e elipsoide de mesma densidade
n-2-5-m-r-r-r-r-83-320-m-r-and-2-5-m-r-m-b-c-5-masses-by-the-volumes = 2/5 m(R⁵ − r⁵)/(R³ − r³); 83/320 m R² e 2/5 m R²; m(b² + c²)/5; massas pelos volumes
tube-shell-rod-by-its-far-end-and-two-parts-that-are-given = Tubo, casca, barra pela extremidade distante, e duas partes dadas
m-r-2-h-12-and-m-r-2-3-m-r-m-l-12-at-l-2-before-the-end-m-k-the-matrix-parallel-axis-theorem = m(R²/2 + h²/12) e m R²; 2/3 m R²; m l²/12 a l/2 antes da extremidade; m k²; a matriz; teorema dos eixos paralelos
gate-on-a-hinge-struck-by-a-short-force-and-a-bullet-that-falls-off = Portão em uma dobradiça, atingido por uma força curta e uma bala que cai
i-i-x-f-t-x-p-m-p-v-p-t-i-m-p-v-p-2-the-mass-of-the-bullet-is-neglected-afterwards = I ω = I ω₀ + x F Δt + x_p m_p v_p, T = (I ω₀² + m_p v_p²)/2; a massa da bala é desprezada depois
roller-of-a-given-moment-of-inertia = Rolo de momento de inércia dado
no-slip-r-r-c-i-n-m-g-c-r = sem deslizamento: ω = Ω R/r, C = I ω Ω, N = m g + C/R
wheel-of-given-moments-on-a-circle-of-the-floor = Roda de momentos dados em um círculo do piso
a-r-r-cos-sin-1-a-r-cos-g-cos-with-i-a-m-r-i-t-m-r = a = R − r cos θ, φ̇² sen θ ((1 + α) a + β r cos θ) = g cos θ com I_a = α m r², I_t = β m r²
body-with-two-points-at-rest = Corpo com dois pontos em repouso
body-carried-by-a-turning-arm-about-an-oblique-line = Corpo levado por um braço que gira, em relação a uma reta oblíqua
v-g-r-g-h-g-i-h-b-h-g-r-g-r-b-m-v-g-about-the-line-h-b = v_G = Ω × r_G, H_G = I ω, H_B = H_G + (r_G − r_B) × m v_G, em relação à reta λ · H_B
e-s-e-a-along-the-line-e-of-the-points-at-rest-h-i-v-r-t-m-v-h-2 = ω = e s/(e·a) ao longo da reta e dos pontos em repouso; H = I ω, v = ω × r, T = (m v² + ω·H)/2
rate-of-turn-given = Taxa de curva dada
disc-that-spins-slowly-in-a-fast-turn = Disco que gira devagar, numa curva rápida
sin-i-a-k-d-2-i-a-i-t-with-i-a-m-r-2-i-t-m-r-4 = sen θ = I_a ω Ω/(k d²/2 − (I_a − I_t) Ω²), com I_a = m r²/2, I_t = m r²/4
n-1-5-kg-and-0-12-m-at-30-rad-s-in-a-turn-at-5-rad-s-sin-1-62-3-0-135 = 1,5 kg e 0,12 m a 30 rad/s, em curva a 5 rad/s: sen θ = 1,62/(3 − 0,135).
sin-i-a-k-d-2-i-a-i-t = sen θ = I_a ω Ω/(k d²/2 − (I_a − I_t) Ω²)
particle-on-a-turning-arm-moments-about-another-fixed-point = Partícula em um braço giratório, momentos em relação a outro ponto fixo
h-r-r-a-m-v-and-m-r-r-a-m-a-with-v-r-a-v = H = (r − r_A) × m v e M = (r − r_A) × m a com v = ω × r, a = ω × v
free-top-from-euler-angles-and-their-rates-until-a-component-reverses = Pião livre a partir de ângulos de Euler e suas taxas, até uma componente inverter
h-a-h-cos-1-c-1-a-x-sin-sin-reverses-at = φ̇ = H/A, ψ̇ = H cos θ (1/C − 1/A): ω_x = φ̇ sen θ sen ψ inverte em ψ = π
torque-by-a-table = Torque por uma tabela
m-i-f-dt-a-trapezium-of-1-s-1-s-1-s = ω = (M/I) ∫ f dt: um trapézio de 1 s + 1 s + 1 s
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-14 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.14
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-6 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.6
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-3 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.3
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-4 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.4
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-7 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.7
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-9 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.9
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-2 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.2
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-1 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.1
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-17 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.17
computer-companion-to-meriam-kraige-dynamics-sample-problem-7-2 = Complemento computacional a Meriam & Kraige, Dynamics, problema resolvido 7/2
fossee-companion-to-bevan-the-theory-of-machines-ch-2-example-13 = Complemento FOSSEE a Bevan, The Theory of Machines, cap. 2, exemplo 13
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-15 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.15
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-12 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.12
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-10 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.10
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-11 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.11
fossee-companion-notebook-to-khurmi-gupta-theory-of-machines-ch-14-example-14-13 = Caderno complementar FOSSEE a Khurmi & Gupta, Theory of Machines, cap. 14, exemplo 14.13
the-kinetic-energy-from-the-inertia-about-the-shaft = a energia cinética pela inércia em torno do eixo
the-gyroscopic-couple-is-the-component-of-the-couple-along-x = o momento giroscópico é a componente do binário em x
the-kinetic-energy-of-rotation-from-the-squares-of-both-speeds = a energia cinética de rotação pelos quadrados das duas velocidades
the-kinetic-energy-from-the-moment-of-inertia-about-the-axis-of-the-arm = a energia cinética pelo momento de inércia em torno do eixo do braço
the-resultant-from-its-mean-and-its-pulsating-part-by-the-law-of-cosines = a resultante pela média e pela parte pulsante, com a lei dos cossenos
the-product-of-the-maximum-and-the-minimum-resultant = o produto da resultante máxima pela mínima
the-principal-axis-n-has-length-one = o eixo principal { $n } tem comprimento um
the-radii-of-gyration-from-the-trace-of-the-tensor = os raios de giração pelo traço do tensor
the-radius-of-gyration-about-the-line-from-that-tensor = o raio de giração em torno da reta por esse tensor
the-point-on-the-instantaneous-axis-only-slides-along-it = o ponto do eixo instantâneo apenas desliza ao longo dele
the-angular-momentum-about-the-line-from-the-perpendicular-arm = o momento angular em torno da reta pelo braço perpendicular a ela
the-angle-to-the-line-from-its-cosine = o ângulo com a reta pelo seu cosseno
the-remaining-kinetic-energy-is-half-of-h = a energia cinética restante é a metade de H ω
twice-the-kinetic-energy-of-rotation-is-h-cos = o dobro da energia cinética de rotação é |ω| |H| cos γ
at-the-tipping-speed-the-couple-brings-the-normal-force-to-the-edge = na velocidade de tombamento o binário leva a força normal até a borda
the-length-rolled-on-the-floor-equals-that-on-the-rim = o comprimento rolado no piso é igual ao do aro
the-friction-supplies-the-centripetal-force-of-the-centre-f-a-m-v = o atrito fornece a força centrípeta do centro, F a = m v²
the-stiffness-from-differences-of-the-equations-of-the-rolling-disc = a rigidez por diferenças das equações do disco que rola
the-energy-at-a-limit-where-all-of-it-is-in-the-precession-and-the-height = a energia em um limite, onde toda ela está na precessão e na altura
the-quaternion-has-unit-norm = o quatérnio tem norma unitária
the-angular-velocity-rotated-from-the-body-axes = a velocidade angular, girada a partir dos eixos do corpo
the-angular-momentum-is-r-j-r = o momento angular é R J Rᵀ ω
the-kinetic-energy-is-half-of-h = a energia cinética é a metade de ω · H
the-tracked-axis-rotated-from-the-body-axes = o eixo acompanhado, girado a partir dos eixos do corpo
euler-s-equations-for-a-growing-disturbance = equações de Euler para uma perturbação que cresce
h-over-2t-where-the-component-along-the-intermediate-axis-is-zero = H² sobre 2T onde a componente ao longo do eixo intermediário é nula
lagrange-s-equation-of-with-the-angular-momentum-about-the-axis = equação de Lagrange de θ com o momento angular em torno do eixo
a-slightly-slower-or-faster-precession-requires-more = uma precessão um pouco mais lenta ou mais rápida requer mais
angle-and-its-rate-after-one-nutation = ângulo e sua taxa depois de uma nutação
angular-momentum-about-the-axis-for-each-spin = momento angular em torno do eixo para cada rotação própria
angular-momentum-about-the-axis-from-its-magnitude-and-angle = momento angular em torno do eixo a partir do módulo e do ângulo
transverse-angular-momentum-from-its-magnitude-and-angle = momento angular transversal a partir do módulo e do ângulo
angular-velocity-after-half-a-period-transverse-component-reversed = velocidade angular depois de meio período, com a componente transversal invertida
angular-velocity-after-one-period = velocidade angular depois de um período
equation-of-small-circles-about-the-vertical-at-the-threshold = equação dos pequenos círculos em torno da vertical no limiar
kinetic-energy-where-sn-is-1 = energia cinética onde sn τ é 1
precession-after-one-nutation-at-its-mean-rate = precessão depois de uma nutação com sua taxa média
precession-and-spin-along-the-angular-velocity = precessão e rotação própria ao longo da velocidade angular
precession-and-spin-have-no-component-normal-to-the-angular-velocity = precessão e rotação própria não têm componente normal à velocidade angular
precession-as-the-integral-of-its-rate = precessão como integral de sua taxa
spin-as-the-integral-of-its-rate = rotação própria como integral de sua taxa
square-of-the-frequency-from-the-slope-of-the-effective-potential = quadrado da frequência a partir da inclinação do potencial efetivo
the-attitude-after-one-period-a-rotation-about-the-angular-momentum = a atitude depois de um período, uma rotação em torno do momento angular
the-cones-roll-on-each-other-without-sliding = os cones rolam um sobre o outro sem deslizar
the-rate-required-by-the-precession-of-minimum-rate = a rotação requerida pela precessão de rotação mínima
twice-the-energy-as-angular-momentum-times-angular-velocity-along-it = o dobro da energia como momento angular vezes a velocidade angular ao longo dele
twice-the-kinetic-energy-as-h = o dobro da energia cinética como H ω
n-2-kg-at-0-1-m-beside-the-axis-level-with-it-1-n-m-for-the-acceleration-and-1-962-n-m-against-the = 2 kg a 0,1 m do eixo, na mesma altura: 1 N·m para a aceleração e 1,962 N·m contra o peso.
eccentric-mass-with-angular-acceleration = Massa excêntrica com aceleração angular
over-half-a-revolution-everything-reverses-except-the-angular-momentum-about-the-axis = Em meia volta tudo se inverte, menos o momento angular em torno do eixo
acceleration-of-the-centre-of-mass-at-that-speed-by-finite-differences-of-its-position = aceleração do centro de massa nessa velocidade, por diferenças finitas de sua posição
acceleration-of-the-centre-of-mass-by-finite-differences-of-its-position = aceleração do centro de massa por diferenças finitas de sua posição
the-whole-reaction-of-name-acts-along-it = toda a reação de { $name } atua ao longo dele
angular-momentum-about-the-axis-from-the-motion-just-after-impact = momento angular em torno do eixo a partir do movimento logo após o impacto
angular-momentum-at-the-start-from-the-tensor-about-the-point = momento angular no início a partir do tensor em relação ao ponto
angular-momentum-of-that-mass-about-the-axis-and-the-moments-of-the-blows = momento angular dessa massa em torno do eixo, e os momentos das percussões
change-of-the-angular-momentum-about-the-track-at-the-top-of-the-dip-by-differences = variação do momento angular em torno da via no alto do rebaixo, por diferenças
closed-form-m-e-m-g-e-about-the-shaft = forma fechada: m e² α + m g e em torno do eixo
couple-of-the-engine-from-the-difference-quotient-of-its-angular-momentum = binário do motor a partir do quociente de diferenças de seu momento angular
couple-of-the-spin-from-the-kinetic-energy-by-lagrange-s-equation = binário da rotação própria a partir da energia cinética pela equação de Lagrange
second-derivative-of-the-potential-of-weight-and-centrifugal-forces = segunda derivada do potencial do peso e das forças centrífugas
difference-quotient-of-the-angle-of-the-axle-half-way-down = quociente de diferenças do ângulo do eixo a meio caminho da descida
difference-quotient-of-the-angular-momentum-about-the-axis-of-the-swing = quociente de diferenças do momento angular em torno do eixo da oscilação
energy-at-the-end-less-the-work-of-the-torques = energia no fim, menos o trabalho dos torques
force-of-the-road-towards-the-centre-of-the-curve = força da pista na direção do centro da curva
force-of-the-road-upwards = força da pista para cima
inward-offset-of-the-centre-from-the-contact-from-the-lean = deslocamento do centro para dentro do contato, a partir da inclinação
load-of-the-wheel-that-lifts-first-at-that-speed-from-moments-about-the-others = carga da roda que se levanta primeiro nessa velocidade, a partir dos momentos em torno das outras
mass-times-the-acceleration-of-g-by-finite-differences-of-its-position = massa vezes a aceleração de G, por diferenças finitas de sua posição
mass-times-the-acceleration-of-the-centre-by-finite-differences-of-its-position = massa vezes a aceleração do centro, por diferenças finitas de sua posição
mass-times-the-acceleration-of-the-centre-of-mass-by-finite-differences-of-its-position = massa vezes a aceleração do centro de massa, por diferenças finitas de sua posição
moment-of-inertia-about-the-axis-from-the-tensor-about-the-point-on-it = momento de inércia em torno do eixo a partir do tensor em relação ao ponto sobre ele
moment-of-inertia-of-the-disc-ring-by-ring = momento de inércia do disco, anel por anel
moment-of-inertia-of-the-rod-piece-by-piece = momento de inércia da haste, pedaço por pedaço
moment-of-the-changes-of-both-wheel-loads = momento das variações das cargas das duas rodas
moment-of-the-forces-of-both-rails-from-the-same-difference-quotient = momento das forças dos dois trilhos a partir do mesmo quociente de diferenças
moments-of-centrifugal-force-and-weight-at-g-about-the-road = momentos da força centrífuga e do peso em G em relação à pista
moments-of-the-force-of-the-pin-and-of-the-inertia-couple-about-g = momentos da força do pino e do binário de inércia em torno de G
moments-of-the-loads-from-the-couple-of-the-wheels-from-the-same-difference-quotient = momentos das cargas devidas ao binário das rodas a partir do mesmo quociente de diferenças
moments-of-the-weight-and-of-the-normal-force-about-the-apex = momentos do peso e da força normal em torno do vértice
no-angle-during-the-motion-lies-outside-the-minimum-and-the-maximum = nenhum ângulo durante o movimento sai do intervalo entre o mínimo e o máximo
no-tilt-during-the-motion-lies-outside-the-minimum-and-the-maximum = nenhuma inclinação durante o movimento sai do intervalo entre a mínima e a máxima
normal-force-and-friction-make-up-the-reaction-of-name = força normal e atrito compõem a reação de { $name }
points-of-the-instantaneous-axis-have-no-relative-velocity = os pontos do eixo instantâneo não têm velocidade relativa entre si
second-difference-quotient-of-the-angle-at-the-end-of-the-swing = segundo quociente de diferenças do ângulo no fim da oscilação
second-difference-quotient-of-the-angle-of-the-axle-at-the-top = segundo quociente de diferenças do ângulo do eixo no alto
side-force-and-friction-at-that-speed = força lateral e atrito nessa velocidade
speed-on-the-curve-by-finite-differences-of-the-position = velocidade na curva, por diferenças finitas da posição
speed-over-the-pan-at-the-edge-less-that-of-the-rim = velocidade sobre o prato na borda menos a da periferia
square-of-the-oscillation-frequency-from-the-same-differences = quadrado da frequência de oscilação a partir das mesmas diferenças
square-of-the-oscillation-frequency-or-growth-rate-by-the-general-equation = quadrado da frequência de oscilação ou da taxa de crescimento pela equação geral
the-angle-at-the-end-continued-from-the-previous-instant = o ângulo no fim, continuado a partir do instante anterior
the-angles-of-and-h-from-the-axis-tan-i-t-i-a-tan = os ângulos de ω e H com o eixo, tan θ = (I_t/I_a) tan γ
the-angular-momentum-r-i-r-along-the-axis-of-the-last-joint = o momento angular R I Rᵀ ω ao longo do eixo da última junta
the-angular-momentum-r-i-r-half-a-revolution-later = o momento angular R I Rᵀ ω meia volta depois
the-angular-velocity-at-the-end-continued-from-the-previous-instant = a velocidade angular no fim, continuada a partir do instante anterior
the-attitude-at-the-end-continued-from-the-previous-instant = a atitude no fim, continuada a partir do instante anterior
the-circle-on-the-floor-is-the-given-one = a circunferência no piso é a dada
the-contact-at-the-end-continued-from-the-previous-instant = o contato no fim, continuado a partir do instante anterior
the-driving-torque-from-the-six-equations = o torque motor a partir das seis equações
the-couple-of-the-springs-from-the-displacement-of-their-ends = o binário das molas a partir do deslocamento de suas pontas
the-couple-with-the-axle-horizontal-and-the-contribution-of-the-tilt = o binário com o eixo horizontal, e a contribuição da inclinação
the-direction-is-of-length-one = a direção tem comprimento um
the-dynamic-reactions-from-inertia-force-and-couple-alone = as reações dinâmicas a partir da força e do binário de inércia sozinhos
the-inertia-force-from-the-difference-quotient-of-the-momentum = a força de inércia a partir do quociente de diferenças da quantidade de movimento
the-minimum-and-maximum-angle-continued-from-the-previous-instant = o ângulo mínimo e o máximo, continuados a partir do instante anterior
the-minimum-and-maximum-tilt-continued-from-the-previous-instant = a inclinação mínima e a máxima, continuadas a partir do instante anterior
the-line-of-contact-by-pythagoras = a linha de contato por Pitágoras
the-centre-of-mass-rotated-from-the-body-axes = o centro de massa, girado dos eixos do corpo
the-second-derivative-of-the-potential-of-a-hanging-body-is-zero-at-that-speed = a segunda derivada do potencial de um corpo pendente é nula nessa velocidade
the-reactions-in-the-fixed-axes-plus-all-other-forces-equal-the-same-difference-quotient = as reações nos eixos fixos mais todas as outras forças são iguais ao mesmo quociente de diferenças
the-static-reactions-balance-weight-and-loads = as reações estáticas equilibram o peso e as cargas
velocity-of-the-point-of-the-wheel-on-the-rail = velocidade do ponto da roda sobre o trilho
weight-and-centrifugal-force-balance-at-the-lean-without-rotating-parts = peso e força centrífuga se equilibram na inclinação sem partes girantes
time-to-that-angle-by-quadrature-over-the-nutation = tempo até esse ângulo por quadratura sobre a nutação
the-same-hoop-from-its-precession = O mesmo aro a partir da sua precessão
closed-form-2-g-cos-sin-4-a-r-cos-for-a-hoop-solved-for-the-circle-of-the-centre = forma fechada: φ̇² = 2 g cos θ/(sen θ (4 a + r cos θ)) para um aro, resolvida para o círculo do centro
fossee-companion-to-bevan-the-theory-of-machines-ch-2-ex-12 = Complemento FOSSEE a Bevan, The Theory of Machines, cap. 2, ex. 12
rotor-whose-shaft-turns-once-in-five-seconds = Rotor cujo eixo dá uma volta em cinco segundos
the-moment-of-inertia-of-40-lb-ft-is-the-weight-of-the-rotor-times-the-square-of-its-radius-of = O momento de inércia de 40 lb ft² é o peso do rotor vezes o quadrado do seu raio de giração; g = 32,2 ft/s² dá o da sua massa.
a-shape = Uma forma
about-its-own-axes-through-its-centre-of-mass = Em relação aos seus próprios eixos, pelo centro de massa.
angular-impulse = Impulso angular
angular-impulses = Impulsos angulares
angular-momentum-about-g-after-impact-excluding-the-support-reactions-h-g-r-j-k = Momento angular em relação a G após o impacto, sem as reações dos apoios: H_G + Σ r × J + Σ K
another-shape = Outra forma
as-the-road-wheels-roll = Como as rodas do veículo
at-that-speed-the-centrifugal-force-of-the-frame-has-the-moment-of-the-gyroscopic-couple = nessa velocidade o momento da força centrífuga do quadro é igual ao momento giroscópico
of-the-frame-below-the-axis-about-which-it-swings = Do quadro, abaixo do eixo em torno do qual ele oscila.
both-together-outward-a-wheel-that-turns-against-the-road-wheels-drives-the-lower-end-of-the-frame = Os dois juntos, para fora: um volante que gira contra as rodas do veículo empurra a extremidade inferior do quadro para fora
both-together-outward-a-wheel-that-turns-as-the-road-wheels-pulls-the-lower-end-of-the-frame-inward = Os dois juntos, para fora: um volante que gira como as rodas do veículo puxa a extremidade inferior do quadro para dentro
by-the-formula-for-fast-tops-the-mass-of-1-kg-is-chosen-here-and-cancels = Pela fórmula dos piões rápidos. A massa de 1 kg é escolhida aqui e se cancela.
depth-of-its-centre-of-mass = Profundidade do seu centro de massa
disc-of-0-3-ft-radius-on-a-stem-of-0-5-ft-at-40-to-the-vertical-spinning-at-300-rad-s-g-32-2-ft-s-as = Disco de 0,3 ft de raio numa haste de 0,5 ft, a 40° da vertical, girando a 300 rad/s. g = 32,2 ft/s² como no livro.
disc-of-0-5-m-radius-5-5-cm-from-its-pivot = Disco de 0,5 m de raio, a 5,5 cm do seu ponto fixo
fossee-python-companion-to-khurmi-gupta-theory-of-machines-ex-14-16 = Complemento FOSSEE em Python a Khurmi & Gupta, Theory of Machines, ex. 14.16
g-r-fowles-g-l-cassiday-analytical-mechanics-problem-9-9 = G. R. Fowles, G. L. Cassiday, Analytical Mechanics, problema 9.9
gyro-wheel-that-turns-as-the-road-wheels = Volante giroscópico que gira como as rodas do veículo
gyroscopic-couple-with-the-frame-upright = Momento giroscópico com o quadro na vertical
gyroscopic-couple-with-the-frame-upright-at-the-inclination-it-is-c-g-cos = Momento giroscópico com o quadro na vertical; na inclinação θ ele é C_g cos θ
h-2-t-i-on-the-separatrix-l-d-landau-e-m-lifshitz-mechanics-37 = H² = 2 T I₂ na separatriz: L. D. Landau, E. M. Lifshitz, Mecânica, §37
h-2-t-i-with-the-intermediate-moment-in-a-separatrix-plane = H² = 2 T I com o momento intermediário, num plano da separatriz
h-i-a-u-k-the-body-precesses-about-h-with-the-rate-h-i-t = H = I_a ω u + K: o corpo precessiona em torno de H com a velocidade angular H/I_t
i-a-0-02-kg-m-i-t-0-012-kg-m-100-rad-s-0-3-n-m-s-the-mass-of-1-kg-is-chosen-here-and-does-not-matter = I_a = 0,02 kg·m², I_t = 0,012 kg·m², 100 rad/s, 0,3 N·m·s. A massa de 1 kg é escolhida aqui e não importa.
i-i-i-i-i-i-3-the-angular-velocity-at-the-start-is-chosen-here-and-does-not-matter = ω₁/ω₃ = √(I₃ (I₃ − I₂)/(I₁ (I₂ − I₁))) = √3; a velocidade angular inicial é escolhida aqui e não importa.
in-the-opposite-direction-of-travel-the-wheel-turns-against-the-road-wheels = No sentido de marcha oposto o volante gira contra as rodas do veículo.
inclination-against-the-speed-of-the-vehicle = Inclinação em função da velocidade do veículo
inclination-of-a-frame-with-a-spinning-wheel-that-hangs-from-a-fore-and-aft-axis-under-the-gyroscopic = Inclinação de um quadro com um volante girante que pende de um eixo longitudinal, sob o momento giroscópico, a força centrífuga e o peso.
inclination-of-the-frame-outward = Inclinação do quadro, para fora
inclination-outward = inclinação, para fora
inclination-positive-with-the-lower-end-outward-c-cos-k-sin = Inclinação, positiva com a extremidade inferior para fora: C cos θ = K sen θ
it-leaves-the-body = Ele deixa o corpo
it-passes-through-or-rebounds-the-body-receives-the-change-of-its-momentum = Ele atravessa o corpo ou ricocheteia: o corpo recebe a variação da sua quantidade de movimento.
its-own-z-axis-along-the-axis-of-the-top-its-centre-of-mass-at-the-distance-given = Seu próprio eixo z no eixo do pião, seu centro de massa à distância dada.
its-own-z-axis-along-the-axle = Seu próprio eixo z no eixo do rotor.
its-own-z-axis-is-the-axis-of-symmetry = Seu próprio eixo z é o eixo de simetria.
linear-momentum-lost-by-name-its-mass-times-the-change-of-its-velocity = Quantidade de movimento perdida por { $name }: sua massa vezes a variação da sua velocidade
m-f-h-v-i-a-the-centrifugal-moment-and-the-gyroscopic-couple-are-both-proportional-to-the-rate-of = m_f h v₀ = I_a ω: o momento centrífugo e o momento giroscópico são ambos proporcionais à velocidade angular da curva
mass-of-the-frame = Massa do quadro
meteorite-that-passes-through-a-space-probe = Meteorito que atravessa uma sonda espacial
moment-of-inertia-of-the-shape-about-a-transverse-axis-through-g = Momento de inércia da forma em relação a um eixo transversal por G
moment-of-inertia-of-the-shape-about-its-axis-of-symmetry = Momento de inércia da forma em relação ao seu eixo de simetria
moment-of-the-centrifugal-force-of-the-frame-about-the-axis-at-the-inclination-it-is-c-c-cos = Momento da força centrífuga do quadro em relação ao eixo; na inclinação θ ele é C_c cos θ
moment-of-the-centrifugal-force-with-the-frame-upright = Momento da força centrífuga com o quadro na vertical
moment-of-the-weight-of-the-frame-with-its-arm-level-at-the-inclination-it-is-k-sin = Momento do peso do quadro com o braço na horizontal; na inclinação θ ele é K sen θ
moments-about-the-axis-that-of-the-weight-is-the-rate-of-change-of-the-angular-momentum-of-wheel-and = momentos em relação ao eixo: o do peso é a taxa de variação do momento angular do volante e do quadro
motion-of-a-body-immediately-after-an-impulse-an-angular-impulse-the-impact-of-a-projectile-or-a = Movimento de um corpo logo após um impulso, um impulso angular, o impacto de um projétil ou um vínculo súbito; reações impulsivas e energia.
n-0-5-kg-0-02-m-100-rad-s-0-3-kg-0-01-m-20-943951-m-s = 0,5 kg (0,02 m)² 100π rad/s/(0,3 kg · 0,01 m) = 20,943951 m/s.
opposite-to-the-road-wheels = Contra as rodas do veículo
pendulous-gyroscope-on-a-vehicle-in-a-turn = Giroscópio pendular em veículo numa curva
plate-a-quarter-as-thick-as-wide-thrown-at-45 = Placa de espessura igual a um quarto da largura, lançada a 45°
principal-moment-of-inertia-of-the-shape-about-its-axis-through-g = Momento principal de inércia da forma, em relação ao seu eixo por G
projectiles = Projéteis
questions-and-answers-on-preguntia-com-no-13898735 = perguntas e respostas em preguntia.com, n.º 13898735
r-c-hibbeler-engineering-mechanics-dynamics-11th-ed-problem-21-70 = R. C. Hibbeler, Engineering Mechanics: Dynamics, 11.ª ed., problema 21-70
sense-of-the-wheel = Sentido do volante
separatrix-planes-of-a-body-of-1-2-and-3-kg-m = Planos da separatriz de um corpo de 1, 2 e 3 kg·m²
separatrix-planes-through-the-intermediate-axis-from-h-2-t-i-with-the-intermediate-moment-angular = Planos da separatriz, pelo eixo intermediário, de H² = 2 T I com o momento intermediário: velocidade angular em torno do eixo de menor inércia sobre a do eixo de maior inércia
slope-of-the-separatrix-planes = Declividade dos planos da separatriz
speed-at-which-the-frame-stays-upright = Velocidade em que o quadro fica na vertical
speed-of-the-vehicle-at-which-the-two-couples-are-equal-the-frame-stays-upright-in-any-turn = Velocidade do veículo em que os dois binários são iguais: o quadro fica na vertical em qualquer curva
speed-of-the-wheel = Rotação do volante
spinning-body-given-a-transverse-angular-impulse = Corpo em rotação que recebe um impulso angular transversal
bullet-that-passes-through-a-spinning-body-in-flight = Bala que atravessa um corpo em rotação e em voo
m-v-m-p-v-p-v-p-i-r-p-m-p-v-p-v-p-in-principal-axes-t-m-v-i-2 = m Δv = m_p (v_p − v_p′), I Δω = r_p × m_p (v_p − v_p′) em eixos principais, T = Σ (m v² + ω · I ω)/2
the-bullet-loses-9-7-5-3-kg-m-s-of-linear-momentum = A bala perde (9; −7,5; 3) kg·m/s de quantidade de movimento.
square-plate-of-thickness-a-4-one-revolution-per-second-a-1-m-and-m-1-kg-are-chosen-here-and-cancel = Placa quadrada de espessura a/4, uma volta por segundo. a = 1 m e m = 1 kg são escolhidos aqui e se cancelam.
the-axes-of-this-shape-are-not-principal-axes-of-inertia-calculate-them-by-rigid-body-mass-properties = os eixos desta forma não são eixos principais de inércia: calcule-os com rigid-body/mass-properties
the-book-gives-letters-mv-mr-2-27-18-25-9-8-and-the-moment-of-the-momentum-lost-15-32-mvr-1-12-12-m-1 = O livro dá letras: ω = mV/(MR) (2/27; −18/25; −9/8), e o momento da quantidade de movimento perdida, 15/32 mVR (1; −12; −12). M = 1 kg, R = 1 m, V = 1 m/s e m = 1 kg são escolhidos aqui.
the-frame-from-behind-in-a-turn-to-the-left = O quadro visto de trás, numa curva para a esquerda
the-inner-radius-is-not-smaller-than-the-outer-radius-write-the-smaller-one-as-the-inner = o raio interno não é menor que o externo: escreva o menor como interno
the-moment-of-the-couple-times-its-duration = O momento do binário vezes a sua duração.
the-moments-of-inertia-of-this-shape-about-its-x-and-y-axes-differ-so-its-z-axis-is-no-axis-of = os momentos de inércia desta forma em relação aos eixos x e y diferem, portanto o eixo z não é eixo de simetria: use uma forma de revolução em torno de z
the-same-gyro-wheel-on-the-vehicle-driven-the-other-way = O mesmo volante com o veículo no sentido oposto
the-section-of-the-torus-is-larger-than-its-circle-make-its-radius-smaller = a seção do toro é maior que a sua circunferência: diminua o seu raio
thin-disc-of-8-lb-on-a-light-stem = Disco fino de 8 lb numa haste leve
velocity-of-the-projectile-after-impact = Velocidade do projétil após o impacto
wheel = Volante
wheel-of-0-5-kg-with-a-radius-of-gyration-of-20-mm-at-3000-rpm-frame-of-0-3-kg-with-its-centre-of = Volante de 0,5 kg com raio de giração de 20 mm a 3000 rpm, quadro de 0,3 kg com centro de massa 10 mm abaixo do eixo; 15 m/s em 50 m. O livro imprime o módulo do ângulo; aqui a extremidade inferior vai para dentro.
wilcox-dynamics-ch-8-problem-2 = Wilcox, Dynamics, cap. 8, problema 2
solid-cylinder-in-a-frame-that-turns = Cilindro maciço num quadro que gira
c-i-with-i-m-r-2 = C = I ω Ω com I = m r²/2
n-10-kg-100-mm-300-rad-s-0-2-rad-s-i-0-05-kg-m = 10 kg, 100 mm, 300 rad/s, 0,2 rad/s: I = 0,05 kg·m².
elliptical-plate-thrown-with-a-spin = Placa elíptica lançada em rotação
i-m-b-4-i-y-m-a-4-i-z-m-a-b-4-of-a-thin-elliptical-plate-j-l-meriam-l-g-kraige-engineering-mechanics = Iₓ = m b²/4, I_y = m a²/4, I_z = m (a² + b²)/4 de uma placa elíptica fina: J. L. Meriam, L. G. Kraige, Mecânica: Dinâmica, tabela D/4
m-4-kg-a-0-5-m-b-0-25-m-0-0625-0-25-and-0-3125-kg-m-t-i-2 = m = 4 kg, a = 0,5 m, b = 0,25 m: 0,0625, 0,25 e 0,3125 kg·m²; T = Σ I ω²/2.
a-block-or-a-box-that-swings-as-a-particle = Um bloco ou uma caixa que oscila como partícula.
a-blow-at-that-distance-gives-g-its-velocity-by-itself = um golpe nessa distância dá por si só a velocidade a G
a-body-that-hung-from-the-hinge-goes-over-the-top = um corpo que pendia da articulação passa pelo alto
a-body-that-runs-away = Um corpo que se afasta
a-control-moment-gyro-the-axle-is-held-in-a-gimbal-which-turns-in-the-carrier = Giroscópio de controle de momento: o eixo está num cardã, que gira no veículo.
a-coupling-slips-between-two-bodies-that-turn-before-and-have-the-common-angular-velocity-after = um acoplamento desliza entre dois corpos que giram antes e têm depois a velocidade angular comum: descreva-os assim, ou omita o torque
a-fixed-wall = Uma parede fixa
a-free-body-b = Um corpo livre B
a-hinged-body = Um corpo articulado
a-of-1-kg-with-3-m-s-at-30-to-the-line-of-impact-b-of-2-kg-with-1-m-s-at-45-the-other-way-e-0-75 = A de 1 kg com 3 m/s a 30° da linha de impacto, B de 2 kg com 1 m/s a 45° no sentido contrário, e = 0,75.
a-person-a-bob-its-own-inertia-is-neglected = Uma pessoa, um peso: a inércia própria é desprezada.
a-person-who-walks-a-wheel-that-is-driven = Uma pessoa que anda, uma roda acionada.
a-rod-a-pendulum-a-door-the-line-of-impact-is-normal-to-the-arm-from-the-hinge = Uma barra, um pêndulo, uma porta: a linha de impacto é normal ao braço a partir da articulação.
a-rotor-that-hardly-turns = Um rotor que quase não gira
a-solid-cylinder-too = Também um cilindro maciço.
a-thin-disc-has-i-a-2-i-t-t-2-2-200-7-2921e-5-cos-30-7-2921e-5-cos-30-s-whatever-its-mass-and-radius = Um disco fino tem I_a = 2 I_t: T₀ = 2π/√(2 · 200π · 7,2921e-5 · cos 30° − (7,2921e-5 cos 30°)²) s, quaisquer que sejam massa e raio, aqui 1 kg e 100 mm.
a-turntable-at-rest = Uma mesa giratória em repouso
a-vector-of-zero-has-no-direction = um vetor nulo não tem direção
acceleration-of-a-ball-that-rolls-down-the-same-slope-at-rest = Aceleração de uma bola que desce rolando o mesmo plano em repouso
across-it = Transversal a ela
across-the-line-of-impact-both-move-on-together-too = Transversalmente à linha de impacto os dois também seguem juntos
after-the-impact = Depois do impacto
aircraft-at-the-bottom-of-a-loop = Avião no fundo de um looping
aircraft-over-the-top-of-a-crest = Avião sobre o topo de uma lombada
along-the-line-of-impact = Ao longo da linha de impacto
an-aircraft-that-stays-below-the-sun = Um avião que fica sob o Sol
angle-along-the-circle-in-that-time = Ângulo ao longo do círculo nesse tempo
angle-between-the-axis-of-the-gimbal-and-the-axle = Ângulo entre o eixo do cardã e o eixo do rotor
angle-of-a-to-the-line-of-impact-after = Ângulo de A com a linha de impacto depois
angle-of-b-to-the-line-of-impact-after = Ângulo de B com a linha de impacto depois
angle-of-both-to-the-line-of-impact = Ângulo de ambos com a linha de impacto
angle-of-the-gimbal-axis-to-the-axle = Ângulo entre o eixo do cardã e o do rotor
angle-to-the-line-of-impact = Ângulo com a linha de impacto
angular-impulse-on-name-change-of-its-angular-momentum = Impulso angular sobre { $name }: variação do seu momento angular
angular-impulse-the-external-one-less-those-on-the-other-bodies = impulso angular: o externo menos os sobre os outros corpos
angular-momenta-about-the-axis = Momentos angulares em relação ao eixo
angular-momentum-about-g-the-moments-of-blow-and-hinge = momento angular em relação a G: os momentos do golpe e da articulação
angular-momentum-about-the-hinge-the-moment-of-the-blow = momento angular em relação à articulação: o momento do golpe
angular-momentum-about-the-hinge-then-energy-of-pendulum-and-bullet = momento angular em relação à articulação, depois a energia do pêndulo e do projétil
angular-momentum-before = Momento angular antes
angular-momentum-before-and-15-n-m-s-from-outside-less-that-of-the-leap = momento angular antes, e 15 N·m·s de fora, menos o do salto
angular-momentum-beside-the-common-rotation-of-relative-and-of-given-motions = Momento angular além da rotação comum: dos movimentos relativos e dos dados
angular-momentum-of-name-after = Momento angular de { $name } depois
angular-momentum-of-name-before = Momento angular de { $name } antes
angular-momentum-of-several-bodies = Momento angular de vários corpos
angular-momentum-of-the-rotor-about-its-axle = Momento angular do rotor em torno do seu eixo
effective-angular-momentum-for-small-deviations-reduced-by-the-transverse-moment-of-inertia = Momento angular efetivo para pequenos desvios, reduzido pelo momento de inércia transversal
angular-velocity-after = Velocidade angular depois
angular-velocity-after-the-impact = Velocidade angular depois do impacto
angular-velocity-before = Velocidade angular antes
angular-velocity-of-earth-and-vessel-about-the-axis-of-the-earth = Velocidade angular da Terra e da embarcação em torno do eixo da Terra
angular-velocity-of-name = Velocidade angular de { $name }
angular-velocity-of-the-earth = Velocidade angular da Terra
angular-velocity-of-the-gimbal = Velocidade angular do cardã
angular-velocity-of-the-level-plane-horizontal-component = Velocidade angular do plano horizontal: componente horizontal
angular-velocity-of-the-path = Velocidade angular da trajetória
angular-velocity-of-the-path-by-friction-and-rolling-v-1-v = Velocidade angular da trajetória: por atrito e rolamento, v̇ = κ/(1 + κ) Ω × v
angular-velocity-of-the-turntable = Velocidade angular da mesa giratória
angular-velocity-there-by-integration = velocidade angular nesse ponto, por integração
angular-velocity-through-the-meridian = Velocidade angular ao cruzar o meridiano
angular-velocity-through-the-settled-direction-by-the-energy-of-the-turning-axle = Velocidade angular ao cruzar a direção de equilíbrio, pela energia do eixo que gira
any-vector-along-the-axis-of-the-gimbal = Qualquer vetor ao longo do eixo do cardã
arithmetic-geometric-mean-of-a-and-b-which-is-the-complete-elliptic-integral-of-the-motion = Média aritmético-geométrica de a e b, que é a integral elíptica completa do movimento
at-a-pole-the-axis-of-the-earth-is-vertical-and-every-direction-leads-along-a-meridian-write-a = num polo o eixo da Terra é vertical e toda direção segue um meridiano: escreva uma latitude entre −90° e 90°
at-rest-on-the-turntable = Em repouso sobre a mesa giratória
at-that-time = nesse instante
at-the-pole = No polo
at-this-latitude = nesta latitude
axle-at-one-end-by-its-angular-momentum = Eixo apoiado em uma ponta, pelo momento angular
axle-held-level = Eixo mantido na horizontal
ball-against-a-swinging-pendulum = Bola contra um pêndulo em movimento
ball-against-a-wall = Bola contra uma parede
ball-against-a-rod-between-its-middle-and-its-lower-end = Bola contra uma barra entre o meio e a ponta inferior
two-linear-equations-angular-momentum-about-the-hinge-and-r-v-e-u-then-energy-of-the-rod = duas equações lineares: o momento angular em relação à articulação e ω r − v = e u; depois a energia da barra
n-3-kg-at-6-m-s-1-1-m-below-the-hinge-of-a-slender-rod-of-7-5-kg-and-1-6-m-e-0-55 = 3 kg a 6 m/s, 1,1 m abaixo da articulação de uma barra delgada de 7,5 kg e 1,6 m, e = 0,55.
two-smooth-discs-at-25-and-140-to-the-line-of-impact = Dois discos lisos a 25° e 140° da linha de impacto
momentum-and-coefficient-of-restitution-along-the-line-of-impact-the-components-across-it-do-not = quantidade de movimento e coeficiente de restituição ao longo da linha de impacto; as componentes transversais não mudam
n-2-kg-at-5-m-s-and-3-5-kg-at-3-m-s-e-0-6 = 2 kg a 5 m/s e 3,5 kg a 3 m/s, e = 0,6.
ball-against-the-middle-of-a-hanging-rod = Bola contra o meio de uma barra suspensa
ball-of-1-kg-at-10-m-s-rod-of-5-kg-and-1-m-e-0-4 = Bola de 1 kg a 10 m/s, barra de 5 kg e 1 m, e = 0,4.
ball-on-a-turntable = Bola sobre uma mesa giratória
ballistic-pendulum-with-a-ball = Pêndulo balístico com uma bola
bearings-in-a-gimbal = Mancais num cardã
below-the-support = Abaixo do apoio.
bob-on-a-cord = Peso num fio
bob-pulled-in-along-an-arm = Peso puxado ao longo de um braço
body-a-does-not-approach-what-it-strikes-along-the-line-of-impact-its-velocity-must-be-above-that-of = o corpo A não se aproxima do que atinge: ao longo da linha de impacto a sua velocidade deve ser maior que a do corpo atingido; mude um sinal ou um ângulo
body-after = Corpo depois
body-beside-the-axis = Corpo ao lado do eixo
bullet-into-a-heavy-pendulum = Projétil num pêndulo pesado
by-which-the-gimbal-has-turned-the-axle-from-the-position-given-by-the-sense-and-the-viewpoint = Ângulo de que o cardã girou o eixo do rotor a partir da posição dada pelo sentido e pelo ponto de vista.
c-i-v-r-in-a-loop-the-bearings-carry-m-g-v-r = C = I ω v/R; num looping os mancais levam m (g + v²/R)
c-i-v-r-over-a-crest-the-bearings-carry-m-g-v-r = C = I ω v/R; numa lombada os mancais levam m (g − v²/R)
c-m-f-v-h-r-h-w-v-r-and-tan-c-m-f-g-h = C = m_f v² h/R − h_w v/R e tan θ = C/(m_f g h)
c-plath-navigat-x-mk-1-manual-table-of-the-north-speed-error = C. Plath, manual Navigat X Mk 1, tabela do erro de velocidade norte
centre-of-the-circle-at-the-start = Centro do círculo no início
centre-of-the-circle-from-half-a-circle = centro do círculo por meio círculo
child-who-jumps-on-a-merry-go-round = Criança que salta num carrossel
closed-form-of-the-circle-and-numerical-integration-independently-of-the-program = forma fechada do círculo, e integração numérica independentemente do programa
clutch-between-two-discs-that-turn-against-each-other = Embreagem entre dois discos que giram em sentidos contrários
coefficient-of-friction-that-it-takes-to-keep-the-ball-on-its-circle = Coeficiente de atrito necessário para manter a bola no seu círculo
coefficient-of-friction-that-it-takes-where-friction-holds-the-circle-and-the-weight-along-the-slope = Coeficiente de atrito necessário onde o atrito mantém ao mesmo tempo o círculo e o peso ao longo do plano
common-angular-velocity = velocidade angular comum
common-angular-velocity-after = Velocidade angular comum depois
common-angular-velocity-against-the-external-angular-impulse = Velocidade angular comum em função do impulso angular externo
common-speed-after = Velocidade comum depois
common-speed-of-discs-that-are-coupled-of-a-turntable-on-which-somebody-walks-of-a-body-pulled-in = Velocidade comum de discos acoplados, de uma mesa giratória em que alguém anda, de um corpo puxado para dentro: conservação do momento angular em torno de um eixo, energia perdida.
component-across-the-line-of-impact = Componente transversal à linha de impacto
component-along-the-line-of-impact = Componente ao longo da linha de impacto
components = Componentes
conservation-of-both-components-of-the-momentum = conservação das duas componentes da quantidade de movimento
constant-while-it-slips-between-two-bodies-gives-the-time-of-the-slip = Constante enquanto desliza, entre dois corpos: dá o tempo de deslizamento.
control-moment-gyro = Giroscópio de controle de momento
couple-of-a-small-deviation-by-the-rate-of-change-of-the-angular-momentum = binário de um pequeno desvio, pela taxa de variação do momento angular
couple-of-the-spin-h-s-g-sin = binário da rotação própria: h_s ω_g sen θ
couple-on-a-spinning-rotor-whose-carrier-or-gimbal-turns-pitches-or-rolls-its-reaction-on-the-carrier = Binário num rotor em rotação cujo veículo ou cardã gira, arfa ou balança, sua reação no veículo com o efeito em palavras, e as reações dos mancais.
couple-that-directs-the-axle-at-the-initial-deviation = Binário que dirige o eixo, no desvio inicial
coupling-of-three-bodies = Acoplamento de três corpos
course = Rumo
cylinder-like-ball-the-other-way-round = Bola como cilindro, no outro sentido
depth-of-the-centre-of-mass = Profundidade do centro de massa
depth-of-the-centre-of-mass-for-it = Profundidade do centro de massa para isso
depth-that-gives-schuler-s-period = Profundidade que dá o período de Schuler
deviation-due-to-the-speed-to-the-west = Desvio devido à velocidade, para oeste
dh-dt-g-e-h-u-of-size-h-g-across-the-axle = dH/dt = ω_g e × h u; de módulo h ω_g transversalmente ao eixo
directing-couple-at-the-deviation = Binário diretor no desvio
direction-of-the-velocity-after-the-impact = Direção da velocidade depois do impacto
disc-at-6000-rpm-in-latitude-30 = Disco a 6000 rpm na latitude 30°
distance-from-the-axis = Distância ao eixo
distance-from-the-axis-against-time = Distância ao eixo em função do tempo
distance-from-the-axis-at-that-time = Distância ao eixo nesse instante
distance-from-the-axis-by-integration = distância ao eixo por integração
distance-of-g-from-the-axis = Distância de G ao eixo
distance-of-g-from-the-hinge = Distância de G à articulação
distance-of-its-path-from-the-axis = Distância da sua trajetória ao eixo
distance-of-the-centre-of-percussion = Distância do centro de percussão
distance-of-the-centre-of-percussion-a-blow-there-needs-no-impulse-of-the-hinge = Distância do centro de percussão: um golpe ali não requer impulso da articulação
distance-of-the-struck-point-from-the-hinge = Distância do ponto atingido à articulação
drift-along-y-across-the-slope-at-which-1-v-takes-the-acceleration-away = Deriva ao longo de y, transversal à inclinação, em que κ/(1 + κ) Ω × v anula a aceleração
drift-displacement-in-the-time-of-a-circle = deriva: deslocamento no tempo de um círculo
drift-velocity-along-y = Velocidade de deriva, ao longo de y
energy-after-the-impact-as-a-height-1-cos-of-a-body-that-hung-from-the-hinge = Energia depois do impacto como altura: 1 − cos θ de um corpo que pendia da articulação
energy-after-the-impact-work-against-the-weight = energia depois do impacto = trabalho contra o peso
energy-lost-1-e-of-that-of-the-approach = Energia perdida: 1 − e² da energia da aproximação
energy-lost-all-of-that-of-the-approach = Energia perdida: toda a da aproximação
energy-lost-all-of-that-of-the-relative-motion = Energia perdida: toda a do movimento relativo
energy-lost-from-the-angular-momenta = energia perdida pelos momentos angulares
energy-lost-that-of-the-approach-and-that-of-a-across-the-line-of-impact = Energia perdida: a da aproximação, e a de A transversal à linha de impacto
energy-lost-that-of-the-motions-relative-to-the-common-one = energia perdida: a dos movimentos relativos ao comum
every-motion-after-is-given = todo movimento depois é dado
external-angular-impulse = Impulso angular externo
first-number-of-the-arithmetic-geometric-mean = Primeiro número da média aritmético-geométrica
for-the-swing-of-a-body-that-hangs-from-the-hinge = Para a oscilação de um corpo que pende da articulação.
fossee-python-companion-to-bansal-engineering-mechanics-ch-17 = Companheiro Python FOSSEE de Bansal, Engineering Mechanics, cap. 17
fossee-python-companion-to-hibbeler-engineering-mechanics-dynamics-ex-15-11 = Companheiro Python FOSSEE de Hibbeler, Engineering Mechanics: Dynamics, ex. 15.11
fossee-scilab-companion-to-bevan-the-theory-of-machines-ch-2-ex-3 = Companheiro Scilab FOSSEE de Bevan, The Theory of Machines, cap. 2, ex. 3
fossee-scilab-companion-to-hibbeler-engineering-mechanics-dynamics-ex-19-8 = Companheiro Scilab FOSSEE de Hibbeler, Engineering Mechanics: Dynamics, ex. 19.8
from-north-clockwise = A partir do norte, no sentido horário.
from-the-ball-to-the-centre-of-its-circle = Da bola ao centro do seu círculo
gimbal = Cardã
gimbal-angle = Ângulo do cardã
gimbal-without-an-axis = Cardã sem eixo
gyrocompass = Bússola giroscópica
gyroscopic-couple-against-the-radius-of-the-path = Momento giroscópico em função do raio da trajetória
h-0-3-kg-m-s-i-t-0-002-kg-m-latitude-40-south = h = 0,3 kg·m²/s, I_t = 0,002 kg·m², latitude 40° sul.
h-15-kg-m-s-3-kg-hung-8-mm-below-the-support-latitude-50-north = h = 15 kg·m²/s, 3 kg pendurados 8 mm abaixo do apoio, latitude 50° norte.
h-g-sin-with-the-axle-at-60-to-the-axis-of-the-gimbal = h ω_g sen θ, com o eixo do rotor a 60° do eixo do cardã
h-must-be-above-i-t-h = h deve ser maior que I_t Ω_h
h-w-0-0628319-kg-m-s-the-wheel-of-the-first-case-0-0053496-n-m-over-0-02943-n-m = h_w = 0,0628319 kg·m²/s, o volante do primeiro caso: −0,0053496 N·m sobre 0,02943 N·m.
hinged-at-its-end = Articulada na ponta.
hinged-body = Corpo articulado
hnakanishi-cloudfree-jp-sphere-rolling-on-a-turntable-a-uniform-sphere-makes-2-revolutions-while-the = hnakanishi.cloudfree.jp, esfera rolando sobre uma mesa giratória: uma esfera homogênea dá 2 voltas enquanto a mesa dá 7
holooly-com-problem-1100536-a-2-kg-sphere-against-a-hinged-rod-of-8-kg = holooly.com, problema 1100536: uma esfera de 2 kg contra uma barra articulada de 8 kg
i-a-i-t-sin-cos-needs-both-moments = (I_a − I_t) Ω² sen θ cos θ requer os dois momentos
i-i-i-i-and-the-angular-impulse-over-the-torque = I₁ ω₁ + I₂ ω₂ = (I₁ + I₂) ω, e o impulso angular sobre o torque
impact-of-two-bodies = Impacto de dois corpos
impulse-1-e-times-the-one-that-ends-the-approach = Impulso: 1 + e vezes o que termina a aproximação
impulse-along-the-line-of-impact = Impulso ao longo da linha de impacto
impulse-change-of-the-momentum-of-a = impulso = variação da quantidade de movimento de A
impulse-change-of-the-momentum-of-b = impulso = variação da quantidade de movimento de B
impulse-of-the-hinge-in-the-direction-of-the-blow-with-it-g-has-its-new-velocity = Impulso da articulação, no sentido do golpe: com ele G tem a sua nova velocidade
impulse-of-the-hinge-on-the-body = Impulso da articulação sobre o corpo
impulse-that-ends-the-approach = Impulso que termina a aproximação
in-space-about-its-axle-left-out-where-the-rotor-is-given-by-its-angular-momentum = No espaço, em torno do seu eixo. Omitida quando o rotor é dado pelo momento angular.
inertia-that-is-too-small = Inércia pequena demais
initial-deviation = Desvio inicial
initial-position-of-the-ball = Posição inicial da bola
initial-velocity-of-its-centre = Velocidade inicial do seu centro
it-leaves-in-a-straight-line = Sai em linha reta
it-moves-in-a-straight-line = Move-se em linha reta
it-turns-about-the-axis = Gira em torno do eixo
it-turns-at-a-given-angular-velocity = Gira com velocidade angular dada
it-turns-in-a-level-circle-and-its-inertia-carries-it-past-the-meridian = Gira num círculo horizontal, e sua inércia a leva além do meridiano.
it-turns-relative-to-the-others = Gira em relação aos outros
it-turns-with-the-common-angular-velocity-what-came-in-a-straight-line-at-the-distance-of-its-path = Gira com a velocidade angular comum; o que veio em linha reta, à distância da sua trajetória.
it-was-held-on-the-turntable-and-turned-with-it = Foi mantida sobre a mesa giratória e girava com ela.
its-centre-of-mass-lies-on-the-line-of-impact = Seu centro de massa está na linha de impacto.
its-inertia-and-speed-need-not-be-known = Sua inércia e sua rotação não precisam ser conhecidas.
its-horizontal-component-to-the-north = Sua componente horizontal, para o norte
joined-as-it-is = Unido, como está
joined-in-another-place-or-shape = Unido, em outro lugar ou forma
kinetic-energy-after-from-the-angular-momenta-h-2-i = energia cinética depois pelos momentos angulares, H²/(2 I)
kinetic-energy-before-from-the-angular-momenta-h-2-i = energia cinética antes pelos momentos angulares, H²/(2 I)
kinetic-energy-lost-as-the-difference-of-that-before-and-after = energia cinética perdida como diferença entre antes e depois
kinetic-energy-before-the-impact = Energia cinética antes do impacto
kinetic-energy-lost = Energia cinética perdida
kinetic-energy-lost-negative-where-work-is-done-by-muscles-or-a-motor = Energia cinética perdida; negativa quando músculos ou um motor realizam trabalho
latitude = Latitude
left-out-for-a-compass-at-rest-on-the-earth = Omitida para uma bússola em repouso na Terra.
length-of-the-cord = Comprimento do fio
horizontal-component-of-the-angular-velocity-of-the-earth-to-the-north = Componente horizontal da velocidade angular da Terra, para o norte
lifeofapresson-com-on-the-fall-through-the-earth-84-4-minutes = lifeofapresson.com, sobre a queda através da Terra: 84,4 minutos
m-m-v-m-m-g-h-and-m-u-m-m-v-for-the-data-of-jiskha-com-question-1269824600 = ½ (m + M) v² = (m + M) g H e m u = (m + M) v, para os dados de jiskha.com, questão 1269824600
magnitude-and-direction = Módulo e direção
mass-at-the-struck-point-that-would-move-like-the-body = Massa no ponto atingido que se moveria como o corpo
mass-of-body-a = Massa do corpo A
mass-of-body-b = Massa do corpo B
moment-from-outside-times-its-duration = Momento externo vezes a sua duração.
moment-of-inertia-about-its-own-parallel-axis = Momento de inércia em relação ao seu próprio eixo paralelo
moment-of-inertia-about-the-hinge = Momento de inércia em relação à articulação
moment-of-inertia-divided-by-m = Momento de inércia dividido por m ρ²
moment-of-inertia-of-a-solid-ball-2-5-m = Momento de inércia de uma bola maciça: 2/5 m ρ²
moment-of-inertia-of-a-thin-shell-2-3-m = Momento de inércia de uma casca fina: 2/3 m ρ²
moment-of-inertia-of-name-about-the-axis = Momento de inércia de { $name } em relação ao eixo
moment-of-inertia-of-the-ball-shell-by-shell = momento de inércia da bola, casca a casca
moment-of-inertia-of-the-shell-ring-by-ring = momento de inércia da casca, anel a anel
moment-of-inertia-of-what-turns-with-the-common-angular-velocity = Momento de inércia do que gira com a velocidade angular comum
moment-of-inertia-with-a-in-the-body = Momento de inércia com A no corpo
moment-of-the-mass-about-the-hinge = Momento da massa em relação à articulação
moment-of-the-masses-about-the-hinge = Momento das massas em relação à articulação
moment-of-the-weight-about-the-support-with-the-axle-upright = Momento do peso em relação ao apoio com o eixo na vertical
moment-of-the-weight-at-which-the-period-is-schuler-s = Momento do peso com que o período é o de Schuler
moment-that-holds-the-axle-level-that-of-the-weight-and-the-gyroscopic-one = Momento que mantém o eixo na horizontal: o do peso e o giroscópico
momentum-or-moment-of-momentum-over-the-arm-before-and-after = quantidade de movimento, ou o seu momento sobre o braço, antes e depois
n-0-02-kg-m-and-0-4-kg-at-0-5-m-with-6-rad-s-at-0-2-m-0-72-0-036-rad-s-the-work-of-the-pull-is-5-04-j = 0,02 kg·m² e 0,4 kg a 0,5 m com 6 rad/s; a 0,2 m: 0,72/0,036 rad/s. O trabalho da tração é 5,04 J.
n-0-075-kg-into-0-35-kg-rise-of-0-145-m-at-g-9-8-m-s-u-9-552998-m-s-the-cord-of-1-m-completes-the = 0,075 kg em 0,35 kg, subida de 0,145 m com g = 9,8 m/s²: u = 9,552998 m/s. O fio de 1 m completa os dados; a subida não depende dele.
n-0-2-kg-10-m-s-at-35-to-the-normal-e-0-6-j-1-6-0-2-8-191520-n-s-lost-0-64-0-1-8-191520-j = 0,2 kg, 10 m/s a 35° da normal, e = 0,6: J = 1,6 · 0,2 · 8,191520 N·s, perdidos 0,64 · 0,1 · 8,191520² J.
n-0-2-kg-m-brought-to-50-rad-s-in-a-satellite-of-40-kg-m-0-25-rad-s = 0,2 kg·m² levados a 50 rad/s num satélite de 40 kg·m²: −0,25 rad/s.
n-0-9-kg-m-at-100-rad-s-and-0-6-kg-m-at-40-rad-s-66-1-5-44-rad-s-lost-3528-j-50-4-25-s = 0,9 kg·m² a 100 rad/s e 0,6 kg·m² a −40 rad/s: 66/1,5 = 44 rad/s, perdidos 3528 J, 50,4/25 s.
n-1-2-6-rad-s-c-2-rad-s-radius-0-4-2-m = κ = 1/2, Ω = −6 rad/s: ω_c = −2 rad/s, raio 0,4/2 m.
n-1-in-an-elastic-impact = 1 num impacto elástico.
n-10-knots-in-latitude-81-the-compass-points-4-1-to-the-west-of-north = 10 nós na latitude 81°: a bússola aponta 4,1° a oeste do norte.
n-12-m-s-in-latitude-55-10-392305-266-4714-6-m-s = 12 m/s na latitude 55°: 10,392305/(266,4714 + 6) m/s.
n-135-kg-m-40-kg-at-1-5-m-and-a-wheel-of-0-05-kg-m-and-2-kg-at-0-8-m-turn-with-1-rad-s-the-leap-has-3 = 135 kg·m², 40 kg a 1,5 m e uma roda de 0,05 kg·m² e 2 kg a 0,8 m giram com 1 rad/s; o salto tem 3 m/s ao longo da borda: 61,33/136,33 rad/s.
n-1500-kg-with-20-m-s-to-the-east-and-2000-kg-with-15-m-s-to-the-north-line-of-impact-east-both = 1500 kg com 20 m/s para leste e 2000 kg com 15 m/s para norte, linha de impacto para leste: as duas componentes são 60/7 m/s, e perdem-se 267,857 kJ.
n-2-3-4-rad-s-1-of-tilt-c-1-6-rad-s-drift-g-sin-across-the-slope = κ = 2/3, Ω = 4 rad/s, 1° de inclinação: ω_c = 1,6 rad/s, deriva g sen β/(κ Ω) transversal à inclinação.
n-2-6371-km-9-81-m-s-the-period-of-a-pendulum-as-long-as-the-radius-of-the-earth = 2π √(6371 km/(9,81 m/s²)), o período de um pêndulo tão longo quanto o raio da Terra.
n-2-kg-at-3-m-s-0-8-m-below-the-hinge-of-a-pendulum-of-4-kg-with-i-o-1-5-kg-m-and-h-0-5-m-which-comes = 2 kg a 3 m/s, 0,8 m abaixo da articulação de um pêndulo de 4 kg com I_O = 1,5 kg·m² e h = 0,5 m, que vem com 1,5 rad/s; e = 0,5.
n-20-kg-at-5-m-s-against-10-kg-at-10-m-s-the-other-way-e-5-6 = 20 kg a 5 m/s contra 10 kg a 10 m/s no sentido contrário, e = 5/6.
n-20-n-m-s-0-5-rad-s-10-sin-60-n-m-whatever-the-gimbal-angle-at-0-the-axle-lies-forward-and-the = 20 N·m·s, 0,5 rad/s: 10 sen 60° N·m, qualquer que seja o ângulo do cardã; a 0° o eixo aponta para a frente e o binário no veículo, para a direita.
n-20-n-m-s-0-5-rad-s-the-axle-turned-by-30-in-the-gimbal-about-the-vertical-10-n-m-on-the-carrier = 20 N·m·s, 0,5 rad/s, o eixo girado de 30° no cardã em torno da vertical: 10 N·m no veículo, segundo (sen 30°; −cos 30°).
n-266-7-rpm-and-two-thirds-of-the-energy-are-lost-of-1-kg-m-2339-0-j = 266,7 rpm, e perdem-se dois terços da energia: de 1 kg·m², 2339,0 J.
n-3-5-rad-s-the-path-turns-by-1-rad-in-1-s-0-5-0-7-cos-1-0-7-sin-1-m-the-friction-is-0-7-9-81 = Ω = 3,5 rad/s: a trajetória gira 1 rad em 1 s, (−0,5 + 0,7 cos 1; 0,7 sen 1) m; o atrito é 0,7/9,81.
n-30-g-at-450-m-s-0-9-m-below-the-hinge-of-12-kg-with-k-o-0-7-m-and-h-0-6-m-i-o-5-88-kg-m-12-15-5 = 30 g a 450 m/s, 0,9 m abaixo da articulação de 12 kg com k_O = 0,7 m e h = 0,6 m: I_O = 5,88 kg·m², ω = 12,15/5,9043 rad/s.
n-30-kg-at-3-m-s-along-the-rim-of-2-m-250-kg-m-that-turn-the-other-way-with-0-2-rad-s-130-370-rad-s = 30 kg a 3 m/s ao longo da borda de 2 m; 250 kg·m² que giram no outro sentido com 0,2 rad/s: 130/370 rad/s.
n-400-kg-with-0-3-m-at-2400-rpm-200-km-h-on-a-radius-of-300-m-36-80-500-9-300-n-m-with-a-propeller = 400 kg com 0,3 m a 2400 rpm, 200 km/h num raio de 300 m: 36 · 80π · (500/9)/300 N·m. Com uma hélice horária vista de trás, o nariz que sobe vai para a direita. Mancais a 0,5 m de G.
n-5-kg-600-mm-h-1-75-kg-m-s-29-43-1-75-rad-s = 5 kg, 600 mm, h = 1,75 kg·m²/s: 29,43/1,75 rad/s.
n-50-kg-at-6-m-s-against-30-kg-at-rest-a-common-velocity = 50 kg a 6 m/s contra 30 kg em repouso: uma velocidade comum.
n-500-lb-ft-at-150-rpm-and-1500-lb-ft-at-rest-weights-times-squares-of-radii-of-gyration-g-32-2-ft-s = 500 lb ft² a 150 rpm e 1500 lb ft² em repouso, pesos vezes quadrados de raios de giração; g = 32,2 ft/s². A energia que aqui se perde é a que a mola armazena no livro, cerca de 1435 ft lb.
n-70-kg-at-2-m-0-8-rad-s-relative-to-a-turntable-of-300-kg-m-that-was-at-rest-224-580-rad-s = 70 kg a 2 m, 0,8 rad/s em relação a uma mesa giratória de 300 kg·m² que estava em repouso: ω = −224/580 rad/s.
near-180-the-axle-lingers-at-its-unstable-position-and-the-period-follows-from-the-last-digits-of-the = perto de 180° o eixo se demora na sua posição instável, e o período depende dos últimos dígitos do desvio
negative-where-it-passes-the-axis-in-the-negative-sense = Negativa se passa pelo eixo no sentido negativo.
negative-where-it-turns-the-other-way = Negativa se gira no outro sentido.
no-body-turns-with-an-angular-velocity-that-is-to-be-found-let-one-of-them-turn-with-the-others-after = nenhum corpo gira com uma velocidade angular a determinar: faça um deles girar com os outros depois
no-direction-at-a-pole-leads-to-the-north = nenhuma direção num polo leva ao norte
nothing-left-to-be-found = Nada a determinar
numerical-integration-of-h-u-h-u-and-the-roots-of-its-linear-equations-independently-of-the-program = integração numérica de h u̇ = τ − Ω × h u, e as raízes das suas equações lineares, independentemente do programa
numerical-integration-of-i-t-h-i-t-h-cos-h-sin-independently-of-the-program = integração numérica de I_t α̈ = −(h − I_t Ω_h cos α) Ω_h sen α, independentemente do programa
numerical-integration-of-the-equations-of-motion-independently-of-the-program = integração numérica das equações do movimento, independentemente do programa
oblique-axle-of-which-the-angular-momentum-alone-is-known = Eixo oblíquo de que só se conhece o momento angular
oblique-gimbal = Cardã oblíquo
rotor-along-a-vehicle-and-its-bearings-in-a-turn-to-the-left = Rotor ao longo de um veículo, e os seus mancais, numa curva para a esquerda
rotor-along-a-vehicle-and-its-bearings-in-a-turn-to-the-right = Rotor ao longo de um veículo, e os seus mancais, numa curva para a direita
b-u-f-b-a-u-f-a-h-u-with-f-a-f-b-0-m-v-r-m-g = b u × F_B − a u × F_A = Ω × h u, com F_A + F_B = (0; ±m v²/R; m g)
u-points-forward-h-201-6-kg-m-s-0-4-rad-s-and-m-v-r-352-n-towards-the-centre-of-the-turn = u aponta para a frente; h = 201,6 kg·m²/s, Ω = 0,4 rad/s e m v²/R = 352 N, para o centro da curva.
of-all-that-turns-about-the-vertical-with-the-axle = De tudo o que gira com o eixo em torno da vertical.
of-the-axle-from-its-settled-direction-where-it-is-released-from-rest = Do eixo em relação à sua direção de equilíbrio, onde é solto do repouso.
path-of-a-ball-that-rolls-on-a-level-or-tilted-turntable-angular-velocity-centre-and-radius-of-its = Trajetória de uma bola que rola sobre uma mesa giratória nivelada ou inclinada: velocidade angular, centro e raio do círculo, deriva transversal à inclinação, posição num instante, atrito.
path-of-the-ball-seen-from-above = Trajetória da bola, vista de cima
pendulous = Pendular
pendulous-gyrocompass = Bússola giroscópica pendular
period-against-latitude = Período em função da latitude
period-at-that-depth-by-the-eigenvalues-of-the-equations-of-motion = período nessa profundidade pelos autovalores das equações do movimento
period-by-the-eigenvalues-of-the-equations-of-motion = período pelos autovalores das equações do movimento
period-from-the-initial-deviation = Período a partir do desvio inicial
period-of-small-oscillations-i-t-h-h = Período das pequenas oscilações: I_t α̈ = −h₁ Ω_h α
period-of-small-oscillations-the-axle-tilts-at-h-sin-and-turns-to-the-west-at-b-h-s-h-tan-v = Período das pequenas oscilações: o eixo se inclina com −Ω_h sen α e gira para oeste com (B/h_s + Ω_h) tan θ − Ω_v
period-of-the-oscillation-from-the-initial-deviation = Período da oscilação a partir do desvio inicial
person-who-walks-on-a-turntable = Pessoa que anda sobre uma mesa giratória
plainmath-net-question-13994-a-wheel-at-800-rpm-a-second-of-twice-its-inertia-at-rest = plainmath.net, questão 13994: uma roda a 800 rpm, uma segunda com o dobro da inércia em repouso
position-at-that-time = Posição nesse instante
position-at-that-time-the-arm-has-turned-and-the-centre-drifted = Posição nesse instante: o braço girou, e o centro derivou
position-by-integration-of-the-equations-of-motion = posição por integração das equações do movimento
positive-in-the-sense-in-which-the-blow-of-a-turns-the-body = Positiva no sentido em que o golpe de A gira o corpo.
positive-north-of-the-equator = Positiva ao norte do equador.
r-r-c-r-the-centre-lies-at-5-2-r-the-radius-is-7-2-r = r = r_c + R: o centro fica em −5/2 r₀, o raio é 7/2 r₀
radius-of-gyration-about-the-hinge = Raio de giração em relação à articulação
radius-of-the-circle-from-half-a-circle = raio do círculo por meio círculo
radius-of-the-earth = Raio da Terra
reduced-mass-of-the-two-that-of-their-relative-motion = Massa reduzida dos dois: a do seu movimento relativo
relative-angular-velocity = Velocidade angular relativa
relative-to-the-carrier-left-out-where-the-rotor-is-given-by-its-angular-momentum = Em relação ao veículo. Omitida quando o rotor é dado pelo momento angular.
relative-to-the-frame-left-out-where-the-wheel-is-given-by-its-angular-momentum = Em relação ao quadro. Omitida quando o volante é dado pelo momento angular.
released-60-from-the-meridian = Solta a 60° do meridiano
released-at-rest-on-the-turntable = Solta em repouso sobre a mesa giratória
rise-of-g-by-the-half-angle = subida de G pelo meio ângulo
rise-of-g-from-h-1-cos = Subida de G, por h (1 − cos θ)
rise-of-g-in-the-swing = Subida de G na oscilação
rising-at-the-bottom-of-a-loop-or-a-dip-falling-at-the-top-of-a-crest = Sobe no fundo de um looping ou de uma depressão, desce no topo de uma lombada.
satellite-that-sets-its-flywheel-spinning = Satélite que põe o seu volante em rotação
schuler-s-period = Período de Schuler
schuler-s-period-at-which-accelerations-of-the-vessel-do-not-deflect-the-compass = Período de Schuler, com que as acelerações da embarcação não desviam a bússola
second-number = Segundo número
second-wheel-coupled-to-a-shaft = Segunda roda acoplada a um eixo
share-of-the-kinetic-energy-lost = Parcela perdida da energia cinética
share-of-the-kinetic-energy-that-is-lost = Parcela da energia cinética que se perde
share-of-the-transverse-moment-of-inertia = Parte do momento de inércia transversal
shell-on-a-tilted-turntable = Casca numa mesa giratória inclinada
somebody-leaps-off-a-turntable-that-is-pushed = Alguém salta de uma mesa giratória que é empurrada
speed-and-direction-make-up-the-component-across-it = velocidade e direção compõem a componente transversal a ela
speed-and-direction-make-up-the-component-along-the-line = velocidade e direção compõem a componente ao longo da linha
speed-from-the-components-along-the-line-of-impact-and-across-it = Velocidade, pelas componentes ao longo da linha de impacto e transversal a ela
speed-given-twice = Rotação dada duas vezes
speed-left-out = Rotação omitida
speed-of-a-after = Velocidade de A depois
speed-of-b-after = Velocidade de B depois
sphere-against-the-lower-end-of-a-hanging-rod = Esfera contra a ponta inferior de uma barra suspensa
struck-body = Corpo atingido
support-of-the-axle = Apoio do eixo
swing-at-whose-end-the-energy-has-become-that-of-the-weight = Oscilação, no fim da qual a energia passou a ser a do peso
swing-of-the-hanging-body = Oscilação do corpo suspenso
the-angular-impulses-on-all-bodies-make-up-the-external-one = os impulsos angulares sobre todos os corpos compõem o externo
the-angular-momentum-about-the-axis-is-that-before-and-the-external-angular-impulse = O momento angular em relação ao eixo é o de antes e o impulso angular externo
the-angular-momentum-is-i = o momento angular é I ω
the-angular-momentum-of-arm-and-bob-is-conserved = o momento angular do braço e do peso se conserva
the-angular-momentum-of-the-rotor-contains-its-speed-leave-the-speed-out = o momento angular do rotor já contém a sua rotação: omita a rotação
the-axis-of-the-gimbal-has-no-direction-write-a-vector-other-than-zero = o eixo do cardã não tem direção: escreva um vetor diferente de zero
the-axle-crosses-the-settled-direction-after-a-quarter-of-the-period-by-integration = o eixo cruza a direção de equilíbrio após um quarto do período, por integração
the-axle-is-normal-to-the-velocity-of-the-vessel-in-space = o eixo é normal à velocidade da embarcação no espaço
the-axle-settles-along-the-horizontal-component-deviation-from-north-to-the-west = O eixo se acomoda ao longo da componente horizontal: desvio do norte para oeste
the-axle-stays-on-the-meridian-at-that-tilt-h-u = o eixo permanece no meridiano nessa inclinação: τ/h − Ω × u
the-axle-turned-by-a-rotation-matrix = o eixo girado por uma matriz de rotação
the-axle-turns-with-the-gimbal-about-its-axis = O eixo do rotor gira com o cardã em torno do eixo deste
the-ball-has-not-slipped = a bola não deslizou
the-bearing-forces-are-found-for-an-axle-that-lies-forward-across-or-upright-not-for-a-gimbal-leave = as forças dos mancais são calculadas para um eixo para a frente, transversal ou vertical, não para um cardã: omita os mancais, ou dê o movimento como uma velocidade angular qualquer
the-bearings-are-found-for-an-axle-along-an-axis-of-the-carrier = os mancais são calculados para um eixo segundo um eixo do veículo
the-bodies-along-the-axis-before = Os corpos ao longo do eixo, antes
the-bodies-at-the-impact-with-their-velocities-before = Os corpos no impacto, com as suas velocidades antes
the-book-cuts-1915-7-off = o livro trunca 1915,7
the-book-rounds-the-components-to-two-decimals = o livro arredonda as componentes para duas casas
the-book-rounds-the-moment-of-inertia-to-1-67-kg-m = o livro arredonda o momento de inércia para 1,67 kg·m²
the-carrier-is-level-at-the-moment = O veículo está nivelado nesse momento.
the-carrier-turns-about-an-axis-that-is-not-normal-to-the-axle-where-the-transverse-moment-of-inertia = o veículo gira em torno de um eixo que não é normal ao do rotor, onde o momento de inércia transversal conta junto com o em relação ao eixo: dê o rotor pelo momento de inércia e pela rotação, ou omita o momento de inércia transversal
the-centre-of-mass-lies-below-the-support-and-gravity-makes-the-tilted-axle-precess-the-inertia-of = O centro de massa fica abaixo do apoio, e a gravidade faz o eixo inclinado precessar. A inércia do rotor e do quadro é desprezada diante do momento angular.
the-compass-from-above-and-its-place-on-the-earth = A bússola vista de cima, e o seu lugar na Terra
the-couple-follows-from-i = o binário decorre de I ω
the-force-of-friction-from-rolling-without-slip = a força de atrito pelo rolamento sem deslizamento
the-gimbal-turns-about-it-by-the-right-hand-rule-components-forward-to-the-left-and-up = O cardã gira em torno dele pela regra da mão direita. Componentes para a frente, para a esquerda e para cima.
the-moment-of-inertia-about-the-hinge-is-less-than-that-of-the-mass-at-g-m-h-write-a-larger-one-or-g = o momento de inércia em relação à articulação é menor que o da massa em G, M h²: escreva um maior, ou G mais perto da articulação
the-path-is-a-circle-only-where-the-turntable-turns = a trajetória só é um círculo quando a mesa giratória gira
the-rate-of-change-of-the-angular-momentum = a taxa de variação do momento angular
the-rod-of-1-2-m-hangs-at-rest-from-its-upper-end-the-sphere-rebounds = A barra de 1,2 m pende em repouso da ponta superior. A esfera ricocheteia.
the-rotor-is-given-by-its-inertia-write-its-speed-or-give-its-angular-momentum = o rotor é dado pela inércia: escreva a sua rotação, ou dê o seu momento angular
the-rotor-is-too-slow-for-a-compass-beside-h-s-the-transverse-moment-of-inertia-turns-the-axle-away = o rotor é lento demais para uma bússola: diante de h_s o momento de inércia transversal afasta o eixo do meridiano; escreva um momento angular maior
the-same-aircraft-with-a-falling-nose-which-goes-to-the-left-200-9-81-10-288066-n-on-each-bearing = O mesmo avião com o nariz que desce, o qual vai para a esquerda: 200 (9,81 − 10,288066) N em cada mancal.
lost-share-from-the-ratio-of-the-kinetic-energies = parcela perdida pela razão das energias cinéticas
the-table-takes-900-knots-for-the-speed-of-the-equator-which-is-903 = a tabela toma 900 nós para a velocidade do equador, que é 903
the-time-of-the-slip-is-found-without-an-external-angular-impulse-write-zero-for-it-or-leave-the = o tempo de deslizamento é calculado sem impulso angular externo: escreva zero para ele, ou omita o torque
the-torque-of-a-coupling-acts-between-two-bodies = o torque de um acoplamento age entre dois corpos
the-torque-of-a-coupling-acts-between-two-bodies-write-two-of-them-or-leave-the-torque-out = o torque de um acoplamento age entre dois corpos: escreva dois deles, ou omita o torque
the-turntable-from-above-and-its-tilt-from-the-side = A mesa giratória vista de cima e a sua inclinação vista de lado
the-turntable-is-at-rest-and-the-ball-rolls-in-a-straight-line-or-a-parabola-write-an-angular = a mesa giratória está em repouso, e a bola rola em linha reta ou numa parábola: escreva uma velocidade angular diferente de zero
the-turntable-makes-7-revolutions-in-30-s-the-ball-released-at-rest-on-it-200-mm-from-the-axis-runs = A mesa giratória dá 7 voltas em 30 s. A bola, solta em repouso sobre ela a 200 mm do eixo, corre num círculo de 7/2 desse raio.
the-vessel-runs-to-the-west-as-fast-as-the-earth-turns-to-the-east-no-direction-is-left-to-the = a embarcação corre para oeste tão depressa quanto a Terra gira para leste: não resta direção à bússola; escreva uma velocidade menor
the-way-to-the-north-turns-the-level-plane-about-the-west = O caminho para o norte gira o plano horizontal em torno do oeste
there-is-no-impact-between-bodies-that-part = não há impacto entre corpos que se afastam
they-separate = Separam-se
they-stick-together = Ficam unidos
thin-shell = Casca fina
this-curve = esta curva
this-impact = este impacto
this-system = este sistema
tilt-north-end-upwards-the-moment-of-the-weight-turns-the-axle-with-the-meridian-b-sin-h-s-v-cos-h = Inclinação, ponta norte para cima: o momento do peso gira o eixo com o meridiano, B sen θ₀ = h_s (Ω_v cos θ₀ − Ω_h sen θ₀)
tilt-of-the-axle-north-end-upwards = Inclinação do eixo, ponta norte para cima
tilt-of-the-turntable = Inclinação da mesa giratória
time-in-which-the-torque-brings-the-second-body-to-it = tempo em que o torque leva o segundo corpo a ela
time-of-one-circle = Tempo de um círculo
time-of-the-slip = Tempo de deslizamento
time-of-the-slip-the-torque-brings-the-first-body-to-the-common-angular-velocity = Tempo de deslizamento: o torque leva o primeiro corpo à velocidade angular comum
torque-of-the-coupling = Torque do acoplamento
two-balls-that-meet = Duas bolas que se encontram
two-bodies-that-move-on-together = Dois corpos que seguem juntos
two-flywheels-joined-by-a-spring-at-equal-speeds = Dois volantes ligados por uma mola, com velocidades iguais
two-linear-equations-angular-momentum-about-the-hinge-and-e-u-r-r-v = duas equações lineares: momento angular em relação à articulação, e e (u − ω₀ r) = ω r − v
two-revolutions-while-the-turntable-makes-seven = Duas voltas enquanto a mesa giratória dá sete
two-smooth-discs-oblique = Dois discos lisos, oblíquos
two-vehicles-that-stick-together-at-a-crossing = Dois veículos que ficam unidos num cruzamento
u-cos-is-reversed-and-multiplied-by-e-u-sin-remains = u cos φ se inverte e é multiplicado por e, u sen φ permanece
unit-vector-of-the-axis-of-the-gimbal = Vetor unitário do eixo do cardã
unit-vector-of-the-spin-turned-by-the-gimbal-angle-about-its-axis = Vetor unitário da rotação, girado do ângulo do cardã em torno do eixo deste
v-r-e-to-the-west-on-the-equator = v = R_E Ω para oeste no equador
vaia-com-kibble-berkshire-classical-mechanics-ch-9-problem-15 = vaia.com, Kibble & Berkshire, Classical Mechanics, cap. 9, problema 15
velocities-after-a-direct-or-oblique-central-impact-on-a-free-body-a-wall-or-a-hinged-body-impulse = Velocidades depois de um impacto central direto ou oblíquo, num corpo livre, numa parede ou num corpo articulado; impulso, energia perdida, e a oscilação de um pêndulo balístico.
velocities-after-the-impact-against-the-coefficient-of-restitution = Velocidades depois do impacto em função do coeficiente de restituição
velocity-along-the-line-of-impact = velocidade ao longo da linha de impacto
velocity-by-integration = velocidade por integração
velocity-given = Velocidade dada
velocity-of-a-after-along-the-line = Velocidade de A depois, ao longo da linha
velocity-of-a-after-the-impact-along-the-line-of-impact = Velocidade de A depois do impacto, ao longo da linha de impacto
velocity-of-approach-along-the-line-of-impact = Velocidade de aproximação ao longo da linha de impacto
velocity-of-b-after-along-the-line = Velocidade de B depois, ao longo da linha
velocity-of-body-a-before = Velocidade do corpo A antes
velocity-of-body-b-before = Velocidade do corpo B antes
velocity-of-separation-e-times-that-of-approach = velocidade de separação = e vezes a de aproximação
velocity-of-the-struck-body-there-along-the-line-of-impact = Velocidade do corpo atingido nesse ponto, ao longo da linha de impacto
velocity-of-the-struck-point-before-the-impact = Velocidade do ponto atingido antes do impacto
velocity-of-the-turntable-under-the-ball = Velocidade da mesa giratória sob a bola
velocity-relative-to-the-drift = Velocidade em relação à deriva
velocity-to-the-east = Velocidade para leste
velocity-to-the-north = Velocidade para norte
vertical-component-of-the-angular-velocity-of-the-earth-upwards = Componente vertical da velocidade angular da Terra, para cima
vertical-component-upwards = Componente vertical, para cima
vertical-curve-loop-pull-out-of-a-dive-crest = Curva vertical: looping, saída de mergulho, lombada
vessel = Embarcação
vessel-on-a-course-of-30 = Embarcação no rumo de 30°
pendulous-gyrocompass-on-a-vessel-that-steers-south-west = Bússola giroscópica pendular em uma embarcação no rumo sudoeste
equilibrium-and-linearised-form-of-h-u-h-u-with-the-motion-of-the-vessel-in-independently-of-the = equilíbrio e forma linearizada de h u̇ = τ − Ω × h u, com o movimento da embarcação em Ω, independentemente do programa
n-13-m-s-on-a-course-of-215-in-latitude-38-north-the-axle-points-to-the-east-of-north = 13 m/s no rumo de 215° na latitude 38° norte: o eixo aponta a leste do norte.
vessel-that-steers-north-in-high-latitude = Embarcação que navega para norte em latitude alta
what-turns-with-the-common-angular-velocity-has-no-moment-of-inertia-write-a-distance-from-the-axis = o que gira com a velocidade angular comum não tem momento de inércia: escreva uma distância ao eixo maior que zero
wheel-by-its-angular-momentum = Volante pelo momento angular
with-the-mass-m-and-the-radius-of-the-ball-2-5-for-a-solid-one = Com a massa m e o raio ρ da bola: 2/5 para uma maciça.
with-the-parallel-axis-theorem = Com o teorema dos eixos paralelos.

# rigid-body/attitude, rigid-body/attitude-motion and the damping of rigid-body/gyrocompass
n-3-1-3-precession-nutation-spin = 3-1-3: precessão, nutação, rotação própria
n-3-2-1-angles-of-40-30-and-80-at-the-start-20-s-sin-0-1t-0-01-cos-0-1t-in-b = Ângulos 3-2-1 de 40°, 30° e 80° no início, ω = 20°/s (sen 0,1t; 0,01; cos 0,1t) em B.
n-3-2-1-yaw-pitch-roll = 3-2-1: guinada, arfagem, rolamento
a-third-of-a-turn-about-the-space-diagonal = Um terço de volta em torno da diagonal do cubo
rotation-of-150-about-an-oblique-axis = Rotação de 150° em torno de um eixo oblíquo
closed-form-bn-cos-1-1-cos-e-e-sin-e-cos-2-e-sin-2-q-e-tan-2-e-tan-4 = forma fechada: [BN] = cos Φ 1 + (1 − cos Φ) e eᵀ − sen Φ [e×], β₀ = cos(Φ/2), ε = e sen(Φ/2), q = e tan(Φ/2), σ = e tan(Φ/4)
e-1-2-6-41-is-the-largest-euler-parameter-and-is-above-zero = e = (1; −2; 6)/√41: β₃ é o maior parâmetro de Euler, e β₀ é positivo.
aerospace-toolbox-documentation-angle2dcm-and-angle2rod-first-examples = Documentação do Aerospace Toolbox, angle2dcm e angle2rod, primeiros exemplos
aerospace-toolbox-documentation-angle2dcm-and-angle2rod-second-row-of-the-second-examples = Documentação do Aerospace Toolbox, angle2dcm e angle2rod, segunda linha dos segundos exemplos
aerospace-toolbox-documentation-quat2dcm-second-quaternion-of-the-example-1-0-5-0-3-0-1-divided-by = Documentação do Aerospace Toolbox, quat2dcm, segundo quatérnio do exemplo: (1; 0,5; 0,3; 0,1), dividido por seu comprimento
aerospace-toolbox-documentation-quat2rod-example = Documentação do Aerospace Toolbox, quat2rod, exemplo
aerospace-toolbox-documentation-rod2dcm-and-rod2angle-examples = Documentação do Aerospace Toolbox, rod2dcm e rod2angle, exemplos
along-the-principal-axis-as-long-as-tan-2 = Ao longo do eixo principal, com o comprimento tan(Φ/2).
along-the-principal-axis-as-long-as-tan-4 = Ao longo do eixo principal, com o comprimento tan(Φ/4).
along-the-principal-axis-as-long-as-the-angle-in-radians = Ao longo do eixo principal, com o comprimento do ângulo em radianos.
amplitude-of-the-envelope-a-e-t-from-rest-at-the-deviation-at-the-start = Amplitude da envoltória A e^(−ζ ω₀ t), a partir do repouso no desvio inicial
angular-frequency-of-small-oscillations-without-damping = Frequência angular das pequenas oscilações sem amortecimento
angular-frequency-with-damping-2-0 = Frequência angular com amortecimento: α̈ + 2 ζ ω₀ α̇ + ω₀² α = 0
angular-velocity-at-the-end-in-b = Velocidade angular no final, em B
angular-velocity-at-the-end-in-b-bn-times-that-in-n = Velocidade angular no final, em B: [BN] vezes a de N
angular-velocity-at-the-end-in-n = Velocidade angular no final, em N
angular-velocity-at-the-end-in-n-bn-times-that-in-b = Velocidade angular no final, em N: [BN]ᵀ vezes a de B
angular-velocity-from-rates-of-euler-parameters = Velocidade angular a partir das taxas dos parâmetros de Euler
angular-velocity-from-rates-of-modified-rodrigues-parameters = Velocidade angular a partir das taxas dos parâmetros de Rodrigues modificados
angular-velocity-in-b = Velocidade angular em B
angular-velocity-in-n = Velocidade angular em N
angular-velocity-in-components-in-b-from-the-rates-of-the-euler-parameters = Velocidade angular em componentes em B a partir das taxas dos parâmetros de Euler
angular-velocity-in-components-in-b-from-the-rates-of-the-modified-rodrigues-parameters = Velocidade angular em componentes em B a partir das taxas dos parâmetros de Rodrigues modificados
angular-velocity-in-components-in-b-as-given = Velocidade angular em componentes em B, como dada
angular-velocity-in-components-in-b-bn-times-that-in-n = Velocidade angular em componentes em B: [BN] vezes a de N
angular-velocity-in-components-in-b-each-rate-about-its-axis = Velocidade angular em componentes em B: cada taxa em torno de seu eixo
angular-velocity-in-components-in-n-bn-times-that-in-b = Velocidade angular em componentes em N: [BN]ᵀ vezes a de B
angular-velocity-in-fixed-axes = Velocidade angular em eixos fixos
angular-velocity-components-in-b = Velocidade angular, componentes em B
angular-velocity-components-in-n = Velocidade angular, componentes em N
angular-velocity-sum-of-terms = Velocidade angular: soma de termos
as-given = Como dada
attitude-from-the-angular-velocity = Atitude a partir da velocidade angular
attitude-of-b-relative-to-n = Atitude de B em relação a N
attitude-of-a-body = Atitude de um corpo
attitude-of-a-body-after-a-time-from-its-angular-velocity-as-a-function-of-time-by-integration-of = Atitude de um corpo após um tempo, a partir de sua velocidade angular em função do tempo, por integração dos parâmetros de Euler: cossenos diretores, ângulos de Euler, quatérnio, parâmetros de Rodrigues e suas evoluções no tempo.
attitude-of-one-spacecraft-relative-to-another = Atitude de uma espaçonave em relação a outra
b-of-the-body = B: do corpo
both-sets-of-parameters-of-this-attitude = Os dois conjuntos de parâmetros desta atitude
cayley-s-formula-for-the-rodrigues-parameters = a fórmula de Cayley para os parâmetros de Rodrigues
cayley-s-formula-squared-for-modified-rodrigues-parameters = a fórmula de Cayley, ao quadrado, para os parâmetros de Rodrigues modificados
components-in-b-bn-times-those-in-n = Componentes em B: [BN] vezes as de N
components-in-n-the-transpose-bn-times-those-in-b = Componentes em N: a transposta [BN]ᵀ vezes as de B
components-in-the-other-axes = Componentes nos outros eixos
components-of-the-angular-velocity-in = Componentes da velocidade angular em
components-in-any-unit = Componentes, em qualquer unidade
constant-about-n-decaying-about-n-proportional-to-the-time-about-n = Constante em torno de n₁, decrescente em torno de n₂, proporcional ao tempo em torno de n₃.
convertattitude-matlab-central-file-exchange-47318-first-example = ConvertAttitude, MATLAB Central File Exchange 47318, primeiro exemplo
damped-compass-each-swing-a-third-of-the-one-before = Bússola amortecida, cada oscilação um terço da anterior
damped-period = Período amortecido
damping-and-settling = Amortecimento e acomodação
damping-ratio-from-the-logarithmic-decrement = Fator de amortecimento a partir do decremento logarítmico
damping-ratio-as-given = Fator de amortecimento, como dado
damping-ratio-c-2-i-t = Fator de amortecimento: c = 2 ζ I_t ω₀
davenport-s-matrix-times-the-euler-parameters-less-the-eigenvalue-times-them = a matriz de Davenport vezes os parâmetros de Euler, menos o autovalor vezes eles
deviation-at-the-start-at-rest = Desvio inicial, em repouso
deviation-taken-as-settled = Desvio tomado como acomodado
direction-cosine-matrix = Matriz de cossenos diretores
direction-cosine-matrix-euler-angles-of-any-sequence-principal-axis-and-angle-euler-parameters-and = Matriz de cossenos diretores, ângulos de Euler de qualquer sequência, eixo e ângulo principais, parâmetros de Euler e de Rodrigues de uma atitude, cada um a partir de qualquer outro; suas taxas e a velocidade angular.
direction-in-b-of-any-length = Direção em B, de qualquer comprimento
direction-in-n-of-any-length = Direção em N, de qualquer comprimento
each-rotation-is-about-an-axis-of-the-frame-that-the-one-before-it-left = Cada rotação é em torno de um eixo do referencial deixado pela anterior.
euler-angle = Ângulo de Euler
euler-angles-against-the-principal-angle = Ângulos de Euler em função do ângulo principal
euler-angles-against-the-second-angle-given = Ângulos de Euler em função do segundo ângulo dado
euler-angles-against-time = Ângulos de Euler em função do tempo
euler-angles-to-calculate = Ângulos de Euler a calcular
euler-parameter = Parâmetro de Euler
euler-parameter-scalar-part = Parâmetro de Euler β₀, parte escalar
euler-parameters-against-time = Parâmetros de Euler em função do tempo
euler-parameters-over-42-s = Parâmetros de Euler em 42 s
euler-parameters = Parâmetros de Euler β₁, β₂, β₃
euler-parameters-unit-quaternion = Parâmetros de Euler: quatérnio unitário
exponential-decay = Decaimento exponencial
first-euler-angle-from-the-ratio-of-two-elements-of-bn = Primeiro ângulo de Euler, da razão de dois elementos de [BN]
first-angle = Primeiro ângulo
first-direction-in-b = Primeira direção, em B
first-direction-in-n = Primeira direção, em N
first-row-of-the-direction-cosine-matrix-b-in-n = Primeira linha da matriz de cossenos diretores: b₁ em N
first-row-b-in-components-in-n = Primeira linha: b₁ em componentes em N
first-vector-of-the-triad-along-the-first-direction = Primeiro vetor da tríade: ao longo da primeira direção
for-an-axle-held-level = Para um eixo mantido na horizontal.
from-3-2-1-to-1-2-1 = De 3-2-1 a 1-2-1
gimbal-lock = Bloqueio de cardã
gimbal-lock-only-the-sum-or-difference-of-the-first-and-third-angles-is-determined-the-third-is-set = Bloqueio de cardã: só a soma ou a diferença do primeiro e do terceiro ângulo é determinada; anula-se o terceiro
given-in-the-axes = Dadas nos eixos
h-schaub-j-l-junkins-analytical-mechanics-of-space-systems-3-3-3-2-1-angles-of-10-25-15-and-30-45-60 = H. Schaub, J. L. Junkins, Analytical Mechanics of Space Systems, §3.3: ângulos 3-2-1 de (10°; 25°; −15°) e (30°; −45°; 60°)
half-a-turn = Meia volta
if-given-the-rates-of-all-parameters-are-also-calculated-or-the-angular-velocity-from-the-rates = Se for dada, calculam-se também as taxas de todos os parâmetros, ou a velocidade angular a partir das taxas.
in-order-from-n-each-is-of-the-frame-that-the-one-before-it-left-their-matrices-are-multiplied-from = Em ordem a partir de N: cada uma é do referencial deixado pela anterior. Suas matrizes são multiplicadas pela esquerda.
inverted-the-transpose = Invertida: a transposta
its-components-in-n-and-in-b-are-the-same = Suas componentes em N e em B são as mesmas.
largest-euler-parameter-from-the-diagonal-of-bn-the-others-by-division-by-it = Maior parâmetro de Euler, da diagonal de [BN]: os outros por divisão por ele
later-amplitude-over-the-one-before-it = Amplitude posterior sobre a anterior
left-out-for-the-undamped-compass = Omitido para a bússola sem amortecimento.
length-of-the-euler-parameters-as-given-off-1-by-rounding = Comprimento dos parâmetros de Euler dados, que difere de 1 por arredondamento
length-of-the-vector-part-sin-2 = Comprimento da parte vetorial: sen(Φ/2)
level-axle-in-a-viscous-fluid = Eixo horizontal em um fluido viscoso
level-axle-with-a-damping-ratio-of-0-2 = Eixo horizontal com fator de amortecimento de 0,2
level-axle-with-a-logarithmic-decrement-of-0-9 = Eixo horizontal com decremento logarítmico de 0,9
logarithmic-decrement-over-a-whole-period = Decremento logarítmico em um período inteiro
logarithmic-decrement-two-swings-make-up-a-period = Decremento logarítmico: duas oscilações perfazem um período
modified-rodrigues-parameters = Parâmetros de Rodrigues modificados
modified-rodrigues-parameters-over-42-s = Parâmetros de Rodrigues modificados em 42 s
modified-rodrigues-parameters-along-the-axis-with-tan-4 = Parâmetros de Rodrigues modificados, ao longo do eixo com tan(Φ/4)
n-fixed = N: fixos
observed-directions = Direções observadas
of-amplitudes-on-opposite-sides-half-a-period-apart = De amplitudes em lados opostos, a meio período uma da outra.
of-the-sequence-that-is-calculated = Da sequência que se calcula.
of-the-set-that-is-no-longer-than-1 = Do conjunto de comprimento até 1.
period-of-a-gyrocompass-about-the-meridian-directing-couple-damping-and-settling-time-tilt-and = Período de uma bússola giroscópica em torno do meridiano, binário diretor, amortecimento e tempo de acomodação, inclinação e sintonia de Schuler de uma pendular, e seu desvio em um navio em movimento.
principal-angle = Ângulo principal
principal-angle-against-the-second-angle = Ângulo principal em função do segundo ângulo
principal-angle-from-0-to-180 = Ângulo principal, de 0° a 180°
principal-angle-length-of-the-principal-rotation-vector = Ângulo principal: comprimento do vetor de rotação principal
principal-axis = Eixo principal
principal-axis-and-angle = Eixo e ângulo principais
principal-axis-in-components-in-n-and-in-b-alike = Eixo principal, em componentes iguais em N e em B
principal-axis-of-any-length = Eixo principal, de qualquer comprimento
principal-rotation-vector = Vetor de rotação principal
principal-rotation-vector-axis-times-angle = Vetor de rotação principal: eixo vezes ângulo
printed-direction-cosine-matrix = Matriz de cossenos diretores impressa
proportional-to-the-time = Proporcional ao tempo
quaternion-with-a-negative-scalar-part = Quatérnio com parte escalar negativa
quaternion-normalised = Quatérnio, normalizado
rate-of-an-euler-angle-resolved-along-the-axes-of-the-three-rotations = Taxa de um ângulo de Euler: ω decomposta nos eixos das três rotações
rate-of-modified-rodrigues-parameters = Taxa dos parâmetros de Rodrigues modificados
rate-of-the-euler-angle = Taxa do ângulo de Euler
rate-of-the-rodrigues-parameters = Taxa dos parâmetros de Rodrigues
rate-of-the-first-angle = Taxa do primeiro ângulo
rate-of-the-modified-rodrigues-parameters = Taxa dos parâmetros de Rodrigues modificados
rate-of-the-scalar-euler-parameter = Taxa do parâmetro de Euler escalar
rate-of-the-scalar-part = Taxa da parte escalar
rate-of-the-second-angle = Taxa do segundo ângulo
rate-of-the-third-angle = Taxa do terceiro ângulo
rate-of-the-vector-part = Taxa da parte vetorial
rate-of = Taxa de β₀
rates-of-modified-rodrigues-parameters = Taxas dos parâmetros de Rodrigues modificados
rates-of-the-euler-angles = Taxas dos ângulos de Euler
rates-of-the-euler-parameters = Taxas dos parâmetros de Euler
rates-of-yaw-pitch-and-roll = Taxas de guinada, arfagem e rolamento
rates-of = Taxas de β₁, β₂, β₃
ratio-of-successive-swings = Razão entre oscilações sucessivas
ratio-of-successive-swings-on-opposite-sides = Razão entre oscilações sucessivas, em lados opostos
relative-attitude-by-quaternions = Atitude relativa por quatérnios
rodrigues-parameters = Parâmetros de Rodrigues
rodrigues-parameters-over-42-s = Parâmetros de Rodrigues em 42 s
rodrigues-parameters-along-the-axis-with-tan-2 = Parâmetros de Rodrigues, ao longo do eixo com tan(Φ/2)
rodrigues-parameters-gibbs-vector = Parâmetros de Rodrigues: vetor de Gibbs
rotation = Rotação
rotation-at-this-instant = Rotação neste instante
rotations-in-order = Rotações, em ordem
rounded-to-six-decimals-so-that-the-nearest-rotation-is-taken = Arredondada a seis casas decimais; toma-se a rotação mais próxima.
row-of-bn = Linha de [BN]
row-of-bn-bt-nt-the-triad-in-components-in-b-times-the-triad-in-n = Linha de [BN] = [BT][NT]ᵀ: a tríade em componentes em B, vezes a tríade em N
row-of-bn-at-the-end = Linha de [BN] no final
row-of-the-direction-cosine-matrix-of-these-euler-parameters = Linha da matriz de cossenos diretores destes parâmetros de Euler
row-of-the-nearest-rotation-c-c-c-1-2-the-matrix-as-given-is-off-orthonormal-by-rounding = Linha da rotação mais próxima [C]([C]ᵀ[C])^(−1/2): a matriz dada não é ortonormal por arredondamento
scalar-euler-parameter-at-the-end-integral-of-2-with-in-components-in-b = Parâmetro de Euler escalar no final: integral de β̇₀ = −ε · ω/2, com ω em componentes em B
scalar-euler-parameter-from-the-rodrigues-parameters = Parâmetro de Euler escalar a partir dos parâmetros de Rodrigues
scalar-euler-parameter-from-the-modified-rodrigues-parameters = Parâmetro de Euler escalar a partir dos parâmetros de Rodrigues modificados
scalar-euler-parameter-the-eigenvector-of-the-largest-eigenvalue-of-davenport-s-matrix = Parâmetro de Euler escalar: o autovetor do maior autovalor da matriz de Davenport
scalar-euler-parameter-of-the-two-sets-of-opposite-sign-that-with-0 = Parâmetro de Euler escalar; dos dois conjuntos de sinais opostos, o de β₀ ≥ 0
scalar-part = Parte escalar
scalar-part-normalised = Parte escalar, normalizada
scipy-documentation-rotation-from-mrp-first-example-0-0-1-is-180-about-z = Documentação do SciPy, Rotation.from_mrp, primeiro exemplo: (0; 0; 1) é 180° em torno de z
second-euler-angle-from-0-to-180-from-the-element-of-bn-that-is-its-cosine = Segundo ângulo de Euler, de 0° a 180°, do elemento de [BN] que é seu cosseno
second-euler-angle-from-90-to-90-from-the-element-of-bn-that-is-its-sine = Segundo ângulo de Euler, de −90° a 90°, do elemento de [BN] que é seu seno
second-angle = Segundo ângulo
second-direction-in-b = Segunda direção, em B
second-direction-in-n = Segunda direção, em N
second-row-of-the-direction-cosine-matrix-b-in-n = Segunda linha da matriz de cossenos diretores: b₂ em N
second-row-b-in-components-in-n = Segunda linha: b₂ em componentes em N
second-vector-of-the-triad-normal-to-both-directions = Segundo vetor da tríade: normal às duas direções
sequence = Sequência
sequence-2-1-3 = Sequência 2-1-3
set = Conjunto
settling-of-the-compass = Acomodação da bússola
settling-time-the-envelope-has-come-down-to-the-deviation-taken-as-settled = Tempo de acomodação: a envoltória desceu ao desvio tomado como acomodado
shadow-set-the-rotation-the-long-way-round-by-360 = Conjunto sombra: a rotação pelo caminho longo, de Φ − 360°
solutions-to-kinematics-describing-the-motions-of-spacecraft-h-schaub-concept-checks-on-principal = Soluções de Kinematics: Describing the Motions of Spacecraft (H. Schaub), questões sobre rotações principais: a matriz dos ângulos 3-2-1 de 20°, −10° e 120°
spin-and-precession = Rotação própria e precessão
square-of-the-modified-rodrigues-parameters = Quadrado dos parâmetros de Rodrigues modificados
steady-rotation-about-a-body-axis = Rotação uniforme em torno de um eixo do corpo
successive-rotations = Rotações sucessivas
successive-rotations-the-matrix-of-the-later-one-times-that-of-the-earlier-ones = Rotações sucessivas: a matriz da posterior vezes a das anteriores
successive-swings-on-opposite-sides-as-one-to-three-with-the-undamped-period-of-7314-339-s = Oscilações sucessivas em lados opostos como um para três, com o período sem amortecimento de 7314,339 s.
sum-of-two-rotations = Soma de duas rotações
sun-and-magnetic-field-by-triad = Sol e campo magnético pelo TRIAD
sun-and-magnetic-field-by-the-q-method = Sol e campo magnético pelo método q
the-rodrigues-parameters-are-infinite-and-the-axis-may-be-taken-in-either-sense = Os parâmetros de Rodrigues são infinitos, e o eixo pode ser tomado em qualquer dos dois sentidos.
the-attitude-of-b-relative-to-r-from-those-of-both-in-n-that-of-r-inverted-then-that-of-b = A atitude de B em relação a R, a partir das de ambos em N: a de R invertida, depois a de B.
the-attitude-of-the-least-sum-of-weighted-squares-of-the-errors-of-directions-wahba-s-problem = A atitude da menor soma ponderada dos quadrados dos erros das direções: problema de Wahba.
the-course-asks-for-the-length-of-the-parameters-0-6394 = O curso pede o comprimento dos parâmetros, 0,6394.
the-frames-n-and-b = Os referenciais N e B
the-frames-n-and-b-and-the-principal-axis = Os referenciais N e B, e o eixo principal
the-inverse-is-the-transpose-a-column-becomes-a-row = A inversa é a transposta: uma coluna torna-se linha
the-more-accurate-one-of-any-length-as-all-four-vectors = A mais exata; de qualquer comprimento, como os quatro vetores.
the-other-set-of-parameters-with-0-is-the-same-attitude-90-about-the-second-axis = O outro conjunto de parâmetros, com β₀ ≥ 0, é a mesma atitude: −90° em torno do segundo eixo.
the-rates-of-the-three-angles-still-tell-the-angular-velocity-but-not-the-other-way-round = As taxas dos três ângulos ainda determinam a velocidade angular, mas não o contrário.
the-scalar-part-stands-first-the-toolbox-normalises-what-it-is-given-here-the-four-numbers-are = A parte escalar vem primeiro. O toolbox normaliza o que recebe; aqui os quatro números são divididos por √1,35.
third-euler-angle-from-the-ratio-of-two-elements-of-bn = Terceiro ângulo de Euler, da razão de dois elementos de [BN]
third-euler-angle-set-to-zero-at-gimbal-lock = Terceiro ângulo de Euler, anulado no bloqueio de cardã
third-angle = Terceiro ângulo
third-row-of-the-direction-cosine-matrix-b-in-n = Terceira linha da matriz de cossenos diretores: b₃ em N
third-row-b-in-components-in-n = Terceira linha: b₃ em componentes em N
third-vector-of-the-triad = Terceiro vetor da tríade
time-at-which-it-has-the-value-above = Instante em que tem o valor acima
times-e-t = Vezes e^(−t/τ).
times-sin-pt-a-phase-of-90-for-a-cosine = Vezes sen(pt + φ): fase de 90° para um cosseno.
trace-of-bn = Traço de [BN]
triple-product-of-the-axes-of-the-three-rotations-zero-at-gimbal-lock = Produto misto dos eixos das três rotações: nulo no bloqueio de cardã
twelve-sequences-one-after-another = Doze sequências, uma após a outra
two-directions-seen-in-both-frames-triad = Duas direções nos dois referenciais: TRIAD
unit-vector-along-the-principal-axis = Vetor unitário ao longo do eixo principal
vector-part = Parte vetorial
vector-part-at-the-end-integral-of-2 = Parte vetorial no final: integral de ε̇ = (β₀ ω + ε × ω)/2
vector-part-of-the-euler-parameters-e-sin-2 = Parte vetorial dos parâmetros de Euler: e sen(Φ/2)
vector-part-from-q = Parte vetorial, de q = ε/β₀
vector-part-from-1 = Parte vetorial, de σ = ε/(1 + β₀)
vector-part-normalised = Parte vetorial, normalizada
vector-part-the-rest-of-the-eigenvector = Parte vetorial: o resto do autovetor
vectors-in-other-axes = Vetores em outros eixos
viscous-damping-about-the-vertical = Amortecimento viscoso em torno da vertical
weighted-directions-q-method = Direções ponderadas: método q
yaw-and-pitch = Guinada e arfagem
yaw-pitch-and-roll-over-42-s = Guinada, arfagem e rolamento em 42 s
bn-as-the-product-of-the-three-euler-rotations = [BN] como produto das três rotações de Euler
bn-at-the-end-by-integration-of-poisson-s-equation-dc-dt-c = [BN] no final por integração da equação de Poisson, dC/dt = −[ω×] C
bn-at-the-end-by-one-rotation-about-the-constant-angular-velocity = [BN] no final por uma só rotação em torno da velocidade angular constante
bn-brings-the-first-direction-and-the-normal-to-both-into-those-in-b = [BN] leva a primeira direção e a normal a ambas às de B
bn-by-a-rotation-about-the-principal-axis = [BN] por uma rotação em torno do eixo principal
bn-by-the-principal-rotation-vector = [BN] pelo vetor de rotação principal
it-changes-components-in-n-into-components-in-b-the-transpose-of-a-matrix-that-rotates-vectors = Transforma componentes em N em componentes em B. É a transposta de uma matriz que gira vetores.
bn-from-vectors-rotated-by-the-quaternion = [BN] a partir de vetores girados pelo quatérnio
fb-fn-bn-back-from-b-to-n-then-on-to-f = [FB] = [FN][BN]ᵀ: de volta de B a N, e depois a F.
a-pendulous-compass-is-not-damped-about-the-vertical-alone-give-the-damping-ratio-the-decrement-or = uma bússola pendular não é amortecida só em torno da vertical: dê o fator de amortecimento, o decremento ou a razão entre oscilações sucessivas
a-principal-rotation-vector-of-zero-is-no-rotation-and-has-no-axis-give-the-attitude-by-an-axis-and = um vetor de rotação principal nulo não é rotação e não tem eixo: dê a atitude por um eixo e um ângulo de 0°
a-third-of-a-turn-about-1-1-1-exchanges-the-axes-in-a-cycle = um terço de volta em torno de (1; 1; 1) troca os eixos em ciclo
angles-of-the-product-of-the-three-rotations-worked-with-scipy = ângulos do produto das três rotações, calculados com SciPy
at-gimbal-lock-the-angles-of-this-sequence-do-not-tell-the-axes-of-their-rates-choose-another = no bloqueio de cardã, os ângulos desta sequência não determinam os eixos de suas taxas: escolha outra sequência, ou dê a velocidade angular
components-of-the-angular-velocity-from-the-rates-of-precession-nutation-and-spin-as-in-h-goldstein = componentes da velocidade angular a partir das taxas de precessão, nutação e rotação própria, como em H. Goldstein, Classical Mechanics, §4.9
cos-from-the-trace-of-bn = cos Φ a partir do traço de [BN]
data-of-a-concept-check-of-kinematics-describing-the-motions-of-spacecraft-h-schaub-integrated-to = dados de uma questão de Kinematics: Describing the Motions of Spacecraft (H. Schaub), integrados com dezoito algarismos com mpmath
deviation = desvio
gimbal-lock-at-this-second-angle-the-first-and-the-third-rotation-of-sequence-are-about-one-line-the = bloqueio de cardã: com este segundo ângulo, a primeira e a terceira rotação de { $sequence } são em torno da mesma reta; o terceiro ângulo foi anulado
gimbal-lock-the-euler-angles-of-sequence-have-no-rates-for-every-angular-velocity-here-take-another = bloqueio de cardã: os ângulos de Euler de { $sequence } não têm aqui taxas para toda velocidade angular; use outra sequência
integrated-to-eighteen-digits-with-mpmath = integrada com dezoito algarismos com mpmath
it-leaves-a-symmetric-stretch-of-the-matrix-given = ela deixa um alongamento simétrico da matriz dada
its-components-in-b-by-bn-times-those-in-n = suas componentes em B, por [BN] vezes as de N
ln-3-2-4-and-the-envelope-a-e-t-from-30-to-1 = ln 3 = δ/2, ζ = δ/√(4π² + δ²), e a envoltória A e^(−ζ ω₀ t) de 30° a 1°
long-way = caminho longo
matrix-exponential-worked-with-scipy = exponencial de matriz, calculada com SciPy
one-of-the-directions-has-no-length-write-any-vector-along-it = uma das direções não tem comprimento: escreva qualquer vetor ao longo dela
product-of-the-rotation-matrices-worked-with-scipy = produto das matrizes de rotação, calculado com SciPy
rate-of-the-rodrigues-parameters-from-that-of = taxa dos parâmetros de Rodrigues a partir da de ε/β₀
rate-of-the-modified-rodrigues-parameters-by-differences-of-the-attitude = taxa dos parâmetros de Rodrigues modificados por diferenças da atitude
rate-of-by-differences-of-the-attitude = taxa de β₀ por diferenças da atitude
rates-of-by-differences-of-the-attitude = taxas de β₁, β₂, β₃ por diferenças da atitude
rows-of-the-nearest-rotation-are-orthonormal = as linhas da rotação mais próxima são ortonormais
settled = acomodado
short-way = caminho curto
the-euler-parameters-have-the-length-length-and-those-of-a-rotation-have-1-divide-all-four-by-their = os parâmetros de Euler têm o comprimento { $length }, e os de uma rotação têm 1: divida os quatro por seu comprimento, ou confira-os
the-angle-between-the-two-directions-is-difference-larger-or-smaller-in-b-than-in-n-the-second = o ângulo entre as duas direções difere { $difference } entre B e N: a segunda direção é satisfeita só em parte
the-angular-velocity-at-the-end = a velocidade angular no final
the-angular-velocity-made-up-from-rates-of-0-2-0-1-and-0-3-rad-s-worked-with-numpy = a velocidade angular composta de taxas de 0,2, −0,1 e 0,3 rad/s, calculada com NumPy
the-angular-velocity-made-up-from-rates-of-2-0-5-and-30-rad-s-of-3-1-3-angles-worked-with-numpy = a velocidade angular composta de taxas de 2, 0,5 e 30 rad/s de ângulos 3-1-3, calculada com NumPy
the-attitude-exceeds-the-numerical-range-check-its-numbers = a atitude excede o alcance numérico: confira seus números
the-components-changed-back-less-those-given = as componentes transformadas de volta, menos as dadas
the-damped-period-from-the-characteristic-roots = o período amortecido a partir das raízes características
the-determinant-of-the-direction-cosine-matrix-is-1-not-1-it-mirrors-a-right-handed-frame-into-a-left = o determinante da matriz de cossenos diretores é −1, não +1: ela reflete um referencial destro em um canhoto e não é rotação; confira os sinais e a ordem de suas linhas
the-deviation-at-the-start-is-not-above-that-taken-as-settled-write-a-larger-one-at-the-start = o desvio inicial não é maior que o tomado como acomodado: escreva um maior no início
the-direction-cosine-matrix-by-another-formula-of-the-attitude-given = a matriz de cossenos diretores por outra fórmula da atitude dada
the-direction-cosine-matrix-is-off-off-orthonormal-as-rounding-leaves-it-the-nearest-rotation-is-used = a matriz de cossenos diretores difere { $off } de uma ortonormal, como a deixa o arredondamento: usa-se a rotação mais próxima
the-directions-are-all-parallel-and-leave-the-rotation-about-them-open-write-at-least-two-that-are = as direções são todas paralelas e deixam livre a rotação em torno delas: escreva ao menos duas que não o sejam
the-frames-coincide-the-principal-angle-is-0-and-any-axis-is-the-principal-one = os referenciais coincidem: o ângulo principal é 0°, e qualquer eixo é o principal
the-gain-of-any-small-further-rotation-which-is-zero-at-the-best-attitude = o ganho de qualquer pequena rotação adicional, nulo na melhor atitude
the-length-of-the-euler-parameters-at-the-end-less-1 = o comprimento dos parâmetros de Euler no final, menos 1
the-logarithmic-decrement-from-the-characteristic-roots = o decremento logarítmico a partir das raízes características
the-magnitude-of-in-n = o módulo de ω em N
the-principal-angle-is-180-the-rodrigues-parameters-are-infinite-and-the-principal-axis-may-be-taken = o ângulo principal é 180°: os parâmetros de Rodrigues são infinitos, e o eixo principal pode ser tomado em qualquer dos dois sentidos
the-principal-axis-has-no-length-write-any-vector-along-it-such-as-0-0-1 = o eixo principal não tem comprimento: escreva qualquer vetor ao longo dele, como (0; 0; 1)
the-product-of-the-matrices-of-the-rotations-less-bn = o produto das matrizes das rotações, menos [BN]
the-rates-made-up-from-the-angular-velocity-worked-with-numpy = as taxas compostas a partir da velocidade angular, calculadas com NumPy
the-ratio-of-successive-swings-by-integration-over-half-a-damped-period = a razão entre oscilações sucessivas por integração em meio período amortecido
the-rotation-is-too-fast-to-be-integrated-over-this-duration-write-a-shorter-one-or-a-lower-angular = a rotação é rápida demais para ser integrada nesta duração: escreva uma mais curta, ou uma velocidade angular menor
the-rows-of-bn-are-orthonormal = as linhas de [BN] são ortonormais
the-rows-of-the-direction-cosine-matrix-are-not-orthonormal-c-c-is-off-off-the-unit-matrix-more-than = as linhas da matriz de cossenos diretores não são ortonormais: [C][C]ᵀ difere { $off } da matriz identidade, mais que um arredondamento; confira seus elementos
the-settling-time-from-the-characteristic-roots = o tempo de acomodação a partir das raízes características
the-two-directions-are-parallel-and-leave-the-rotation-about-them-open-write-two-that-are-not = as duas direções são paralelas e deixam livre a rotação em torno delas: escreva duas que não o sejam
these-rates-change-the-length-of-the-euler-parameters-rate-instead-of-0-check-them-and-whether-they = estas taxas mudam o comprimento dos parâmetros de Euler, β₀ β̇₀ + ε · ε̇ = { $rate } em vez de 0: confira-as, e se pertencem ao conjunto de β₀ ≥ 0
with-a-pitch-of-90-only-the-difference-of-yaw-and-roll-30-10-is-left = com arfagem de 90° resta só a diferença entre guinada e rolamento, 30° − 10°
cos-2-the-first-number-in-some-books-the-last-in-others = β₀ = cos(Φ/2): o primeiro número em alguns livros, o último em outros.
n-20-s-sin-0-1t-0-01-cos-0-1t-in-b-t-in-seconds-the-course-asks-for-the-length-of-the-vector-part-0 = ω = 20°/s (sen 0,1t; 0,01; cos 0,1t) em B, t em segundos. O curso pede o comprimento da parte vetorial, 0,8201. Os parâmetros dados diferem do comprimento unitário por arredondamento.
n-3-s-sin-0-1t-0-01-cos-0-1t-in-b-the-course-asks-for-the-length-of-the-parameters-1-1997 = ω = 3°/s (sen 0,1t; 0,01; cos 0,1t) em B. O curso pede o comprimento dos parâmetros, 1,1997.
t-90-about-b-from-the-fixed-axes = ω t = 90° em torno de b₃ a partir dos eixos fixos
b-in-n-by-differences-of-the-attitude = ω × b₁ em N por diferenças da atitude
shadow-set-the-long-way-round = Conjunto sombra: o caminho longo
worked-by-singular-values-with-numpy-data-of-the-concept-checks-of-kinematics-describing-the-motions = resolvido por valores singulares com NumPy: dados das questões de Kinematics: Describing the Motions of Spacecraft (H. Schaub)
worked-with-numpy-data-of-the-concept-checks-of-kinematics-describing-the-motions-of-spacecraft-h = resolvido com NumPy: dados das questões de Kinematics: Describing the Motions of Spacecraft (H. Schaub)
worked-with-scipy-data-of-the-concept-checks-of-kinematics-describing-the-motions-of-spacecraft-h = resolvido com SciPy: dados das questões de Kinematics: Describing the Motions of Spacecraft (H. Schaub)
the-turn-of-axis-axis-of-b-from-the-rates-of-the-euler-angles = o giro do eixo { $axis } de B a partir das taxas dos ângulos de Euler
acceleration-of-an-euler-angle-what-is-left-resolved-along-the-axes-of-the-three-rotations = Aceleração de um ângulo de Euler: o que resta, decomposto nos eixos das três rotações
acceleration-of-the-euler-angle = Aceleração do ângulo de Euler
acceleration-of-the-first-angle = Aceleração do primeiro ângulo
acceleration-of-the-second-angle = Aceleração do segundo ângulo
acceleration-of-the-third-angle = Aceleração do terceiro ângulo
accelerations-of-the-euler-angles = Acelerações dos ângulos de Euler
angular-acceleration-in-b = Aceleração angular em B
angular-acceleration-in-n = Aceleração angular em N
angular-acceleration-in-components-in-b-as-given = Aceleração angular em componentes em B, como dada
angular-acceleration-in-components-in-b-bn-times-that-in-n = Aceleração angular em componentes em B: [BN] vezes a de N
angular-acceleration-in-components-in-b-each-acceleration-about-its-axis-and-the-turn-of-the-axes = Aceleração angular em componentes em B: cada aceleração em torno de seu eixo, e o giro dos eixos
angular-acceleration-in-components-in-n-bn-times-that-in-b = Aceleração angular em componentes em N: [BN]ᵀ vezes a de B
angular-acceleration-without-the-part-of-the-turn-of-the-axes = Aceleração angular sem a parte do giro dos eixos
angular-acceleration-components-in-b = Aceleração angular, componentes em B
angular-acceleration-components-in-n = Aceleração angular, componentes em N
angular-velocity-or-rates = Velocidade angular, ou taxas
if-given-the-accelerations-of-the-euler-angles-are-also-calculated-or-it-from-them = Se for dada, calculam-se também as acelerações dos ângulos de Euler, ou ela a partir delas.
part-of-the-angular-acceleration-that-is-due-to-the-turn-of-the-axes-each-is-turned-by-the-rotations = Parte da aceleração angular devida ao giro dos eixos: cada um é girado pelas rotações anteriores a ele
at-gimbal-lock-the-angular-velocity-does-not-tell-the-rates-of-the-euler-angles-choose-another = no bloqueio de cardã, a velocidade angular não determina as taxas dos ângulos de Euler: escolha outra sequência, ou dê a aceleração angular
the-angular-acceleration-by-differences-of-the-angular-velocity = a aceleração angular por diferenças da velocidade angular
the-angular-acceleration-in-b-by-bn-times-that-in-n = a aceleração angular em B, por [BN] vezes a de N
rotations-of-seven-kinds-after-each-other = Rotações de sete tipos, uma após a outra
product-of-seven-rotation-matrices-worked-with-scipy = produto de sete matrizes de rotação, calculado com SciPy
left-handed-matrix = Matriz canhota
the-determinant-of-a-rotation-is-1 = o determinante de uma rotação é +1
matrix-that-is-no-rotation = Matriz que não é rotação
the-rows-of-a-rotation-matrix-have-length-1 = as linhas de uma matriz de rotação têm comprimento 1
quaternion-of-length-two = Quatérnio de comprimento dois
the-parameters-of-a-rotation-have-length-1 = os parâmetros de uma rotação têm comprimento 1
parallel-directions = Direções paralelas
a-rotation-about-the-common-direction-changes-neither = uma rotação em torno da direção comum não muda nenhuma delas
with-this-damping-the-axle-is-overdamped-and-approaches-its-settled-direction-without-oscillation = com este amortecimento o eixo é superamortecido e se aproxima de sua direção de equilíbrio sem oscilar: escreva um coeficiente menor
disc-on-one-clevis-driven-about-its-axle = Disco em uma só articulação com pino, acionado em torno do eixo
f-r-m-r-2-for-100-n-at-the-rim-of-a-disc-of-20-kg-and-1-1-m = α = F R/(m R²/2) para 100 N na borda de um disco de 20 kg e 1,1 m
nothing-but-the-drive-and-the-inertia-couple-act-about-the-axle-110-n-m-over-12-1-kg-m = Só o acionamento e o binário de inércia atuam em torno do eixo: 110 N·m sobre 12,1 kg·m².

# Statements of exercises.
a-thin-homogeneous-disc-of-3-63-kg-and-0-203-m-radius-spins-at-12-rad-s-about-its-axle-z-relative-to = Um disco fino homogêneo de 3,63 kg e 0,203 m de raio gira a 12 rad/s em torno de seu eixo z, em relação ao braço bifurcado que o sustenta. O braço gira a 4 rad/s em torno do eixo fixo y, perpendicular ao eixo do disco. As duas velocidades são constantes. Determine os momentos de inércia do disco em relação ao seu eixo e a um diâmetro e, em eixos que giram com o braço (x = y × z), a quantidade de movimento angular em relação ao centro e o momento que o eixo exerce sobre o disco.
a-slender-homogeneous-rod-of-6-kg-is-welded-at-its-middle-to-a-vertical-shaft-that-turns-at-a = Uma barra delgada homogênea de 6 kg está soldada pelo meio a um eixo vertical que gira a 20 rad/s constantes. Cada metade da barra tem 0,3 m, e a barra forma 30° com a horizontal. Em eixos que giram com o eixo vertical (y para cima ao longo dele, x horizontal no plano do eixo e da barra, do lado em que a barra sobe, z = x × y), determine a quantidade de movimento angular da barra em relação ao seu centro de massa e o momento em torno de z que o eixo exerce sobre ela.
a-thin-disc-of-3-kg-and-150-mm-radius-is-mounted-on-an-axle-og-of-400-mm-which-is-pivoted-at-the = Um disco fino de 3 kg e 150 mm de raio está montado em um eixo OG de 400 mm, articulado no ponto fixo O. O eixo está na direção x, y aponta para cima, e o disco rola sem deslizar sobre um piso horizontal: seu ponto mais baixo, em (0,4; −0,15; 0) m a partir de O, está em repouso por um instante. A rotação do disco em torno do eixo é de 20 rad/s. Determine a velocidade angular do disco, sua quantidade de movimento angular em relação a O e sua energia cinética.
a-solid-homogeneous-box-of-1-kg-with-edges-of-1-m-1-m-and-2-m-along-x-y-and-z-turns-at-1-rad-s-about = Uma caixa maciça homogênea de 1 kg, com arestas de 1 m, 1 m e 2 m segundo x, y e z, gira a 1 rad/s em torno de sua diagonal, a direção (1; 1; 2) pelo seu centro. Determine o módulo da quantidade de movimento angular em relação ao centro de massa e o ângulo entre ela e a diagonal.
a-hollow-box-of-1-kg-is-made-of-six-thin-plates-its-edges-are-as-1-1-2-along-x-y-and-z-its-principal = Uma caixa oca de 1 kg é feita de seis chapas finas; suas arestas estão na proporção 1 : 1 : 2 segundo x, y e z. Seus momentos principais de inércia em relação ao centro de massa são 37/60 kg·m², 37/60 kg·m² e 0,3 kg·m² em torno de x, y e z. Ela gira a 1 rad/s em torno de sua diagonal (1; 1; 2). Determine o módulo da quantidade de movimento angular em relação ao centro de massa e seu ângulo com a diagonal.
a-slender-rod-of-40-32-2-slug-a-weight-of-40-lbf-with-g-32-2-ft-s-is-pinned-at-a-to-a-vertical-axle = Uma barra delgada de 40/32,2 slug (peso de 40 lbf, com g = 32,2 ft/s²) está articulada em A a um eixo vertical que gira a 15 rad/s constantes. Em eixos que giram com ele (y para cima), A é a origem e a outra extremidade B da barra está em (4; √48; 0) ft, de modo que a barra tem 8 ft de comprimento e forma 60° com a horizontal. Um fio horizontal prende B ao eixo. Determine a tração no fio e a reação em A.
the-rotor-of-a-ship-s-turbine-has-a-mass-of-3500-kg-and-a-radius-of-gyration-of-0-45-m-it-turns-at = O rotor da turbina de um navio tem massa de 3500 kg e raio de giração de 0,45 m. Ele gira a 3000 rpm, no sentido horário visto de trás. O navio vira para a esquerda em uma curva de 100 m de raio a 36 km/h. Determine o momento giroscópico.
a-ship-pitches-with-an-amplitude-of-6-and-a-period-of-40-s-in-simple-harmonic-motion-at-the-instant = Um navio arfa com amplitude de 6° e período de 40 s em movimento harmônico simples; no instante da maior velocidade, a proa desce. Seu rotor, de 3500 kg com raio de giração de 0,45 m, gira a 3000 rpm no sentido horário visto de trás, ao longo do navio. Determine o maior momento giroscópico.
a-turbine-rotor-of-8-t-with-a-radius-of-gyration-of-0-6-m-turns-at-1800-rpm-clockwise-seen-from = O rotor de uma turbina, de 8 t com raio de giração de 0,6 m, gira a 1800 rpm, no sentido horário visto de trás, em um navio. O navio vira para a esquerda a 100 km/h em um raio de 75 m. Determine a velocidade angular de precessão e o momento giroscópico.
a-ship-s-turbine-rotor-of-1000-kg-with-a-radius-of-gyration-of-200-mm-turns-at-5000-rpm-counter = O rotor da turbina de um navio, de 1000 kg com raio de giração de 200 mm, gira a 5000 rpm, no sentido anti-horário visto de trás. Seus mancais estão 600 mm atrás e 900 mm à frente do centro de massa. O navio vira para a esquerda em um raio de 400 m a 12,85 m/s. Determine o momento giroscópico e as forças verticais no rotor no mancal traseiro A e no dianteiro B (g = 9,81 m/s²).
a-top-of-0-5-kg-spins-about-a-fixed-point-60-mm-from-its-centre-of-mass-its-moments-of-inertia-about = Um pião de 0,5 kg gira em torno de um ponto fixo, a 60 mm de seu centro de massa. Seus momentos de inércia em relação a esse ponto são 4×10⁻⁴ kg·m² em torno do eixo e 2,2×10⁻³ kg·m² transversal a ele. O eixo está inclinado 35° da vertical, e a rotação própria em relação ao eixo em precessão é de 160 rad/s (g = 9,81 m/s²). Determine a precessão uniforme lenta e a rápida.
a-flat-axisymmetric-body-moves-without-torques-its-moments-of-inertia-are-2-0-kg-m-about-its-axis-and = Um corpo achatado de revolução move-se sem momentos externos. Seus momentos de inércia são 2,0 kg·m² em torno do eixo e 1,2 kg·m² transversal a ele. Sua velocidade angular é de 8 rad/s e forma 25° com o eixo. Determine o ângulo entre o eixo e a quantidade de movimento angular, a precessão e a rotação própria.
a-plate-is-thrown-with-an-angular-velocity-of-1-rev-s-at-45-to-its-axis-the-ratio-of-its-axial-to-its = Um prato é arremessado com velocidade angular de 1 rev/s a 45° de seu eixo. A razão entre o momento de inércia axial e o transversal é 2. Determine o período em que a velocidade angular dá uma volta em torno do eixo do prato e o período da precessão no espaço.
a-slender-homogeneous-rod-of-0-6-m-and-1-kg-is-hinged-at-its-upper-end-on-the-axis-of-a-vertical = Uma barra delgada homogênea de 0,6 m e 1 kg está articulada pela extremidade superior no eixo de uma árvore vertical que gira a 7 rad/s (g = 9,81 m/s²). Determine a velocidade acima da qual a barra se afasta do eixo e seu ângulo com a vertical.
the-chair-of-a-merry-go-round-80-kg-with-its-passenger-hangs-on-a-light-rod-of-5-m-from-a-point-4-m = A cadeira de um carrossel, de 80 kg com o passageiro, pende por uma haste leve de 5 m de um ponto a 4 m do eixo vertical. Considere-a uma partícula (g = 9,81 m/s²). Determine a velocidade angular em que a haste fica a 45° da vertical.
in-an-edge-mill-a-solid-roller-of-350-kg-and-0-45-m-radius-runs-on-a-horizontal-pan-at-the-end-of-an = Em um moinho de galgas, um rolo maciço de 350 kg e 0,45 m de raio corre sobre uma base horizontal na extremidade de um braço de 0,8 m; a árvore vertical gira a 2,5 rad/s, e o rolo não desliza (g = 9,81 m/s²). Determine o momento giroscópico e a força com que o rolo comprime a base.
a-thin-hoop-of-0-25-m-radius-rolls-without-slipping-its-plane-makes-a-constant-angle-of-62-with-the = Um aro fino de 0,25 m de raio rola sem deslizar; seu plano forma um ângulo constante de 62° com o piso, e seu centro descreve um círculo de 0,9 m de raio. O coeficiente de atrito com o piso é 0,3 (g = 9,81 m/s²). Determine a precessão, a velocidade do centro e o coeficiente de atrito que o movimento exige.
a-solid-cone-of-3-kg-0-4-m-high-with-a-half-angle-of-25-at-its-apex-rolls-without-slipping-on-a = Um cone maciço de 3 kg, com 0,4 m de altura e semiângulo de 25° no vértice, rola sem deslizar sobre um plano horizontal em torno do vértice. Seu eixo gira em torno da vertical a 2,2 rad/s. Determine o comprimento da geratriz, a velocidade angular do cone e sua energia cinética.
the-rotor-of-an-aircraft-s-turn-indicator-is-a-thin-disc-of-200-g-and-40-mm-radius-that-turns-at = O rotor do indicador de curva de um avião é um disco fino de 200 g e 40 mm de raio que gira a 10000 rpm em um garfo. Duas molas de 500 N/m cada uma, distantes 100 mm, seguram o garfo. O avião faz uma curva nivelada de 600 m de raio a 800 km/h. Determine o ângulo de que o garfo gira.
a-motorcycle-with-its-rider-has-a-mass-of-250-kg-and-its-centre-of-mass-is-0-6-m-high-when-it-is = Uma motocicleta com o piloto tem massa de 250 kg, e seu centro de massa está a 0,6 m de altura quando ela está vertical. As rodas têm raio de 300 mm e 1 kg·m² cada uma. As partes girantes do motor têm 0,3 kg·m² e giram 5 vezes mais rápido que as rodas, no mesmo sentido. O centro de massa percorre uma curva de 50 m de raio a 90 km/h (g = 9,81 m/s²). Determine o ângulo de inclinação em relação à vertical.
a-trolley-car-of-2500-kg-has-its-centre-of-mass-0-9-m-above-the-rails-which-are-1-5-m-apart-its-two = Um bonde de 2500 kg tem o centro de massa a 0,9 m acima dos trilhos, que distam 1,5 m. Seus dois eixos iguais têm rodas de 0,375 m de raio, e cada par de rodas tem 18 kg·m². Os motores têm 2·12 kg·m² no total e giram 5 vezes mais rápido que as rodas, no sentido oposto. O bonde percorre uma curva à esquerda de 30 m de raio a 24 km/h (g = 9,81 m/s²). Determine o momento de tombamento e as cargas em uma roda externa e em uma interna.
a-pair-of-locomotive-wheels-has-a-moment-of-inertia-of-180-kg-m-about-its-axle-a-diameter-of-1-8-m = Um par de rodas de locomotiva tem momento de inércia de 180 kg·m² em relação ao eixo, diâmetro de 1,8 m e distância de 1,5 m entre as rodas. A 95 km/h, a roda esquerda passa por uma depressão do trilho: ela desce 6 mm e volta em movimento harmônico simples em 0,1 s. Determine o maior momento giroscópico e a maior variação da força entre roda e trilho, dada pelo momento sobre a distância entre as rodas.
a-sphere-of-2-kg-hits-the-lower-end-of-a-hanging-rod-horizontally-at-5-m-s-the-rod-is-slender-8-kg = Uma esfera de 2 kg atinge horizontalmente, a 5 m/s, a extremidade inferior de uma barra pendurada. A barra é delgada, de 8 kg e 1,2 m, articulada na extremidade superior e em repouso; o impacto ocorre a 1,2 m da articulação, com coeficiente de restituição 0,8. Determine a velocidade angular da barra e a velocidade da esfera (positiva em sua direção inicial) logo depois do impacto.
a-ball-a-of-20-kg-moves-at-5-m-s-and-meets-a-ball-b-of-10-kg-that-comes-from-the-opposite-direction = Uma bola A de 20 kg move-se a 5 m/s e encontra uma bola B de 10 kg que vem na direção oposta a 10 m/s. O impacto é direto e central, com coeficiente de restituição 5/6. Determine as velocidades de A e B depois dele, positivas na direção inicial de A.
a-solid-homogeneous-cone-of-15-kg-has-a-base-of-0-5-m-radius-and-a-height-of-1-5-m-its-apex-is-at-the = Um cone maciço homogêneo de 15 kg tem base de 0,5 m de raio e altura de 1,5 m. Seu vértice está na origem e seu eixo é z. Determine seu momento de inércia em relação a uma geratriz, a reta pelo vértice na direção (0,5; 0; 1,5).
a-homogeneous-thin-disc-of-6-kg-and-160-mm-radius-spins-at-16-rad-s-relative-to-an-arm-which-turns = Um disco fino homogêneo de 6 kg e 160 mm de raio gira a 16 rad/s em relação a um braço, que gira com sua árvore a 8 rad/s em torno de um eixo perpendicular ao do disco. O centro do disco está a √2·180 mm do eixo da árvore. Determine a velocidade do centro e a energia cinética do disco.
a-slender-rod-of-2-kg-and-1-2-m-rests-on-a-smooth-horizontal-plane-along-x-with-its-centre-at-the = Uma barra delgada de 2 kg e 1,2 m repousa em um plano horizontal liso ao longo de x, com o centro na origem. Ela recebe um impulso de (0; 3; 0) N·s na extremidade, em (0,6; 0; 0) m. Determine a velocidade do centro, a velocidade angular e a energia cinética depois do golpe.
the-rotor-of-a-gyrocompass-is-a-thin-disc-of-1-kg-and-100-mm-radius-that-turns-at-6000-rpm-its-axle = O rotor de uma bússola giroscópica é um disco fino de 1 kg e 100 mm de raio que gira a 6000 rpm. Seu eixo é mantido na horizontal, e o momento de inércia em relação à vertical é de 0,0025 kg·m². Determine o período das pequenas oscilações do eixo em torno do meridiano na latitude de 30°.
the-axes-of-the-three-rates-taken-as-perpendicular = eixos das três taxas tomados como perpendiculares
the-rates-of-the-angles-added-as-numbers = somadas as taxas dos ângulos como números
the-component-of-along-the-body-axis-of-that-rotation-taken = tomada a componente de ω segundo o eixo do corpo dessa rotação
projected-orthogonally-onto-the-axis-of-the-rotation = ω projetada ortogonalmente sobre o eixo da rotação
the-angular-acceleration-projected-orthogonally-onto-the-axis-of-the-rotation = aceleração angular projetada ortogonalmente sobre o eixo da rotação
the-angular-speeds-of-the-joints-added-as-numbers = somadas as velocidades angulares das juntas como números
the-axes-of-the-joints-taken-as-perpendicular = eixos das juntas tomados como perpendiculares
the-angular-velocity-relative-to-the-preceding-frame-taken = tomada a velocidade angular relativa ao referencial anterior
the-angular-accelerations-of-the-joints-added-the-rotation-of-their-axes-neglected = somadas as acelerações angulares das juntas, desprezada a rotação dos seus eixos
kinetic-energy-of-translation-added-to-that-of-the-rotation-about-the-fixed-point = energia cinética de translação somada à da rotação em torno do ponto fixo
the-distance-of-the-centre-of-mass-from-the-fixed-point-taken-as-its-height = distância do centro de massa ao ponto fixo tomada como a sua altura
the-rod-treated-as-a-simple-pendulum-with-its-mass-at-the-free-end = haste tratada como pêndulo simples com a massa na extremidade livre
whole-tension-of-the-rod-taken-as-the-force-upwards = tomada como força para cima toda a tração na haste
moment-of-inertia-of-the-rod-taken-about-its-midpoint = momento de inércia da haste tomado em relação ao seu ponto médio
centrifugal-force-of-the-whole-body-applied-at-g = força centrífuga de todo o corpo aplicada em G
radius-of-gyration-treated-as-one-about-g-the-parallel-axis-term-added = raio de giração tratado como se fosse em relação a G, somado o termo de Steiner
the-rod-treated-as-a-conical-pendulum-with-its-mass-at-the-free-end = haste tratada como pêndulo cônico com a massa na extremidade livre
pin-assumed-on-the-axis-of-the-shaft = pino suposto no eixo de rotação
frequency-of-the-pendulum-on-a-shaft-at-rest-used = usada a frequência do pêndulo com o eixo parado
moment-of-inertia-of-the-swinging-body-taken-about-g = momento de inércia do corpo que oscila tomado em relação a G
moment-of-inertia-of-the-roller-taken-about-the-point-of-contact = momento de inércia do rolo tomado em relação ao ponto de contato
roller-assumed-to-spin-at-the-speed-of-the-shaft = suposto que o rolo gira com a velocidade do eixo
resultant-angular-velocity-of-the-roller-used-as-its-spin = usada como rotação própria a velocidade angular resultante do rolo
straight-line-distance-from-the-hinge-to-the-point-of-contact-taken-as-the-lever-arm = distância em linha reta da articulação ao ponto de contato tomada como braço de alavanca
spin-of-the-roller-used-in-place-of-the-speed-of-the-shaft-in-the-centripetal-force = usada na força centrípeta a rotação própria do rolo em lugar da velocidade do eixo
spin-of-the-roller-used-in-place-of-the-speed-of-the-shaft = usada a rotação própria do rolo em lugar da velocidade do eixo
whole-speed-of-the-edge-about-the-shaft-taken-that-of-rolling-not-subtracted = tomada toda a velocidade da borda em torno do eixo, sem subtrair a do rolamento
dynamic-part-alone-taken-without-weight-and-loads = tomada só a parcela dinâmica, sem o peso e os carregamentos
static-part-alone-taken-without-inertia-force-and-couple = tomada só a parcela estática, sem a força e o binário de inércia
inertia-couple-omitted-the-inertia-force-at-g-alone-considered = binário de inércia omitido: considerada só a força de inércia em G
inertia-force-and-couple-applied-in-the-sense-of-the-acceleration = força e binário de inércia aplicados no sentido da aceleração
half-of-the-length-inserted-as-the-length-of-the-rod-in-ml-12 = metade do comprimento usada como comprimento da haste em mL²/12
moment-of-inertia-of-the-rod-taken-about-one-end-ml-3 = momento de inércia da haste tomado em relação a uma extremidade, mL²/3
centrifugal-force-of-each-half-applied-at-its-own-midpoint = força centrífuga de cada metade aplicada no ponto médio dela
mass-of-the-rod-taken-as-two-particles-at-its-ends = massa da haste tomada como duas partículas nas extremidades
i-used-with-the-moment-of-inertia-of-the-rod-about-a-transverse-axis = usada ½Iω² com o momento de inércia da haste em relação a um eixo transversal
euler-s-equations-for-axes-fixed-in-the-disc-used-with-the-rates-of-omitted = usadas as equações de Euler em eixos fixos ao disco com as derivadas de ω omitidas
magnitude-of-the-resultant-angular-velocity-used-as-the-spin = usado como rotação própria o módulo da velocidade angular resultante
rotation-of-the-axes-counted-twice-i-d-added-to-h = rotação dos eixos contada duas vezes: I_d α somado a Ω × H
energy-of-the-spin-alone-taken = tomada só a energia da rotação própria
i-z-used-with-the-resultant-angular-velocity = usada ½I_z ω² com a velocidade angular resultante
resultant-angular-velocity-of-the-disc-used-for-the-motion-of-its-centre = usada a velocidade angular resultante do disco para o movimento do seu centro
rotor-treated-as-a-solid-disc-of-the-same-diameter = rotor tratado como disco maciço de mesmo diâmetro
mass-of-the-blades-taken-at-their-tips = massa das pás tomada nas suas pontas
moment-of-inertia-about-the-spin-axis-used-in-the-pulsating-part = usado na parcela pulsante o momento de inércia em relação ao eixo de rotação
mean-couple-added-to-the-component-about-the-precession-axis = binário médio somado à componente em torno do eixo de precessão
mean-and-pulsating-part-combined-as-components-at-right-angles = parcelas média e pulsante combinadas como componentes perpendiculares
whole-depth-of-the-dip-taken-as-the-amplitude = profundidade inteira do desnível tomada como amplitude
average-speed-of-the-descent-used-in-place-of-the-maximum = usada a velocidade média da descida em lugar da máxima
axle-assumed-to-tilt-about-its-midpoint-half-of-the-gauge-used = suposto que o eixo se inclina em torno do seu ponto médio, usada metade da bitola
couple-divided-between-the-wheels-half-of-the-force-at-each = binário dividido entre as rodas: metade da força em cada uma
radius-of-the-wheels-taken-as-the-lever-arm-of-the-couple = raio das rodas tomado como braço de alavanca do binário
average-angular-acceleration-over-a-quarter-of-the-dip-used-in-place-of-the-maximum = usada a aceleração angular média em um quarto do desnível em lugar da máxima
gyroscopic-couple-which-acts-about-the-vertical-added-to-the-tilting-couple = momento giroscópico, que atua em torno da vertical, somado ao binário de inclinação
radius-of-the-parallel-used-for-the-motion-to-the-north = usado o raio do paralelo para o movimento para o norte
logarithmic-decrement-of-light-damping-2-used = usado o decremento logarítmico de amortecimento leve, δ = 2πζ
the-formula-for-light-damping-2-used = usada a fórmula de amortecimento leve, ζ = δ/(2π)
swings-on-opposite-sides-taken-as-a-whole-period-apart = oscilações em lados opostos tomadas como separadas por um período inteiro
log-used-in-place-of-the-natural-logarithm = usado log₁₀ em lugar do logaritmo natural
the-rule-for-settling-to-within-2-4-used = usada a regra de acomodação a 2%, 4/(ζω₀)
period-of-nutation-of-a-free-gyroscope-2-i-t-h-s-used = usado o período de nutação de um giroscópio livre, 2πI_t/h_s
couple-of-a-small-deviation-used-sin-replaced-by = usado o binário de um desvio pequeno: sen α₀ substituído por α₀
period-of-small-oscillations-used-at-a-large-deviation = usado o período das pequenas oscilações para um desvio grande
harmonic-motion-of-small-oscillations-assumed-at-a-large-deviation = suposto o movimento harmônico das pequenas oscilações para um desvio grande
axle-assumed-parallel-to-the-axis-of-the-earth = eixo do rotor suposto paralelo ao eixo da Terra
period-of-a-simple-pendulum-of-the-length-l-used = usado o período de um pêndulo simples de comprimento l
period-of-precession-under-the-weight-2-h-s-b-used = usado o período de precessão devida ao peso, 2πh_s/B
couple-taken-as-h-times-without-the-sine-of-the-angle-between-them = binário tomado como H vezes Ω, sem o seno do ângulo entre eles
angular-momentum-due-to-the-rotation-of-the-carrier-omitted = omitido o momento angular devido à rotação do suporte
transverse-moment-of-inertia-used-for-the-angular-momentum-of-the-spin = usado o momento de inércia transversal no momento angular da rotação própria
average-angular-acceleration-over-a-quarter-of-a-period-used-in-place-of-the-maximum = usada a aceleração angular média em um quarto de período em lugar da máxima
transverse-force-divided-equally-between-the-bearings = força transversal dividida igualmente entre os mancais
gyroscopic-couple-divided-by-the-distance-of-the-bearing-from-g = momento giroscópico dividido pela distância do mancal a G
average-angular-velocity-over-a-quarter-of-a-period-used-in-place-of-the-maximum = usada a velocidade angular média em um quarto de período em lugar da máxima
moment-of-inertia-of-the-spin-transferred-to-the-support-by-the-parallel-axis-theorem = momento de inércia da rotação própria transferido para o apoio pelo teorema dos eixos paralelos
couples-assumed-constant-not-reduced-by-cos-sin-c-k = binários supostos constantes, não reduzidos por cos θ: sen θ = C/K
small-inclination-assumed-tan-replaced-by = suposta inclinação pequena: tan θ substituída por θ
mass-of-the-wheel-added-to-that-of-the-frame = massa do volante somada à do quadro
gyroscopic-couple-set-equal-to-the-moment-of-the-weight = momento giroscópico igualado ao momento do peso
whole-distance-between-the-springs-taken-as-the-lever-arm-of-each = distância inteira entre as molas tomada como braço de alavanca de cada uma
the-two-springs-taken-in-series = as duas molas tomadas em série
lever-arm-of-the-springs-not-reduced-by-cos = braço de alavanca das molas não reduzido por cos θ
gyroscopic-couple-not-reduced-by-cos = momento giroscópico não reduzido por cos θ
small-angle-of-the-yoke-assumed-sin-replaced-by = suposto ângulo pequeno do garfo: sen θ substituído por θ
gear-ratio-squared-as-for-the-moment-of-inertia-referred-by-kinetic-energy = relação de transmissão ao quadrado, como no momento de inércia reduzido pela energia cinética
tangent-of-the-lean-angle-taken-as-the-friction-required = tangente do ângulo de inclinação tomada como coeficiente de atrito necessário
radius-of-the-wheel-path-used-for-the-centre-of-mass = usado para o centro de massa o raio da trajetória das rodas
gyroscopic-couple-of-the-upright-vehicle-used-not-reduced-by-cos = usado o momento giroscópico do veículo em pé, não reduzido por cos θ
small-lean-assumed-tan-replaced-by = suposta pequena a inclinação do veículo: tan θ substituída por θ
vertical-equilibrium-written-with-the-wheel-loads-alone-the-side-force-omitted = equilíbrio vertical escrito só com as cargas das rodas, omitida a força lateral
whole-centripetal-force-taken-as-the-side-force-as-on-a-level-road = força centrípeta inteira tomada como força lateral, como em pista plana
half-of-the-track-taken-as-the-arm-of-the-couple-of-the-loads = metade da bitola tomada como braço do binário das cargas
couple-of-the-longitudinal-engine-about-another-axis-added-to-the-tilting-couple = binário do motor longitudinal, em torno de outro eixo, somado ao de tombamento
weight-divided-equally-between-the-axles = peso dividido igualmente entre os eixos
load-transfer-divided-between-the-inner-and-the-outer-wheel = transferência de carga dividida entre a roda interna e a externa
tangent-of-the-bank-simply-added-to-the-friction-coefficient = tangente da superelevação simplesmente somada ao coeficiente de atrito
vehicle-assumed-to-overturn-as-a-whole-without-regard-to-the-load-of-each-axle = suposto que o veículo tomba como um todo, sem considerar a carga de cada eixo
moment-of-inertia-of-the-disc-taken-about-a-parallel-axis-through-the-point-of-contact = momento de inércia do disco tomado em relação a um eixo paralelo pelo ponto de contato
moment-of-inertia-of-the-disc-about-its-axis-taken-for-that-about-a-diameter = momento de inércia do disco em relação ao seu eixo tomado como o de um diâmetro
moment-of-inertia-of-the-hoop-taken-about-a-parallel-axis-through-the-point-of-contact = momento de inércia do aro tomado em relação a um eixo paralelo pelo ponto de contato
moment-of-inertia-of-a-solid-disc-used-for-the-hoop = usado para o aro o momento de inércia de um disco maciço
h-g-divided-by-the-moment-of-inertia-about-the-axis = H_G dividido pelo momento de inércia em relação ao eixo
the-whole-precession-subtracted-from-a = subtraída de ω_a a precessão inteira
the-difference-of-the-moments-of-inertia-divided-by-i-a = diferença dos momentos de inércia dividida por I_a
precession-and-spin-combined-as-if-they-were-at-right-angles = precessão e rotação própria compostas como se fossem perpendiculares
the-axial-moment-of-inertia-times-the-whole-angular-velocity = momento de inércia axial multiplicado pela velocidade angular inteira
the-spin-and-the-precession-used-as-the-two-components-of = rotação própria e precessão usadas como as duas componentes de ω
the-differences-of-the-moments-divided-by-the-intermediate-one = diferenças dos momentos divididas pelo momento intermediário
the-formula-for-a-rotation-about-the-axis-of-an-extreme-moment-used = usada a fórmula da rotação em torno do eixo de um momento extremo
a-harmonic-motion-assumed-with-the-period-2-p = suposto um movimento harmônico, de período 2π/p
a-quarter-of-the-period-taken-as-the-time-to-the-first-flip = tomado um quarto do período como o tempo até a primeira inversão
the-radius-of-gyration-used-as-the-radius-of-a-disc-m-k = raio de giração usado como raio de um disco, ½ m k²
the-moment-of-inertia-taken-about-an-edge-of-the-body = momento de inércia tomado em relação a uma aresta do corpo
the-formula-for-fast-tops-used = usada a fórmula dos piões rápidos
the-spin-taken-as-the-whole-angular-velocity-about-the-axis = rotação própria tomada como toda a velocidade angular em torno do eixo
the-frequency-of-a-fast-top-i-a-i-t-used = usada a frequência de um pião rápido, I_a ω₃/I_t
the-weight-neglected-in-the-fast-precession = desprezado o peso na precessão rápida
the-kinetic-energy-of-the-rotation-about-the-axis-included = incluída a energia cinética da rotação em torno do eixo
the-nutation-taken-as-that-of-a-fast-top = nutação tomada como a de um pião rápido
the-formula-for-fast-tops-2-i-t-i-a-used = usada a fórmula dos piões rápidos, 2π I_t/(I_a ω₃)
a-harmonic-motion-assumed-with-the-period-p = suposto um movimento harmônico, de período π/p
the-steady-precession-of-a-fast-top-m-g-l-i-a-used = usada a precessão estacionária de um pião rápido, m g l/(I_a ω₃)
the-struck-body-taken-as-a-fixed-wall = corpo atingido tomado como uma parede fixa
body-a-taken-to-stop-at-the-impact = suposto que o corpo A para no choque
a-perfectly-elastic-impact-assumed = suposto um choque perfeitamente elástico
the-component-of-a-across-the-line-of-impact-taken-as-unchanged = componente de A transversal à linha de impacto tomada como inalterada
n-1-e-of-the-whole-kinetic-energy-taken = tomado 1 − e² da energia cinética total
the-mass-of-a-used-in-place-of-the-reduced-mass = usada a massa de A no lugar da massa reduzida
the-component-across-the-line-of-impact-multiplied-by-e-as-well = multiplicada por e também a componente transversal à linha de impacto
the-moment-of-inertia-of-the-rod-about-its-centre-used = usado o momento de inércia da haste em relação ao seu centro
the-mass-of-the-rod-taken-at-its-centre = massa da haste tomada no seu centro
m-h-added-as-if-the-radius-of-gyration-were-about-g = somado M h², como se o raio de giração fosse em relação a G
the-mass-of-the-hinged-body-used-as-if-it-were-free = usada a massa do corpo articulado, como se ele estivesse livre
the-velocity-of-the-struck-point-divided-by-the-distance-of-g = velocidade do ponto atingido dividida pela distância de G
the-radius-of-gyration-about-the-hinge-taken = tomado o raio de giração em relação à articulação
v-g-2-g-used-as-the-rise-of-g-the-energy-of-the-rotation-omitted = usado v_G²/(2 g) como a subida de G, omitida a energia da rotação
the-whole-angular-momentum-about-the-point-taken = tomado todo o momento angular em relação ao ponto
h-divided-by-the-moment-of-inertia-about-the-axis = H dividido pelo momento de inércia em relação ao eixo
the-inertia-of-the-projectiles-neglected = desprezada a inércia dos projéteis
the-inertia-taken-about-the-centre-of-mass-of-the-body-alone = inércia tomada em relação ao centro de massa do corpo sem os projéteis
the-products-of-inertia-ignored = ignorados os produtos de inércia
the-products-of-inertia-taken-with-the-opposite-sign = produtos de inércia tomados com o sinal oposto
the-direction-cosines-not-squared = cossenos diretores não elevados ao quadrado
the-distance-of-g-from-the-given-point-of-the-line-used = usada a distância de G ao ponto dado da reta
the-magnitudes-of-the-two-parts-added-as-numbers = módulos das duas parcelas somados como números
m-v-g-added-to-the-energy-of-the-rotation-about-the-fixed-point = ½ m v_G² somado à energia da rotação em torno do ponto fixo
the-final-rotation-taken-about-the-axis-of-the-smallest-moment = rotação final tomada em torno do eixo do menor momento
the-mean-of-the-angular-velocities-taken = tomada a média das velocidades angulares
the-relative-angular-velocity-taken-as-absolute = velocidade angular relativa tomada como absoluta
the-whole-mass-of-the-disc-taken-at-its-rim = toda a massa do disco tomada na sua borda
the-whole-angular-momentum-reversed = invertido todo o momento angular
the-factor-of-rolling-down-an-incline-1-1-used = usado o fator da descida de um plano inclinado, 1/(1 + κ)
the-ball-taken-to-rest-on-the-turntable-at-its-initial-radius = bola suposta em repouso sobre a mesa, no raio inicial
m-v-g-added-although-the-moments-are-about-the-apex = somado ½ m v_G², embora os momentos sejam em relação ao vértice
i-a-taken-as-if-lay-along-the-axis-of-the-cone = tomado ½ I_a ω², como se ω estivesse ao longo do eixo do cone
the-angular-velocity-of-the-cone-used-in-place-of-its-precession = usada a velocidade angular do cone no lugar da sua precessão
the-centroid-of-a-triangle-used-for-the-cone = usado o centroide de um triângulo para o cone
the-centre-of-mass-measured-from-the-base = centro de massa medido a partir da base
the-moment-of-inertia-of-a-cylinder-about-its-axis-used-for-the-cone = usado para o cone o momento de inércia de um cilindro em relação ao seu eixo
the-transverse-moment-of-inertia-taken-about-the-centre-of-mass = momento de inércia transversal tomado em relação ao centro de massa
the-centre-of-mass-of-a-solid-cone-used-for-the-shell = usado para a casca o centro de massa de um cone maciço
the-moment-of-inertia-of-a-solid-cone-used-for-the-shell = usado para a casca o momento de inércia de um cone maciço
the-spin-used-in-place-of-the-angular-velocity-about-the-axis = usada a rotação própria no lugar da velocidade angular em torno do eixo
the-condition-v-g-r-of-a-circular-path-used = usada a condição v² = g r de uma trajetória circular
the-condition-of-a-sleeping-top-used = usada a condição de um pião dormente
the-moment-of-the-friction-about-the-centre-of-mass-omitted = omitido o momento do atrito em relação ao centro de massa
the-circle-on-the-floor-used-in-place-of-that-of-the-centre = usada a circunferência no piso no lugar da do centro
the-transposed-matrix-nb-used = usada a matriz transposta, [NB]
the-three-euler-angles-combined-as-the-components-of-a-vector = três ângulos de Euler compostos como componentes de um vetor
the-cosine-of-the-whole-principal-angle-used = usado o cosseno do ângulo principal inteiro
the-moment-of-inertia-about-a-transverse-axis-used-for-the-axis-of-symmetry = usado para o eixo de simetria o momento de inércia em relação a um eixo transversal
the-moment-of-inertia-about-the-axis-of-symmetry-used-for-a-transverse-axis = usado para um eixo transversal o momento de inércia em relação ao eixo de simetria
the-moment-of-inertia-of-the-rod-taken-about-its-end = momento de inércia da haste tomado em relação à sua extremidade
the-moment-of-inertia-of-a-solid-disc-used-for-the-ring = usado para o anel o momento de inércia de um disco maciço
the-factor-of-the-second-moment-of-area-of-a-triangle-1-36-used-with-the-mass = usado com a massa o fator 1/36 do momento de segunda ordem da área de um triângulo
the-transverse-moment-of-inertia-of-the-cone-taken-about-its-apex = momento de inércia transversal do cone tomado em relação ao vértice
the-transverse-moment-of-inertia-of-the-conical-shell-taken-about-its-apex = momento de inércia transversal da casca cônica tomado em relação ao vértice
the-moment-of-inertia-of-a-thin-spherical-shell-used-for-the-solid-sphere = usado para a esfera maciça o momento de inércia de uma casca esférica fina
the-moment-of-inertia-of-a-disc-used-for-the-sphere = usado para a esfera o momento de inércia de um disco
the-moment-of-inertia-of-a-solid-sphere-used-for-the-thin-shell = usado para a casca fina o momento de inércia de uma esfera maciça
half-the-moment-of-inertia-of-a-sphere-of-the-same-mass-used = usada a metade do momento de inércia de uma esfera de mesma massa
the-moment-of-inertia-of-a-cylinder-about-its-axis-used-for-the-paraboloid = usado para o paraboloide o momento de inércia de um cilindro em relação ao seu eixo
the-transverse-moment-of-inertia-of-the-paraboloid-taken-about-its-vertex = momento de inércia transversal do paraboloide tomado em relação ao vértice
the-distance-of-the-points-used-in-place-of-that-of-the-parallel-axes = usada a distância entre os pontos no lugar da distância entre os eixos paralelos
the-parallel-axis-terms-of-all-parts-omitted = omitidos os termos de Steiner de todas as partes
all-parts-taken-as-particles-at-their-centres-of-mass = todas as partes tomadas como partículas nos seus centros de massa
the-distances-of-the-parts-measured-from-the-origin-o = distâncias das partes medidas a partir da origem O
the-phase-in-radians-evaluated-with-the-calculator-in-degrees = fase em radianos calculada com a calculadora em graus
m-l-added-as-if-the-radius-of-gyration-were-about-the-centre-of-mass = somado m l², como se o raio de giração fosse em relação ao centro de massa
the-spin-used-in-place-of-a-in-the-axial-component-of-h-g = usada a rotação própria no lugar de ω_a na componente axial de H_G
i-a-taken-with-the-whole-angular-velocity = tomado ½ I_a ω², com a velocidade angular inteira
taken-as-the-spin-relative-to-the-precessing-frame = ω₃ tomada como a rotação própria relativa ao referencial em precessão
sin-kept-in-the-moment-of-the-weight-alone = sen θ mantido apenas no momento do peso
the-magnitude-of-taken-in-place-of-its-component-along-the-axis = tomado o módulo de ω no lugar da sua componente ao longo do eixo
i-a-multiplied-by-the-spin-alone-without-the-precession = I_a multiplicado só pela rotação própria, sem a precessão
the-mean-of-the-precessions-at-the-two-limits-taken = tomada a média das precessões nos dois limites
the-moment-of-inertia-about-g-used-or-the-distance-measured-from-g = usado o momento de inércia em relação a G, ou a distância medida a partir de G
the-kinetic-energy-of-a-before-the-impact-taken-as-conserved = energia cinética de A antes do choque tomada como conservada
the-ratio-of-the-angular-speeds-inverted = razão das velocidades angulares invertida
the-kinetic-energy-taken-as-conserved-as-the-constraint-takes-hold = energia cinética tomada como conservada quando o vínculo passa a atuar
the-distance-of-the-line-added-to-the-radius-of-gyration-about-its-parallel-through-g = distância da reta somada ao raio de giração em relação à sua paralela por G
the-moment-of-inertia-about-the-axis-of-rotation-multiplied-by-alone = só o momento de inércia em relação ao eixo de rotação multiplicado por ω
h-taken-with-the-magnitudes-the-angle-between-them-ignored = tomado ½ H ω com os módulos, ignorado o ângulo entre eles
the-kinetic-energy-taken-as-conserved-in-place-of-the-angular-momentum = energia cinética tomada como conservada no lugar do momento angular
the-first-body-taken-to-reach-the-initial-speed-of-the-second = suposto que o primeiro corpo chega à velocidade inicial do segundo
the-moments-of-inertia-multiplied-by-alone-without-the-gyroscopic-terms = só os momentos de inércia multiplicados por α, sem os termos giroscópicos
the-angular-velocity-of-the-body-used-in-place-of-that-of-the-moving-frame = usada a velocidade angular do corpo no lugar da do referencial móvel
the-angular-velocity-of-the-turntable-taken-as-that-of-the-path = velocidade angular da mesa tomada como a da trajetória
the-moment-of-m-a-g-alone-taken-without-the-couple-of-the-rotation-about-g = tomado só o momento de m a_G, sem o binário da rotação em torno de G
the-spin-about-the-axis-of-the-cone-taken-as-its-angular-velocity = rotação própria em torno do eixo do cone tomada como a sua velocidade angular
the-moment-of-the-weight-alone-taken-without-the-gyroscopic-terms = tomado só o momento do peso, sem os termos giroscópicos
the-moment-of-inertia-about-the-tangent-at-the-contact-used-not-that-about-a-diameter = usado o momento de inércia em relação à tangente no contato, e não a um diâmetro
the-moment-of-inertia-about-the-axis-of-the-disc-used-not-that-about-a-diameter = usado o momento de inércia em relação ao eixo do disco, e não a um diâmetro
the-disc-taken-as-a-particle-tan-v-g-a = disco tomado como partícula, tan λ = v²/(g a)
the-whole-mass-taken-at-the-mean-radius = toda a massa tomada no raio médio
the-moment-of-inertia-of-the-triangle-taken-about-its-right-angled-corner = momento de inércia do triângulo tomado em relação ao vértice do ângulo reto
the-whole-mass-of-the-cylinder-taken-at-its-outer-surface = toda a massa do cilindro tomada na sua superfície lateral
the-moment-of-inertia-taken-about-a-corner-of-the-plate = momento de inércia tomado em relação a um canto da placa
the-moment-of-inertia-taken-about-a-diameter-of-the-end-of-the-cylinder = momento de inércia tomado em relação a um diâmetro da base do cilindro
the-moment-of-inertia-of-the-disc-taken-about-a-diameter = momento de inércia do disco tomado em relação a um diâmetro
solid-cylinder-that-turns-about-an-oblique-axis = Cilindro maciço que gira em torno de um eixo oblíquo
c-h-i-a-i-t-x-z-with-i-a-m-r-2-and-i-t-m-3-r-h-12 = C = (h + (I_a − I_t) Ω_x) Ω_z com I_a = m r²/2 e I_t = m (3 r² + h²)/12
i-a-0-05-kg-m-and-i-t-0-028-kg-m-c-15-0-022-2-2 = I_a = 0,05 kg·m² e I_t = 0,028 kg·m²: C = (15 + 0,022 · 2) · 2.
