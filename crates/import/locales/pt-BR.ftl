# Tabelas de arquivos de outros programas.

this-is-not-a-text-file-nor-a-format-that-is-read-here = este não é um arquivo de texto nem um formato que se lê aqui
line-line-has-have-columns-column-last-is-asked-for = a linha { $line } tem { $have } colunas; pede-se a coluna { $last }
range-is-not-a-range-of-cells-write-a-c-a-c-or-a2-c40-with-a-sheet-data-a-c = `{ $range }` não é um intervalo de células: escreva `A:C`, `A,C` ou `A2:C40`, com a planilha `Data!A:C`
this-spreadsheet-cannot-be-read-why = esta planilha não pode ser lida: { $why }
there-is-no-sheet-sheet-this-file-has-have = não há a planilha `{ $sheet }`; este arquivo tem { $have }
these-cells-have-no-numbers = estas células não têm números
there-is-nothing-in-these-cells-of-the-sheet-sheet = não há nada nestas células da planilha `{ $sheet }`
the-sheet-sheet-has-cells-from-first-to-last-choose-columns-as-in-sheet-a-c = a planilha `{ $sheet }` tem células de { $first } a { $last }: escolha colunas, como em `#{ $sheet }!A:C`
cell-cell-of-the-sheet-sheet-is-a-date-or-a-time-of-day-write-the-time-in-seconds-as-a-number = a célula { $cell } da planilha `{ $sheet }` é uma data ou uma hora: escreva o tempo em segundos, como número
cell-cell-of-the-sheet-sheet-is-true-or-false-write-a-number = a célula { $cell } da planilha `{ $sheet }` é verdadeiro ou falso: escreva um número
cell-cell-of-the-sheet-sheet-has-an-error-in-place-of-a-number-correct-its-formula = a célula { $cell } da planilha `{ $sheet }` tem um erro em lugar de um número: corrija a fórmula
this-build-reads-no-spreadsheets-build-it-with-features-spreadsheets-or-save-the-sheet-as-csv = esta compilação não lê planilhas: compile com `--features spreadsheets`, ou salve a planilha como CSV
the-rows-have-have-columns-and-the-table-want-name-the-columns-to-take-as-in-columns = as linhas têm { $have } colunas e a tabela { $want }: indique as colunas a usar, como em `#{ $columns }`
line-line-has-numbers-but-begins-as-no-other-row-leave-it-out-with-the-lines-above-it-as-in-columns = a linha { $line } tem números, mas não começa como as outras: omita-a com as linhas acima dela, como em `#{ $columns },skip={ $line }`
skip-skip-leaves-nothing-the-file-has-have-lines = `skip={ $skip }` não deixa nada: o arquivo tem { $have } linhas
the-rows-have-twice-as-many-commas-as-the-heading-in-line-line-set-columns-apart-by-semicolons-where = as linhas têm o dobro das vírgulas do cabeçalho na linha { $line }: separe as colunas por ponto e vírgula onde a vírgula é o sinal decimal
the-heading-in-line-line-has-have-words-above-want-columns-set-its-names-apart-by-semicolons-or-tabs = o cabeçalho na linha { $line } tem { $have } palavras sobre { $want } colunas: separe os nomes por ponto e vírgula ou tabulação como as linhas, ou omita-o, como em `#{ $columns },skip={ $line }`
line-line-the-comma-of-cell-may-set-thousands-apart-save-the-file-without-commas-between-thousands = linha { $line }: a vírgula de { $cell } pode separar milhares: salve o arquivo sem vírgulas entre os milhares
line-line-the-point-of-cell-may-set-thousands-apart-since-other-numbers-have-a-decimal-comma-save-the = linha { $line }: o ponto de { $cell } pode separar milhares, pois outros números têm vírgula decimal: salve o arquivo sem pontos entre os milhares
line-line-names-a-unit-above-the-heading-but-not-of-which-column-write-it-into-the-heading-as-in-x-mm = a linha { $line } indica uma unidade acima do cabeçalho, mas não de qual coluna: escreva-a no cabeçalho, como em `x [mm]`, ou omita as linhas, como em `#skip={ $line }`
skip-lines-is-not-a-number-of-lines-write-one-as-in-skip-12-or-1-3-skip-12 = `skip={ $lines }` não é um número de linhas: escreva um, como em `#skip=12` ou `#1,3,skip=12`
skip-counts-the-lines-of-text-and-the-rows-of-spreadsheets-this-file-has-none-leave-it-out = `skip=` conta as linhas de texto e de planilhas; este arquivo não as tem: omita-o
first-has-have-values-and-other-others-choose-some-of-the-same-length = `{ $first }` tem { $have } valores e `{ $other }` { $others }: escolha alguns do mesmo comprimento
value-row-of-column-is-missing-or-infinite-leave-such-rows-out-of-the-file = o valor { $row } de `{ $column }` falta ou é infinito: omita tais linhas do arquivo
this-recording-has-have-samples-at-most-most-are-read-cut-out-the-decay = esta gravação tem { $have } amostras; leem-se no máximo { $most }: recorte o decaimento
this-recording-has-have-channels-choose-one-as-in-1 = esta gravação tem { $have } canais: escolha um, como em `#1`
there-is-no-channel-channel-this-recording-has-have = não há o canal { $channel }: esta gravação tem { $have }
this-wav-file-cannot-be-read-why-save-it-as-pcm-of-16-24-or-32-bits-or-as-32-bit-floating-point = este arquivo WAV não pode ser lido ({ $why }): salve-o como PCM de 16, 24 ou 32 bits, ou como números de ponto flutuante de 32 bits
have-columns-are-chosen-and-the-table-takes-want-name-vectors-or-columns-as-in-t-x-or-signal-1-3-the = escolheram-se { $have } colunas e a tabela tem { $want }: indique vetores ou colunas, como em `#t,x` ou `#signal!1,3`; o arquivo tem { $variables }
name-the-variables-of-this-file-to-take-as-in-signal-or-t-x-it-has-variables = indique as variáveis deste arquivo a usar, como em `#signal` ou `#t,x`: ele tem { $variables }
there-is-no-variable-name-this-file-has-variables = não há a variável `{ $name }`; este arquivo tem { $variables }
name-is-what-save-it-as-a-matrix-of-real-numbers = `{ $name }` é { $what }: salve-a como matriz de números reais
complex = complexa
an-array-of-more-than-two-dimensions = um arranjo de mais de duas dimensões
a-cell-array = um arranjo de células
an-array-of-structures = um arranjo de estruturas
sparse = esparsa
an-object = um objeto
name-has-have-columns-column-last-is-asked-for = `{ $name }` tem { $have } colunas; pede-se a coluna { $last }
this-mat-file-is-damaged-or-cut-off-save-it-again = este arquivo MAT está danificado ou cortado: salve-o de novo
a-variable-of-this-mat-file-has-more-than-most-bytes-save-a-part-of-it = uma variável deste arquivo MAT tem mais de { $most } bytes: salve uma parte dela
there-is-no-column-name-this-file-has-columns = não há a coluna `{ $name }`; este arquivo tem { $columns }
this-file-has-have-columns-of-numbers-and-the-table-want-name-the-columns-to-take-as-in-1-2-it-has = este arquivo tem { $have } colunas de números e a tabela { $want }: indique as colunas a usar, como em `#1,2`; ele tem { $columns }
this-labview-file-has-not-one-set-of-rows-save-one-set-of-measurements-a-file-or-choose-lines-by-skip = este arquivo do LabVIEW não tem um só conjunto de linhas: salve um conjunto de medições por arquivo, ou escolha linhas por `#skip=`
this-labview-file-does-not-give-its-channels-leave-its-header-out-by-skip = este arquivo do LabVIEW não indica seus canais: omita o cabeçalho por `#skip=`
this-labview-file-has-neither-times-nor-delta-x-save-it-with-one-x-column = este arquivo do LabVIEW não tem tempos nem Delta_X: salve-o com uma coluna X
this-is-an-hdf5-file-also-what-matlab-writes-as-version-7-3-save-it-by-save-file-mat-v7-or-as-csv = este é um arquivo HDF5, que o MATLAB também escreve como versão 7.3: salve-o por `save('file.mat', '-v7')`, ou como CSV
this-is-no-mat-file-of-version-5-save-it-by-save-file-mat-v7-or-as-csv = este não é um arquivo MAT da versão 5: salve-o por `save('file.mat', '-v7')`, ou como CSV
this-is-no-wav-file-of-pcm-save-the-recording-as-one-or-as-csv = este não é um arquivo WAV de PCM: salve a gravação como tal, ou como CSV
this-is-a-workbook-of-the-old-format-or-another-one-in-its-container-save-it-as-xlsx = esta é uma pasta de trabalho do formato antigo, ou outro arquivo no mesmo invólucro: salve-a como .xlsx
this-file-is-compressed-by-gzip-unpack-it-first = este arquivo está comprimido por gzip: descomprima-o antes
this-is-an-archive-unpack-it-first-a-workbook-is-read-by-its-name-xlsx-or-ods = este é um arquivo compactado: descompacte-o antes; uma planilha é lida pelo nome, .xlsx ou .ods
this-build-reads-no-wav-files-build-it-with-features-wav-or-save-the-samples-as-csv = esta compilação não lê arquivos WAV: compile com `--features wav`, ou salve as amostras como CSV
this-build-reads-no-mat-files-build-it-with-features-matlab-or-save-the-variables-as-csv = esta compilação não lê arquivos MAT: compile com `--features matlab`, ou salve as variáveis como CSV
part-write-a-number-from-1-on-as-in-2-or-1-3 = `#{ $part }`: escreva um número a partir de 1, como em `#2` ou `#1,3`
row-row-column-is-not-a-number = linha { $row }: `{ $column }` não é um número
the-file-is-empty = o arquivo está vazio
