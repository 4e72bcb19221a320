# Was verlangt wurde und nicht geht, und was eine Anpassung neben ihren Werten sagt. Der Ordner en hat dieselben Namen mit denselben Variablen.

### Die Befehlszeile

cli-missing-recording = Es fehlt eine Datei mit einer Aufzeichnung, wie in federpendel fit aufzeichnung.csv
cli-no-seed = { $argument } ist „{ $value }“; erlaubt ist eine ganze Zahl von 0 bis 18446744073709551615
quantity-or = { $one } oder { $other }
fit-window-reversed = { $begin } ist { $from } und { $end } ist { $to }; erlaubt ist ein { $begin } vor { $end }

### Ein Plan

plan-too-few-swings = Unter { $amplitude } bleiben weniger als fünf Halbschwingungen: nicht geplant.

### Die Bilder einer Anpassung

plot-residual-axis = Residuum

### Was neben einer Aufzeichnung gemessen wurde

physical-bare-number = { $name } hat keine Einheit: Angenommen wird { $value }.
quantity-uncertainty-large = die Unsicherheit ist größer als der halbe Wert, zu groß für eine Fortpflanzung auf andere Zahlen

### Die Zusammenfassung einer Anpassung

fit-row-plus-minus = ±
fit-plus-minus = ein Standardfehler
physical-hint = Mit --mass und --horizontal folgen auch Federkonstante, D, Kräfte und μ.
