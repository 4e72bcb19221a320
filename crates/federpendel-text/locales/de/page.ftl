# Was die Seite sagt. Der Ordner en enthält dieselben Namen mit denselben Variablen.

page-title = Federpendel mit Reibung
page-skip = Zum Inhalt springen
page-language = Sprache
page-theme = Farben
page-theme-system = wie das System
page-theme-light = hell
page-theme-dark = dunkel
page-link = Link kopieren
page-link-copied = Der Link zu diesem Versuch ist kopiert.
page-link-in-address = Die Adresse dieser Seite führt jetzt zu diesem Versuch.
page-link-of-file = Der Link ist kopiert. Er führt zu dieser Datei auf diesem Gerät; wer sie anderswo hat, öffnet sie dort und hängt den Teil ab dem Zeichen # an.
page-link-broken = Das Ende der Adresse ist kein Versuch, den diese Seite lesen kann; sie zeigt einen anderen.
page-print = Drucken
page-footer = Alle Zahlen berechnet federpendel auf dieser Seite. Nichts verlässt Ihr Gerät.

## Der Versuch

page-experiment = Versuch
page-preset = Beispiel
page-preset-own = eigener Versuch
page-body = Masse und Feder
page-place = Wie sich die Masse bewegt
page-lying = liegend
page-hanging = hängend
page-friction = Reibung
page-critical = Aperiodischen Grenzfall einstellen
page-release = Loslassen
page-whole-motion = Die ganze Bewegung zeigen

## Die Szene

page-stage = Die Bewegung
page-scene-description = Eine Masse an einer Feder, maßstäblich gezeichnet
page-mass-handle = Masse: Auslenkung beim Loslassen
page-scene-hint = Die Masse ziehen und loslassen oder werfen.
page-scene-keys = Die Pfeiltasten verschieben die Masse, mit der Umschalttaste in kleinen Schritten; die Eingabetaste lässt sie los.
page-sticks = haftet
page-force-spring = Feder
page-force-weight = Gewicht
page-force-sum = Summe
page-forces = Kräfte
page-play = Abspielen
page-pause = Anhalten
page-restart = Noch einmal loslassen
page-previous-turning-point = Zurück zum vorigen Umkehrpunkt
page-next-turning-point = Weiter zum nächsten Umkehrpunkt
page-speed = Tempo
page-time = Zeit
page-released = Losgelassen bei { $position } mit { $velocity }.
page-at-rest = Die Masse ist bei { $position } zur Ruhe gekommen, nach { $time }.
page-at-end = Die Aufzeichnung endet bei { $time } und beginnt von vorn.
page-stands = Bei { $time } steht die Masse bei { $position }.
page-calm = Weil Sie wenig Bewegung wünschen, springt das Bild zum nächsten Umkehrpunkt; „Abspielen“ zeigt die Bewegung selbst.
page-energy-hanging = Potentiell (Feder und Gewicht)

## Die Diagramme

page-plots = Diagramme
page-plots-shown = Welche Diagramme zu sehen sind
page-show-motion = Auslenkung
page-show-phase = Phasenporträt
page-show-energy = Energie
page-show-decrement = Amplitudenverlust
page-plot-motion = Auslenkung über der Zeit
page-plot-phase = Phasenporträt
page-plot-energy = Wo die Energie ist
page-plot-energy-mean = Wo die Energie ist, gemittelt über jede Periode
page-plot-energy-description = Kinetische und potentielle Energie und die Wärme jeder Art von Reibung als Flächen übereinander; ihre Summe bleibt die Energie beim Loslassen.
page-plot-decrement = Amplitudenverlust je Halbschwingung
page-plot-decrement-description = Was jede Halbschwingung kostet, über ihrer mittleren Amplitude: Coulombsche Reibung ist der Achsenabschnitt, Stokessche die Steigung, Newtonsche die Krümmung.
page-plot-no-swings = Keine Halbschwingung: Die Masse kehrt nicht zweimal um
page-plot-still = Die Masse bewegt sich nicht
page-plot-keys = Plus und Minus vergrößern und verkleinern, die Pfeiltasten verschieben, 0 zeigt alles.
page-plot-hint = Ziehen vergrößert einen Ausschnitt, mit der Umschalttaste verschiebt es; zwei Finger oder Strg und Mausrad vergrößern; ein Doppelklick zeigt alles.
page-plot-hint-touch = Ein Finger verschiebt den Ausschnitt, zwei vergrößern ihn; zweimal Tippen zeigt alles.
page-zoom-in = Vergrößern
page-zoom-out = Verkleinern
page-zoom-all = Alles zeigen
page-save = Speichern
page-csv = CSV mit Dezimalpunkt
page-csv-german = CSV mit Semikolon und Dezimalkomma
page-energies = kinetisch { $kinetic }, potentiell { $potential }, Wärme { $heat }
page-swing = Halbschwingung { $number }: Amplitude { $amplitude }, Verlust { $loss }
page-keep = Kurve festhalten
page-forget = { $curve } entfernen

## Die Zahlen

page-numbers = Zahlen
page-number = Nr.
page-known-as = Lösung
page-point-time = t in s
page-point-position = x in m
page-rest-time = In Ruhe nach
page-rest-position = In Ruhe bei

## Die Fehlerlupe

page-lens = Wie gut ist die Formel, wie gut das Verfahren?
page-lens-text = Eine Formel des Artikels oder ein numerisches Verfahren wählen: Seine Bewegung steht neben der richtigen, und daneben, wie weit sie abweicht.
page-method = Verfahren
page-formulas = Formeln des Artikels
page-schemes = Numerische Verfahren
page-plot-method = { $method } neben der Bewegung
page-plot-error = Abweichung: { $method }
method-article-printed = Formel wie gedruckt
method-article-corrected = Formel berichtigt
method-article-scheme = Differenzenverfahren des Artikels
method-symplectic-euler = Euler, symplektisch
method-verlet = Verlet
method-verlet-located = Verlet mit genauer Umkehr
method-rk4 = Runge–Kutta
method-rk4-located = Runge–Kutta mit genauer Umkehr
method-rk4-tanh = Runge–Kutta mit geglätteter Reibung
method-dopri5 = Dormand–Prince
method-dopri5-located = Dormand–Prince mit genauer Umkehr
method-moreau-jean = Moreau–Jean

## Die Aufzeichnung

page-recording = Welche Reibung wirkt in meiner Aufzeichnung?
page-recording-text = Die Datei bleibt auf Ihrem Gerät. Die Seite findet darin das freie Ausschwingen, passt alle Mischungen der drei Arten von Reibung an und sagt, welche wirken.
page-drop = Eine Aufzeichnung hier ablegen oder
page-choose-file = Datei wählen
page-file-kinds = Excel (.xlsx, .xls) oder Text (.csv, .txt, einzeln oder in einer .zip-Datei) aus phyphox, Tracker, PASCO Capstone, Vernier oder jede andere Tabelle mit einer Spalte für die Zeit
page-class-mode = Für die Klasse: das Urteil verbergen, bis jemand fragt
page-fitting = { $name } wird angepasst …
page-fit-fault = An { $name } ist die Anpassung gescheitert, durch einen Fehler dieser Seite; das Programm federpendel kommt vielleicht weiter.
page-fitted = { $name } ist angepasst.
page-run = Durchgang
page-reveal = Das Urteil zeigen
page-verdict-hidden = Die Aufzeichnung ist angepasst. Welche Reibung wirkt hier? Der Verlust an Amplitude je Halbschwingung verrät es.
page-overlay = Die simulierte Bewegung darüberlegen
page-simulated = Simuliert
page-simulate-fit = Die angepasste Bewegung simulieren
page-report-footer = Angepasst mit federpendel, gespeichert am { $date }.
page-report = Bericht speichern
page-plot-recording = Aufzeichnung
page-plot-residuals = Was die Anpassung übrig lässt
page-drop-now = Loslassen: Die Datei wird angepasst.
page-first-of-many = { $count } Dateien auf einmal: Angepasst wird die erste, { $name }.
page-folder = { $name }: Das ist ein Ordner; erlaubt ist eine Datei mit einer Aufzeichnung.
page-unreadable = { $name }: Die Datei lässt sich nicht lesen; vielleicht ist sie verschoben, gesperrt oder zu groß.
page-cancel = Abbrechen
page-cancelled = { $name }: Die Anpassung ist abgebrochen.
page-asked = Angaben zum Versuch
page-asked-text = Nichts davon ist nötig. Mit der Masse des Körpers oder der Federkonstante folgen Dämpfung und Kräfte, mit der Kraft auf die Führung die Reibungszahlen.
page-as-found = wie gefunden
page-support-unknown = keine oder unbekannt
page-support-horizontal = waagrecht: sein Gewicht drückt
page-support-force = eine bekannte Kraft drückt
asked-unit = Einheit der Werte
asked-rate = Abtastrate
asked-table = Tabelle
asked-from = Anfang des angepassten Teils
asked-to = Ende des angepassten Teils
asked-mass = Masse des Körpers
asked-stiffness = Federkonstante
asked-spring-mass = Masse der Feder
asked-support = Führung
asked-normal-force = Kraft auf die Führung
page-fit-shown = Nur den gezeigten Ausschnitt anpassen
page-fit-whole = Anfang und Ende wieder selbst finden
page-no-simulation-unit = Um die angepasste Bewegung zu simulieren, fehlt die Einheit der Längen: Geben Sie bei „Angaben zum Versuch“ die Einheit der Werte an, etwa cm.
page-no-simulation-angle = Simulieren lässt sich diese Bewegung hier nicht: Die Aufzeichnung enthält Winkel, die Masse der Szene bewegt sich geradlinig.
page-simulating = Die Szene zeigt jetzt die angepasste Bewegung.
page-details = Einzelheiten
