# Was verlangt wurde und nicht geht. Der Ordner en hat dieselben Namen mit denselben Variablen.

### Die Befehlszeile

cli-missing-recording = Es fehlt eine Datei mit einer Aufzeichnung, wie in federpendel fit aufzeichnung.csv
cli-no-seed = { $argument } ist „{ $value }“; erlaubt ist eine ganze Zahl von 0 bis 18446744073709551615
quantity-or = { $one } oder { $other }

### Ein Plan

plan-too-few-swings = Unter { $amplitude } bleiben weniger als fünf Halbschwingungen: nicht geplant.

### Was fit annimmt

fit-sigma-unit = { $name }: --sigma ist in { $unit }, die Werte sind in { $found }; erlaubt ist deren Einheit oder eine Zahl in ihr
fit-note-files =
    { $count ->
        [one] { $first } und eine weitere Datei
       *[other] { $first } und { $count } weitere Dateien
    }
fit-some-failed = { $failed } von { $all } Aufzeichnungen ließen sich nicht anpassen
physical-help-mass = Masse des Körpers ohne die Feder: ergibt Kräfte und die Federkonstante
physical-help-stiffness = Federkonstante: ergibt die Masse oder wird mit der angegebenen verglichen
physical-help-spring-mass = Masse der Feder, von der sich ein Drittel mit dem Körper bewegt (Vorgabe: 0)
physical-help-normal-force = Kraft, die den Körper auf seine Führung drückt: ergibt die Reibungszahlen
physical-help-horizontal = Der Körper gleitet auf einer waagrechten Führung: Die Normalkraft ist sein Gewicht
physical-help-gravity = Fallbeschleunigung für --horizontal (Vorgabe: 9,81 m/s^2)
cli-plot-fit = Was Bilder zeigen: { $plots } (Vorgabe: fit)
