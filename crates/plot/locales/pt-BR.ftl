# Gráficos e desenhos nas células de um terminal, e seus temas.
nothing-to-draw = nada a desenhar
permitted = permitido
forbidden = proibido
negative-values-have-no-logarithm-the-axis-stays-linear = valores negativos não têm logaritmo: o eixo continua linear
zero-and-negative-values-have-no-logarithm-the-axis-stays-linear = zero e valores negativos não têm logaritmo: o eixo continua linear
the-terminal-s-own-colours = as cores do próprio terminal
dark = escuro
light = claro
high-contrast = alto contraste
presenter-for-a-projector = apresentação, para projetor
no-colour = sem cores
