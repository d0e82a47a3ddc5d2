# Configuração, teclas, temas

# Temas

# O arquivo de configuração
file-ignored-the-other-settings-apply = { $file }: ignorado; as demais configurações valem
not-valid-toml-why = não é TOML válido: { $why }
unknown-setting-name-did-you-mean-near = configuração desconhecida `{ $name }`; seria `{ $near }`?
unknown-setting-name-dalembert-settings-lists-them = configuração desconhecida `{ $name }`; `dalembert settings` lista todas
unknown-table-name-did-you-mean-near = tabela desconhecida `{ $name }`; seria `{ $near }`?
unknown-table-name-dalembert-settings-lists-them = tabela desconhecida `{ $name }`; `dalembert settings` lista todas
unknown-command-name-did-you-mean-near = comando desconhecido `{ $name }`; seria `{ $near }`?
unknown-command-name-dalembert-settings-lists-them = comando desconhecido `{ $name }`; `dalembert settings` lista todos
key-cannot-be-written-did-you-mean-near = `{ $key }` não pode ser `{ $written }`; seria `{ $near }`?
key-cannot-be-written-write-one-of-known = `{ $key }` não pode ser `{ $written }`; escreva um de { $known }
key-is-one-of-known-in-quotes = `{ $key }` é um de { $known }, entre aspas
key-is-true-or-false-without-quotes = `{ $key }` é true ou false, sem aspas
digits-is-an-integer-from-1-to-17 = `digits` é um inteiro de 1 a 17
animation-speed-is-a-number-from-0-paused-to-100 = `animation-speed` é um número de 0 (em pausa) a 100
editor-is-a-command-in-quotes-such-as-nano-or-code-wait = `editor` é um comando entre aspas, como "nano" ou "code --wait"
keys-is-a-table-write-keys-and-below-it-for-example-save-ctrl-s = `keys` é uma tabela: escreva [keys] e, abaixo, por exemplo save = "ctrl-s"
action-is-a-key-in-quotes-or-several-s-ctrl-s = `{ $action }` é uma tecla entre aspas, ou várias: ["s", "ctrl-s"]

# Teclas que não podem ser
key-is-not-a-key-did-you-mean-near = `{ $key }` não é uma tecla; seria `{ $near }`?
key-is-not-a-key-write-a-character-or-ctrl-s-f5-shift-up = `{ $key }` não é uma tecla; escreva um caractere, ou `ctrl-s`, `f5`, `shift-up`
key-shift-is-part-of-a-character-write-upper = `{ $key }`: Shift faz parte do caractere; escreva `{ $upper }`
a-terminal-sends-other-for-key-write-other = um terminal envia `{ $other }` para `{ $key }`: escreva `{ $other }`
action-has-no-effect-in-keys-place = `{ $action }` não tem efeito em [keys.{ $place }]
key-is-reserved-for-action-choose-another-key = `{ $key }` é reservada para `{ $action }`: escolha outra tecla
key-starts-a-number-in-keys-place-choose-another-key = `{ $key }` inicia um número em [keys.{ $place }]: escolha outra tecla
key-is-text-in-keys-place-choose-one-such-as-ctrl-g-or-f5 = `{ $key }` é texto em [keys.{ $place }]: escolha uma como `ctrl-g` ou `f5`
key-already-means-taken-in-keys-place-choose-another-key-or-write-taken-there = `{ $key }` já significa `{ $taken }` em [keys.{ $place }]: escolha outra tecla, ou escreva lá `{ $taken } = []`

# O arquivo com que se começa
settings-of-dalembert-lines-that-start-with-are-comments-remove-the-and-change-the-value = Configuração do dalembert. Linhas que começam com # são comentários: tire o # e mude o valor.
language-known-default-that-of-the-environment = Língua: { $known }; padrão: a do ambiente.
theme-known-terminal-uses-the-palette-of-your-terminal = Tema: { $known }. `terminal` usa a paleta do seu terminal.
ascii-characters-only = Só caracteres ASCII.
mouse-true-or-false-default-true-over-ssh-false-with-the-mouse-in-use-selecting-text-needs-shift = Mouse: true ou false; padrão: true, por ssh false. Com o mouse em uso, selecionar texto exige Shift.
pictures-in-pixels-true-or-false-default-true-where-the-terminal-shows-them-over-ssh-false = Figuras em pixels: true ou false; padrão: true onde o terminal as mostra, por ssh false.
curve-markers-known-default-the-finest-that-the-terminal-supports = Marcadores das curvas: { $known }; padrão: os mais finos que o terminal aceita.
decimal-mark-known-default-that-of-the-language = Sinal decimal: { $known }; padrão: o da língua.
significant-digits-of-results-1-to-17 = Algarismos significativos dos resultados, de 1 a 17.
speed-of-animations-0-5-is-half-speed-at-0-they-stay-paused-until-a-key-plays-them = Velocidade das animações: 0.5 é metade; com 0 ficam em pausa até que uma tecla as reproduza.
command-that-edits-a-problem-default-visual-or-editor = Comando que edita um problema; padrão: $VISUAL ou $EDITOR.
keys-a-character-or-such-as-space-f5-page-up-ctrl-s-alt-x-shift-up-one-several-or-none-in-keys-they = Teclas: um caractere, ou algo como "space", "f5", "page-up", "ctrl-s", "alt-x", "shift-up"; uma, várias ou nenhuma. Em [keys] valem onde quer que a ação exista; numa parte como [keys.plot], só ali. Esc sempre volta um passo e Ctrl-C sempre encerra o programa.

# O problema fora do programa
edit-the-problem-in-editor = editar o problema no $EDITOR
edit-again = editar de novo
discard-the-edits = descartar as edições
keep-the-previous-values = manter os valores anteriores
the-edited-problem-cannot-be-read-faults = O problema editado não pode ser lido. { $faults }
edited-problem-loaded-not-saved-yet = problema editado carregado, ainda não salvo
no-changes = sem alterações
command-failed-set-visual-or-editor-or-editor-in-the-settings = `{ $command }` falhou: defina $VISUAL ou $EDITOR, ou `editor` na configuração
file-reloaded = { $file } relido
file-was-changed-by-another-program-and-reloaded = { $file } foi alterado por outro programa e relido
file-was-changed-by-another-program-and-cannot-be-read-why = { $file } foi alterado por outro programa e não pode ser lido: { $why }
file-no-longer-exists-saving-creates-it-again = { $file } não existe mais; salvar o cria de novo
keep-this-version = manter esta versão

# Cores e mouse
theme = tema
choose-a-theme-set-theme-in-the-settings-to-keep-it = Escolha um tema (defina `theme` na configuração para mantê-lo).
this-terminal-shows-no-colours-or-they-are-switched-off = este terminal não mostra cores, ou elas estão desligadas
mouse-use-it-here-or-leave-it-to-the-terminal = mouse: usar aqui, ou deixá-lo com o terminal
mouse-in-use-select-text-with-shift = mouse em uso: selecione texto com Shift
the-mouse-is-the-terminal-s-own-again = o mouse é do próprio terminal de novo
mouse-left-to-the-terminal = mouse deixado com o terminal

# Teclas que aqui não fazem nada, e o que não está na tela
no-text-to-replace-here = nenhum texto a substituir aqui
no-options-here = nenhuma opção aqui
space-has-no-effect-on-this-field = Espaço não tem efeito neste campo
no-other-plot = nenhum outro gráfico
no-other-drawing = nenhum outro desenho
nothing-to-open-here-key-loads-a-case-in-sources = nada a abrir aqui: { $key } carrega um caso em Fontes
new-warning-warning = nova advertência: { $warning }
