# Wie man einen Versuch plant. Der Ordner en enthält dieselben Namen mit denselben Variablen.

### Die Befehlszeile

cli-plan = Einen Versuch planen: von wo loslassen, wie lange aufzeichnen, damit sich die Reibungsgesetze trennen
cli-plan-examples =
    Der Versuch sagt, was zu erwarten ist: Masse, Feder, Reibung. Seine Auslenkung (position) ist die größte, aus der losgelassen werden darf (oder --max-amplitude), seine Dauer (duration) die längste Aufzeichnung.

    Beispiele:
      federpendel plan --noise 1mm
      federpendel plan mein.toml --noise 1mm --rate 50Hz --max-amplitude 30cm
      federpendel plan mein.toml --noise "2 cm/s^2" --rate "100 Hz" --duration "60 s" --details
      federpendel plan mein.toml --noise 1mm --laws auto -o plan.svg -o plan.json
cli-plan-noise = Rauschen des Sensors (Standardabweichung eines Werts); seine Einheit sagt, was aufgezeichnet wird: „1 mm“ die Auslenkung, „1 mm/s“ die Geschwindigkeit, „1 cm/s^2“ die Beschleunigung
cli-plan-rate = Werte je Sekunde der Aufzeichnung (Vorgabe: 50 Hz)
cli-plan-quantity = Was aufgezeichnet wird: position (Auslenkung), velocity (Geschwindigkeit) oder acceleration (Beschleunigung); Vorgabe: was die Einheit von --noise sagt
cli-plan-min-amplitude = Kleinste Amplitude beim Loslassen, die betrachtet wird (Vorgabe: das Zehnfache des Rauschens)
cli-plan-max-amplitude = Größte Amplitude beim Loslassen (Vorgabe: die des Versuchs)
cli-plan-laws = Reibungsgesetze, die die Anpassung außer den erwarteten zulässt: auto (alle drei), none (keines, Vorgabe) oder eine Liste aus stokes, coulomb, newton

plan-no-noise = --noise fehlt; erlaubt ist die Standardabweichung eines Werts des Sensors, etwa --noise 1mm
plan-no-samples = --samples gehört nicht zu einem Plan; erlaubt sind --rate, die Werte je Sekunde, und --duration, die Dauer
plan-no-release = Der Versuch beginnt in der Mitte; nötig ist eine größte Amplitude, etwa --max-amplitude 10cm
plan-rate-too-low = --rate ist { $rate }; erlaubt ist mindestens { $least }, vier Werte je Halbschwingung
plan-duration-too-short = --duration ist { $duration }; erlaubt ist mindestens { $least }, fünf Halbschwingungen
plan-no-swings = Mit der erwarteten Reibung schwingt die Masse nicht: Ihr Dämpfungsgrad ist { $ratio }; erlaubt ist einer unter 1
plan-sticks = Aus { $amplitude } losgelassen bewegt sich die Masse nicht, denn die Haftreibung hält sie bis { $held }; erlaubt ist ein größeres --max-amplitude oder position
plan-reversed = --min-amplitude ist { $from }; erlaubt ist weniger als die größte Amplitude, { $to }
plan-drowned = Das Rauschen entspricht einer Amplitude von { $noise }; losgelassen werden darf höchstens aus { $amplitude }, weniger als dem Zehnfachen. Nötig ist weniger Rauschen oder ein größeres --max-amplitude oder position
plan-not-computed = Die Bewegung mit diesen Koeffizienten lässt sich nicht berechnen: Zahlen auf dem Weg sind zu groß oder zu klein
plan-too-long = Die Bewegung lässt sich nur bis { $reached } verfolgen; erlaubt ist eine kürzere Dauer (--duration)

### Das Bild

plan-plot-title = Was sich beim Loslassen zeigt: { $mix }
plan-plot-amplitude = Amplitude beim Loslassen
plan-plot-significance = Koeffizient / Standardfehler
plan-plot-threshold = aufgelöst ab { $threshold }
plan-plot-description = { $title }: Koeffizient durch Standardfehler für Amplituden beim Loslassen von { $from } bis { $to }, beide Achsen logarithmisch. { $laws }. Aufgelöst ist ein Gesetz ab { $threshold }.
plan-plot-law = { $name } steigt von { $first } auf { $last }

### Was ein Plan sagt

plan-none-expected = Es wird keine Reibung erwartet.
plan-advice-one = Mindestens aus { $amplitude } loslassen und { $duration } aufzeichnen: Dann zeigt sich { $mix }.
plan-advice-some = Mindestens aus { $amplitude } loslassen und { $duration } aufzeichnen: Dann trennen sich { $mix }.
plan-advice-none = Bis { $amplitude } lässt sich nichts auflösen.
plan-drowns = Unter { $amplitude } zeigt sich { $law } nicht.
plan-unresolved = { $law } wird auch aus { $amplitude } nicht aufgelöst: Dort liegt ihr Koeffizient { $significance } Standardfehler über null. Es hülfe ein { $factor }-mal kleineres Rauschen oder die { $square }-fache Rate.
plan-unresolved-beyond = { $law } wird auch aus { $amplitude } nicht aufgelöst: Dort liegt ihr Koeffizient { $significance } Standardfehler über null. Es hülfe ein { $factor }-mal kleineres Rauschen, die { $square }-fache Rate oder Loslassen aus { $beyond }.
plan-unseen = { $law } ist bis { $amplitude } gar nicht zu sehen.
plan-confused = Bei { $amplitude } sehen sich { $one } und { $other } sehr ähnlich (Korrelation ihrer Koeffizienten { $correlation }).
plan-limit = { $law }, die nicht erwartet wird, würde sich ab { $value } zeigen ({ $amplitude }, { $duration }).
plan-head-law = Gesetz
plan-head-coefficient = Koeffizient
plan-head-amplitude = Amplitude
plan-head-duration = Dauer
plan-head-stderr = Standardfehler
plan-coefficient-stokes = γ = { $value }
plan-coefficient-coulomb = a_c = { $value }
plan-coefficient-newton = κ = { $value }
plan-as-given-stokes = D = { $value }
plan-as-given-coulomb = μF_N = { $value }
plan-as-given-newton = ½ρc_wA = { $value }
plan-row-recording = Aufzeichnung
plan-recording-value = { $quantity }, Rauschen { $noise }, { $rate } Werte je Sekunde
plan-row-amplitudes = Amplituden
plan-amplitudes-value = { $from } bis { $to }
plan-row-fitted = zusammen angepasst
plan-row-fit = anzupassen mit
plan-coefficient-value = { $reduced }, { $given }
plan-row-largest = { $law }, aus { $amplitude }
plan-largest-value = { $significance } Standardfehler über null in { $duration }
plan-pair-value = Korrelation { $correlation } bei { $amplitude }
plan-row-limit = { $law }, nicht erwartet
plan-limit-value = würde sich ab { $reduced } zeigen ({ $given }); wird null gefunden, liegt sie mit 95 % unter { $upper }
plan-assumed = Vorausgesetzt sind ein Rauschen ohne Gedächtnis von Wert zu Wert, für alle Werte gleich, und genau die Bewegung eines Federpendels mit diesen Gesetzen: Eine Feder, die bei großen Amplituden weicher wird, ein Sensor, der driftet, oder ein Wagen, der wackelt, verlangen mehr. „Zeigt sich“ und „trennen sich“ heißt, dass der Koeffizient mindestens fünf Standardfehler über null liegt; die Dauer ist die, nach der jede längere den Standardfehler um höchstens 5 % verkleinert.
