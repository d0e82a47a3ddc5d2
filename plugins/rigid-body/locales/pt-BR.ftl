# Both analyses
angular-momentum-along-the-shaft = Momento angular ao longo do eixo
at-this-angle = neste ângulo
components-of-the-angular-momentum-in-the-fixed-axes = Componentes do momento angular nos eixos fixos
components-of-the-couple-in-the-fixed-axes = Componentes do binário nos eixos fixos
couple = binário
couple-about-z = binário em torno de z
kinetic-energy = Energia cinética
rate-of-change-owed-to-the-turning-of-the-axes-h = Variação devida ao giro dos eixos: Ω × H

# rigid-body/spinning-disc-on-arm
disc-spinning-on-a-turning-arm = Disco que gira em um braço giratório
angular-momentum-of-a-thin-disc-that-spins-on-a-turning-arm-its-rate-of-change-and-the-couple-that = Momento angular de um disco fino que gira em um braço giratório, sua taxa de variação e o binário exercido pelo braço.
mass-of-the-disc = Massa do disco
radius-of-the-disc = Raio do disco
angular-velocity-of-the-arm = Velocidade angular do braço
about-the-y-axis = Em torno do eixo y.
spin-of-the-disc-relative-to-the-arm = Rotação própria do disco em relação ao braço
about-the-z-axis-as-seen-by-someone-who-turns-with-the-arm = Em torno do eixo z, como a vê quem gira com o braço.
angular-acceleration-of-the-arm = Aceleração angular do braço
rate-of-change-of-the-spin = Taxa de variação da rotação própria
angle-of-the-arm = Ângulo do braço
from-the-fixed-axes-to-those-that-turn-with-the-arm-about-y = Dos eixos fixos aos que giram com o braço, em torno de y.
distance-of-the-disc-s-centre-from-the-axis-of-the-arm = Distância do centro do disco ao eixo do braço
for-the-kinetic-energy-of-the-whole-motion-it-does-not-enter-the-angular-momentum-about-a = Para a energia cinética do movimento completo; não entra no momento angular em relação a A.
moment-of-inertia-about-a-diameter-i-i-y = Momento de inércia em relação a um diâmetro: Iₓ = I_y
moment-of-inertia-about-a-diameter = Momento de inércia em relação a um diâmetro
moment-of-inertia-about-the-axis-of-the-disc = Momento de inércia em relação ao eixo do disco
the-axes-xyz-turn-with-the-arm = Os eixos xyz giram com o braço
angular-velocity-of-the-disc-the-turning-of-the-arm-and-the-spin-relative-to-it-add = Velocidade angular do disco: somam-se o giro do braço e a rotação própria em relação a ele
angular-velocity-of-the-disc = Velocidade angular do disco
rates-of-the-components-of-in-the-axes-that-turn-with-the-arm = Taxas de variação das componentes de ω nos eixos que giram com o braço
angular-acceleration-of-the-disc = Aceleração angular do disco
angular-momentum-about-the-centre-x-y-and-z-are-principal-axes-however-far-the-disc-has-spun = Momento angular em relação ao centro: x, y e z são eixos principais, qualquer que seja o giro próprio do disco
rate-of-change-seen-by-someone-who-turns-with-the-arm = Variação vista por quem gira com o braço
couple-that-the-arm-exerts-on-the-disc-m-dh-dt = Binário exercido pelo braço sobre o disco: ΣM = dH/dt
gyroscopic-couple-its-component-along-x-in-closed-form = Binário giroscópico: sua componente em x, em forma fechada
gyroscopic-couple-about-x = Binário giroscópico em torno de x
kinetic-energy-of-rotation-about-the-centre = Energia cinética de rotação em torno do centro
kinetic-energy-of-rotation = Energia cinética de rotação
angular-momentum-about-the-centre-axes-of-the-arm = Momento angular em relação ao centro, eixos do braço
dh-dt-relative-to-the-axes-of-the-arm = (dH/dt) relativa aos eixos do braço
couple-on-the-disc-axes-of-the-arm = Binário sobre o disco, eixos do braço
angular-momentum-about-the-centre-fixed-axes = Momento angular em relação ao centro, eixos fixos
couple-on-the-disc-fixed-axes = Binário sobre o disco, eixos fixos
speed-of-the-centre-on-its-circle-about-the-axis-of-the-arm = Velocidade do centro na sua circunferência em torno do eixo do braço
kinetic-energy-of-the-whole-motion = Energia cinética do movimento completo
speed-of-the-centre = Velocidade do centro
the-couple-from-euler-s-equations-in-axes-fixed-in-the-disc = o binário pelas equações de Euler em eixos fixos ao disco
the-angular-momentum-from-the-inertia-tensor-turned-with-the-disc-r-i-r = o momento angular pelo tensor de inércia girado com o disco: R I Rᵀ ω
the-couple-from-the-difference-quotient-of-r-i-r = o binário pelo quociente de diferenças de R I Rᵀ ω
couple-on-the-disc-in-fixed-axes-over-a-turn-of-the-arm = Binário sobre o disco em eixos fixos, em uma volta do braço
m-x-at-this-angle = M_X neste ângulo
m-z-at-this-angle = M_Z neste ângulo
the-disc-on-its-arm-seen-along-the-x-axis = O disco no braço, visto ao longo do eixo x

# rigid-body/rod-on-shaft
slender-rod-welded-to-a-turning-shaft = Haste delgada soldada a um eixo giratório
angular-momentum-of-an-inclined-rod-that-turns-with-a-shaft-its-rate-of-change-and-the-couple-that = Momento angular de uma haste inclinada que gira com um eixo, sua taxa de variação e o binário exercido pelo eixo.
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
from-the-fixed-axes-to-those-that-turn-with-the-shaft-about-y = Dos eixos fixos aos que giram com o eixo, em torno de y.
moment-of-inertia-across-the-rod-i-y-i-z-along-it-i-0 = Momento de inércia transversal à haste, I_y′ = I_z′; ao longo dela, Iₓ′ = 0
moment-of-inertia-across-the-rod = Momento de inércia transversal à haste
component-of-the-angular-velocity-along-the-rod = Componente da velocidade angular ao longo da haste
component-of-the-angular-velocity-across-the-rod = Componente da velocidade angular transversal à haste
angular-momentum-in-the-axes-of-the-rod-only-y-adds-to-it = Momento angular nos eixos da haste: só ω_y′ contribui
angular-momentum-in-the-axes-that-turn-with-the-shaft = Momento angular nos eixos que giram com o eixo
magnitude-of-the-angular-momentum = Módulo do momento angular
component-of-the-angular-momentum-along-the-shaft = Componente do momento angular ao longo do eixo
the-axes-xyz-turn-with-the-shaft = Os eixos xyz giram com o eixo
rate-of-change-seen-by-someone-who-turns-with-the-shaft = Variação vista por quem gira com o eixo
couple-that-the-shaft-exerts-on-the-rod-m-dh-dt = Binário exercido pelo eixo sobre a haste: ΣM = dH/dt
the-couple-that-tilts-the-shaft-in-closed-form = O binário que inclina o eixo, em forma fechada
kinetic-energy-g-stands-still = Energia cinética: G está em repouso
angular-momentum-about-the-middle-axes-of-the-shaft = Momento angular em relação ao ponto médio, eixos que giram com o eixo
dh-dt-relative-to-the-axes-of-the-shaft = (dH/dt) relativa aos eixos que giram com o eixo
couple-on-the-rod-axes-of-the-shaft = Binário sobre a haste, eixos que giram com o eixo
couple-on-the-rod-about-z = Binário sobre a haste em torno de z
angular-momentum-about-the-middle-fixed-axes = Momento angular em relação ao ponto médio, eixos fixos
couple-on-the-rod-fixed-axes = Binário sobre a haste, eixos fixos
at-this-angle-the-shaft-is-a-principal-axis-of-the-rod-no-couple-is-needed-to-keep-the-rod-there = neste ângulo o eixo de rotação é eixo principal da haste: não é preciso binário para mantê-la na posição
h-and-1-6-m-b-sin-2 = Ω × H e −(1/6) m b² ω² sen 2β
the-component-along-the-shaft-is-the-inertia-about-the-shaft-times = a componente ao longo do eixo é o momento de inércia em relação ao eixo vezes ω
the-angular-momentum-from-the-inertia-tensor-of-the-turned-rod = o momento angular pelo tensor de inércia da haste girada
the-couple-from-the-difference-quotient-of-that-angular-momentum = o binário pelo quociente de diferenças desse momento angular
couple-on-the-rod-against-its-angle = Binário sobre a haste em função do seu ângulo
the-rod-in-the-plane-that-turns-with-the-shaft = A haste no plano que gira com o eixo
