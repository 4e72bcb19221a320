# Was verlangt wurde und nicht geht, und was eine Anpassung neben ihren Werten sagt. Der Ordner en hat dieselben Namen mit denselben Variablen.

### Die Befehlszeile

cli-missing-recording = Es fehlt eine Datei mit einer Aufzeichnung, wie in federpendel fit aufzeichnung.csv
cli-no-seed = { $argument } ist „{ $value }“; erlaubt ist eine ganze Zahl von 0 bis 18446744073709551615
quantity-or = { $one } oder { $other }
fit-window-reversed = --from ist { $from } und --to ist { $to }; erlaubt ist ein --from vor --to
