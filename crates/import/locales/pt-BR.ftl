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
