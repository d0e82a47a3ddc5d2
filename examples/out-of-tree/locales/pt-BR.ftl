# Português das análises do laboratório.
torsional-pendulum = Pêndulo de torção
torsion = Torção
the-moment-of-inertia-of-a-part-from-the-period-of-its-oscillation-on-a-wire = O momento de inércia de uma peça a partir do período de sua oscilação em um fio.
length-of-the-wire = Comprimento do fio
diameter-of-the-wire = Diâmetro do fio
shear-modulus-of-the-wire = Módulo de elasticidade transversal do fio
period = Período
of-one-oscillation-back-and-forth-time-many-and-divide = De uma oscilação completa: cronometre várias e divida.
polar-second-moment-of-the-wire = Momento polar de inércia da seção do fio
torsional-stiffness-of-the-wire = Rigidez torcional do fio
natural-frequency-as-measured = Frequência natural medida
the-natural-frequency-is-k-t-i = A frequência natural é √(k_t/I)
the-moment-of-inertia-in-one-formula-g-d-t-128-l = o momento de inércia em uma só fórmula, G d⁴ T²/(128 π L)
torsional-stiffness = Rigidez torcional
moment-of-inertia = Momento de inércia
a-part-on-1-2-m-of-steel-wire = Uma peça em 1,2 m de fio de aço
by-hand-j-d-32-1-5708-mm-k-t-g-j-l-i-k-t-t-2 = À mão: J = π d⁴/32 = 1,5708 mm⁴, k_t = G J/L, I = k_t (T/2π)²
