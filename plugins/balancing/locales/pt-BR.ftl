# Balancing
balancing-in-two-planes = Balanceamento em dois planos
the-corrections-in-two-planes-that-leave-a-rigid-rotor-with-neither-a-rotating-force-nor-a-rotating = As correções em dois planos que deixam um rotor rígido sem força nem conjugado girantes.
eccentric-masses = Massas excêntricas
