# Configuração, teclas, temas

# Temas
dark = escuro
light = claro
high-contrast = alto contraste
no-colour = sem cores
the-terminal-s-own-colours = as cores do próprio terminal

# O arquivo de configuração
file-this-is-not-taken-the-rest-is = { $file }: isto não é aceito, o resto sim
this-is-no-toml-why = isto não é TOML: { $why }
there-is-no-setting-name-did-you-mean-near = não há a configuração `{ $name }`; seria `{ $near }`?
there-is-no-setting-name-dalembert-settings-lists-them = não há a configuração `{ $name }`; `dalembert settings` lista todas
there-is-no-place-name-did-you-mean-near = não há o lugar `{ $name }`; seria `{ $near }`?
there-is-no-place-name-dalembert-settings-lists-them = não há o lugar `{ $name }`; `dalembert settings` lista todos
there-is-no-action-name-did-you-mean-near = não há a ação `{ $name }`; seria `{ $near }`?
there-is-no-action-name-dalembert-settings-lists-them = não há a ação `{ $name }`; `dalembert settings` lista todas
key-cannot-be-written-did-you-mean-near = `{ $key }` não pode ser `{ $written }`; seria `{ $near }`?
key-cannot-be-written-write-one-of-known = `{ $key }` não pode ser `{ $written }`; escreva um de { $known }
key-is-one-of-known-in-quotes = `{ $key }` é um de { $known }, entre aspas
key-is-true-or-false-without-quotes = `{ $key }` é true ou false, sem aspas
digits-is-a-whole-number-from-1-to-17 = `digits` é um número inteiro de 1 a 17
film-speed-is-a-number-from-0-held-to-100 = `film-speed` é um número de 0 (parado) a 100
editor-is-a-command-in-quotes-such-as-nano-or-code-wait = `editor` é um comando entre aspas, como "nano" ou "code --wait"
keys-is-a-table-write-keys-and-below-it-such-as-save-ctrl-s = `keys` é uma tabela: escreva [keys] e, abaixo, algo como save = "ctrl-s"
action-is-a-key-in-quotes-or-several-s-ctrl-s = `{ $action }` é uma tecla entre aspas, ou várias: ["s", "ctrl-s"]

# Teclas que não podem ser
key-is-no-key-did-you-mean-near = `{ $key }` não é uma tecla; seria `{ $near }`?
key-is-no-key-write-a-character-or-ctrl-s-f5-shift-up = `{ $key }` não é uma tecla; escreva um caractere, ou `ctrl-s`, `f5`, `shift-up`
key-shift-is-part-of-a-character-write-upper = `{ $key }`: Shift faz parte do caractere; escreva `{ $upper }`
a-terminal-sends-other-for-key-write-that = um terminal envia `{ $other }` para `{ $key }`: escreva aquilo
action-does-nothing-in-keys-place = `{ $action }` não faz nada em [keys.{ $place }]
key-always-means-action-take-another-key = `{ $key }` sempre significa `{ $action }`: escolha outra tecla
key-begins-a-number-in-keys-place-take-another-key = `{ $key }` começa um número em [keys.{ $place }]: escolha outra tecla
key-is-text-in-keys-place-take-one-such-as-ctrl-g-or-f5 = `{ $key }` é texto em [keys.{ $place }]: escolha uma como `ctrl-g` ou `f5`
key-means-taken-already-in-keys-place-take-another-key-or-write-taken-there = `{ $key }` já significa `{ $taken }` em [keys.{ $place }]: escolha outra tecla, ou escreva lá `{ $taken } = []`

# O arquivo com que se começa
settings-of-dalembert-a-line-that-begins-with-sets-nothing-take-the-away-and-change-the-value = Configuração do dalembert. Uma linha que começa com # não configura nada: tire o # e mude o valor.
the-language-known-without-this-line-that-of-the-environment = A língua: { $known }; sem esta linha, a do ambiente.
colours-known-terminal-are-those-of-your-terminal-s-own-palette = Cores: { $known }. `terminal` são as da paleta do seu terminal.
nothing-but-ascii-characters = Nada além de caracteres ASCII.
take-the-mouse-true-or-false-without-this-line-true-and-over-ssh-false-selecting-text-with-the-mouse = Usar o mouse: true ou false; sem esta linha true, e por ssh false. Selecionar texto com o mouse passa a pedir Shift.
what-curves-are-drawn-with-known-without-this-line-the-finest-that-the-terminal-shows = Com que se traçam as curvas: { $known }; sem esta linha, o mais fino que o terminal mostra.
the-decimal-mark-known-without-this-line-that-of-the-language = A marca decimal: { $known }; sem esta linha, a da língua.
significant-digits-of-results-1-to-17 = Algarismos significativos dos resultados, de 1 a 17.
how-fast-films-move-0-5-is-half-as-fast-at-0-they-are-held-until-a-key-lets-them-move = A velocidade dos filmes: 0.5 é metade; com 0 ficam parados até que uma tecla os solte.
the-command-that-edits-a-problem-without-this-line-that-of-visual-or-editor = O comando que edita um problema; sem esta linha, o de $VISUAL ou $EDITOR.
keys-a-character-or-such-as-space-f5-page-up-ctrl-s-alt-x-shift-up-one-several-or-none-in-keys-they = Teclas: um caractere, ou algo como "space", "f5", "page-up", "ctrl-s", "alt-x", "shift-up"; uma, várias ou nenhuma. Em [keys] valem onde quer que a ação exista; numa parte como [keys.plot], só ali. Esc sempre volta um passo e Ctrl-C sempre encerra o programa.

# O problema fora do programa
edit-the-problem-in-editor = editar o problema no $EDITOR
edit-it-again = editar de novo
give-up-what-was-edited = desistir do que foi editado
go-on-with-what-was-read-before = continuar com o que foi lido antes
what-was-edited-cannot-be-read-faults = O que foi editado não pode ser lido. { $faults }
what-was-edited-is-here-not-saved-yet = o que foi editado está aqui, ainda não salvo
nothing-was-changed = nada mudou
command-did-not-end-well-set-visual-or-editor-or-editor-in-the-settings = `{ $command }` não terminou bem: defina $VISUAL ou $EDITOR, ou `editor` na configuração
file-is-read-again = { $file } foi lido de novo
file-was-changed-by-another-program-and-is-read-again = { $file } foi alterado por outro programa e lido de novo
file-was-changed-by-another-program-and-cannot-be-read-why = { $file } foi alterado por outro programa e não pode ser lido: { $why }
file-is-not-there-any-more-saving-writes-it-again = { $file } não está mais lá; salvar grava de novo
keep-what-is-here = manter o que está aqui

# Cores e mouse
theme-how-things-are-coloured = tema: como as coisas são coloridas
how-are-things-to-be-coloured-the-settings-can-say-it-for-good = Como colorir as coisas? A configuração pode dizê-lo de vez.
this-terminal-shows-no-colours-or-was-asked-to-show-none = este terminal não mostra cores, ou pediram que não mostrasse
mouse-take-it-or-leave-it-to-the-terminal = mouse: usá-lo, ou deixá-lo com o terminal
the-mouse-is-taken-the-terminal-s-own-selection-needs-shift-now = o mouse está em uso: a seleção do próprio terminal agora pede Shift
the-mouse-is-the-terminal-s-own-again = o mouse é do próprio terminal de novo

# Teclas que aqui não fazem nada, e o que não está na tela
there-is-no-text-here-to-be-typed-over = aqui não há texto para substituir
there-are-no-alternatives-here = aqui não há alternativas
this-is-no-yes-or-no-and-cannot-be-left-out = isto não é um sim ou não, nem pode ser omitido
there-is-no-other-plot = não há outro gráfico
there-is-no-other-drawing = não há outro desenho
there-is-nothing-to-open-here-key-loads-a-case-in-the-sources = não há nada para abrir aqui: { $key } carrega um caso nas fontes
the-results-warn-now-warning = os resultados agora advertem: { $warning }
