# Was nur die Befehlszeile sagt. Im Ordner en stehen dieselben Kennungen mit denselben Variablen.

### Versuche, die abgelehnt werden

experiment-too-large = Die Datei ist größer als { $limit } Bytes; mehr wird nicht gelesen
experiment-not-utf8 = Die Datei ist kein UTF-8-Text (Byte { $offset }); erlaubt ist eine TOML-Datei mit den Abschnitten { $sections }
experiment-empty = Die Datei ist leer; erlaubt ist eine TOML-Datei mit den Abschnitten { $sections }
toml-unquoted = { $key } = { $value } ist kein TOML; eine Zahl mit Einheit oder Dezimalkomma muss in Anführungszeichen stehen: { $key } = "{ $value }"
toml-typographic = Das ist kein TOML: Typographische Anführungszeichen gelten dort nicht, nur gerade: { $example }
toml-unquoted-text = Das ist kein TOML: Ein Wert, der keine bloße Zahl ist, muss in Anführungszeichen stehen: { $example }
toml-twice = Das ist kein TOML: { $key } steht zweimal da; erlaubt ist einmal
toml-bad-text = Das ist kein TOML: Einem Text fehlt das schließende Anführungszeichen, oder er enthält unerlaubte Zeichen; richtig wäre: { $example }
toml-unclosed-section = Das ist kein TOML: Dem Namen eines Abschnitts fehlt die schließende Klammer; richtig wäre: { $example }
toml-unclosed-table = Das ist kein TOML: Die schließende geschweifte Klammer fehlt; richtig wäre: { $example }
toml-unclosed-list = Das ist kein TOML: Die schließende Klammer einer Liste fehlt; ein Versuch braucht keine Listen
toml-no-equals = Das ist kein TOML: Auf einen Schlüssel müssen „=“ und ein Wert folgen: { $example }
toml-no-value = Das ist kein TOML: Hinter „=“ steht kein Wert; richtig wäre: { $example }
toml-bad-key = Das ist kein TOML: Vor „=“ muss ein Schlüssel aus einfachen Buchstaben stehen: { $example }
toml-comma = Das ist kein TOML: Zwischen zwei Werten in geschweiften Klammern muss genau ein Komma stehen: { $example }
toml-bad-number = Das ist kein TOML: So darf eine Zahl in TOML nicht geschrieben sein; in Anführungszeichen ist mehr erlaubt: { $example }
toml-trailing = Das ist kein TOML: Hinter dem Ende eines Werts oder Abschnitts steht noch etwas; jeder Schlüssel beginnt eine eigene Zeile
toml-too-deep = Dieses TOML lässt sich nicht lesen: zu viele Klammern oder Punkte ineinander
toml-other = Das ist kein TOML (die Leseroutine sagt auf Englisch: { $problem })
experiment-unknown-key = { $name } ist unbekannt; hier erlaubt: { $allowed }
experiment-unknown-key-near = { $name } ist unbekannt; war { $nearest } gemeint? Hier erlaubt: { $allowed }
experiment-allowed-keys = ein Abschnitt mit { $keys }
experiment-missing = { $name } (oder --{ $flag }) fehlt; erlaubt ist { $allowed }
experiment-too-many-samples = { $name } ist { $value }; in den freien Speicher passen höchstens { $fit } Abtastwerte
experiment-both = { $name } ist { $value } und { $other } ist { $otherValue }; nur eines von beiden darf angegeben sein
experiment-static-below-kinetic = { $name } ist { $value }; erlaubt ist mindestens { $other }, { $otherValue }
experiment-static-without-kinetic = { $name } ist { $value }, aber { $missing } fehlt; Haftreibung ist nur neben Gleitreibung erlaubt
experiment-incomplete = { $name } ist { $value }, aber { $missing } fehlt; Newtonsche Reibung braucht { $density }, { $drag } und { $area }, oder { $coefficient } allein
experiment-no-normal-force = { $name } ist { $value }; die Coulombsche Reibung braucht eine Normalkraft größer als 0

### Die Kommandozeile

cli-error = Fehler
cli-system-refuses = { $name }: { $problem }
cli-stdout = Standardausgabe
cli-computing = rechnet
cli-writing = schreibt
cli-written = geschrieben: { $name }
cli-about = Die exakte Bewegung einer Masse an einer Feder mit Stokesscher, Coulombscher und Newtonscher Reibung
cli-heading-usage = Aufruf
cli-heading-commands = Befehle
cli-heading-arguments = Argumente
cli-heading-options = Optionen
cli-heading-overrides = Größen: Zahl und Einheit; jede ersetzt ihr Feld im Versuch
cli-value-command = BEFEHL
cli-value-file = DATEI
cli-value-options = OPTIONEN
cli-value-name = NAME
cli-value-quantity = GRÖSSE
cli-help = Hilfe ausgeben
cli-version = Version ausgeben
cli-lang = Sprache aller Texte: de oder en (Vorgabe: aus der Umgebung)
cli-simulate = Die Bewegung eines Versuchs berechnen
cli-completions = Vervollständigungen für eine Shell auf die Standardausgabe schreiben
cli-man = Die Handbuchseite auf die Standardausgabe schreiben
man-name = BEZEICHNUNG
man-synopsis = ÜBERSICHT
man-description = BESCHREIBUNG
man-extra = BEISPIELE
man-version = VERSION
cli-shell = bash, elvish, fish, powershell oder zsh
cli-experiment = Versuchsdatei, „-“ für die Standardeingabe; ohne sie läuft der eingebaute Versuch: 0,5 kg an 20 N/m, losgelassen bei 10 cm, Gleitreibungszahl 0,02
cli-method = Verfahren, das die Abtastwerte berechnet: { $methods } (Vorgabe: exact)
cli-noise = Rauschen eines Sensors (Standardabweichung) für Tabellen; seine Einheit sagt, was aufgezeichnet wird: „1 mm“ die Auslenkung, „1 mm/s“ die Geschwindigkeit, „1 cm/s^2“ die Beschleunigung
cli-seed = Anfangswert des Rauschens (Vorgabe: 0); derselbe Wert gibt dasselbe Rauschen
cli-noise-without-csv = --noise gilt für Tabellen; dazu gehört eine Datei mit der Endung .csv oder --format csv
cli-seed-without-noise = --seed gehört zu --noise
cli-dt = Zeitschritt von article-scheme (Vorgabe: ein Tausendstel der Periode)
cli-experiment-file = Eine Versuchsdatei ist TOML; ein Wert ist eine Zahl und ihre Einheit in Anführungszeichen, eine bloße Zahl gilt in SI-Einheiten. Nur mass, stiffness und position müssen angegeben sein. Statt gravity darf normal_force stehen, statt density, drag_coefficient und area ein coefficient in newton.
cli-output = Eine Datei schreiben; ihre Endung bestimmt das Format: { $forms }; „-“ ist die Standardausgabe. Mehrfach möglich
cli-format = Was auf die Standardausgabe kommt: summary (Vorgabe), csv oder json
cli-csv-dialect = standard (Vorgabe), oder german mit Semikolons und Dezimalkommas
cli-details = Ausführliche Zusammenfassung
cli-examples =
    Beispiele:
      federpendel simulate
      federpendel simulate mein.toml -o bewegung.csv -o bewegung.svg
      federpendel simulate --help
cli-simulate-examples =
    Ohne Dauer endet die Aufzeichnung kurz nach dem Stillstand der Masse, oder nach 12 Perioden, wenn sie später als nach 200 Perioden oder nie zur Ruhe kommt; wo sie nur kriecht, nach zehn Zeitkonstanten.
    Beispiele:
      federpendel simulate
      federpendel simulate mein.toml -o bewegung.csv -o bewegung.svg
      federpendel simulate mein.toml --kinetic 0,05 --position "-5 cm" --details
      federpendel simulate mein.toml --format json > bewegung.json
      federpendel simulate --method article-scheme --dt "10 ms"
cli-completions-examples =
    Beispiele:
      federpendel completions bash > ~/.local/share/bash-completion/completions/federpendel
      federpendel completions fish > ~/.config/fish/completions/federpendel.fish
cli-man-examples =
    Beispiele:
      federpendel man | man -l -
      federpendel man > ~/.local/share/man/man1/federpendel.1
cli-unknown-argument = { $argument } ist unbekannt; federpendel --help zeigt, was erlaubt ist
cli-unknown-argument-near = { $argument } ist unbekannt; war { $nearest } gemeint?
cli-unknown-command = { $argument } ist kein Befehl; erlaubt sind { $allowed }
cli-file-without-command = { $file } ist eine Datei, und vor ihr muss ein Befehl stehen, wie in federpendel { $command } { $file }
cli-unknown-command-near = { $argument } ist kein Befehl; war { $nearest } gemeint?
cli-invalid-value-near = { $argument } ist „{ $value }“; war { $nearest } gemeint? Erlaubt sind { $allowed }
cli-second-file = „{ $argument }“ ist eine Datei zu viel: Nur eine Versuchsdatei ist erlaubt
cli-missing-value = { $argument } hat keinen Wert; es muss einer folgen
cli-invalid-value = { $argument } ist „{ $value }“; erlaubt sind { $allowed }
cli-given-twice = { $argument } ist zweimal angegeben; erlaubt ist einmal
cli-missing-argument = { $argument } fehlt; erlaubt sind { $allowed }
cli-no-value-allowed = { $argument } ist „{ $value }“; hier ist kein Wert erlaubt
cli-argument-not-utf8 = Ein Argument ist kein UTF-8-Text
cli-output-twice = --output „{ $name }“ nennt eine Datei, die dieser Aufruf schon benutzt
cli-output-folder = --output „{ $name }“ ist ein Ordner; erlaubt ist eine Datei
cli-output-nowhere = --output „{ $name }“: der Ordner „{ $folder }“ fehlt
cli-output-special = --output „{ $name }“ ist keine gewöhnliche Datei
cli-output-extension = --output „{ $name }“ hat eine unbekannte Dateiendung; erlaubt sind { $allowed }

### Die Zusammenfassung

summary-given-row = Angegeben
summary-friction = Reibung
summary-period-value = { $period } (Frequenz { $frequency })
summary-period-small-value = { $period } bei kleinen Ausschlägen (Frequenz { $frequency })
summary-damping = Dämpfungsgrad
summary-damping-value = { $ratio } ({ $regime })
summary-energy = Energie
summary-energy-value = { $initial } beim Loslassen, { $left } am Ende der Aufzeichnung
summary-record = Aufzeichnung
summary-record-value = { $samples } Abtastwerte über { $duration }
summary-method = Verfahren
summary-kind = Lösung
summary-given = Angegeben
summary-derived = Daraus folgt
summary-spent = Energie am Ende der Aufzeichnung
summary-certainty = Wie genau das bekannt ist
summary-turning-points = Umkehrpunkte
summary-more-points = … und weitere; --format json schreibt alle
summary-energy-initial = beim Loslassen
summary-energy-kinetic = kinetisch
summary-energy-potential = potentiell
summary-heat-stokes = Wärme der Stokesschen Reibung
summary-heat-coulomb = Wärme der Coulombschen Reibung
summary-heat-newton = Wärme der Newtonschen Reibung
summary-error-bound = Fehler der Auslenkung unter
summary-margin = Ruhelage im Haftbereich
summary-margin-value = { $distance } vom Rand entfernt, { $margin } % der Verschiebung f
summary-point-time = t in s
summary-point-position = x in m
summary-deviation = { $method } weicht von dieser Bewegung um bis zu { $distance } ab, am meisten bei { $time }.
summary-agrees = { $method } stimmt mit dieser Bewegung auf Rundung genau überein.
summary-method-equation = { $method }, Gleichung { $equation }
summary-method-overdamped = { $method }, die Lösung des Artikels für den Kriechfall
summary-method-critical = { $method }, die Lösung des Artikels für den aperiodischen Grenzfall
summary-method-steps = { $method }, Schritte von { $step }
summary-method-interpolated = { $method }, Schritte von { $step }; Werte zwischen den Schritten sind interpoliert
cli-dt-without-scheme = --dt ist „{ $value }“, aber das Verfahren ist { $method }; ein Zeitschritt ist nur bei --method article-scheme erlaubt
cli-temporary-folder = der Ordner für temporäre Dateien, { $folder } (TMPDIR)
cli-not-found = Datei oder Ordner nicht gefunden
cli-permission-denied = keine Berechtigung
cli-is-a-folder = das ist ein Ordner, keine Datei
cli-is-no-folder = ein Teil dieses Pfads ist eine Datei, kein Ordner
cli-name-too-long = dieser Name ist zu lang oder enthält ein Zeichen, das das System nicht erlaubt
cli-storage-full = kein Platz mehr auf dem Datenträger
cli-read-only = dieses Dateisystem darf nur gelesen werden
step-unstable = ein Zeitschritt von { $step } ist zu lang: Das Verfahren ist damit instabil und läuft der Bewegung davon. Stabil ist es unter { $longest }; sicher ist --dt "{ $proposed }"
step-coarse = ein Zeitschritt von { $step } ist für diese Aufzeichnung zu lang: Der Fehler des Verfahrens ist größer geworden als die Bewegung. Besser wäre --dt "{ $proposed }" oder eine kürzere Aufzeichnung
cli-warning = Warnung
summary-energy-values = { $initial } beim Loslassen; am Ende der Aufzeichnung { $left } ({ $motion }), { $other } ({ $method })
summary-heading-of = { $heading } ({ $whose })
summary-margin-tie = auf der Kante, im Rahmen der Rundung
summary-margin-distance = { $distance } vom Rand entfernt

### Verfahren neben der exakten Bewegung

cli-compare = Verfahren neben die exakte Bewegung eines Versuchs halten: wie weit daneben, von welcher Ordnung, mit welchem Aufwand
cli-compare-examples =
    Beispiele:
      federpendel compare
      federpendel compare mein.toml --against rk4,rk4-located --dt "5 ms"
      federpendel compare mein.toml --plot convergence -o ordnungen.svg
      federpendel compare --against dopri5-located --tolerance 1e-9 --details
      federpendel compare --format json > vergleich.json
cli-value-names = NAMEN
cli-value-numbers = NUMMERN
cli-value-number = ZAHL
cli-against = Verfahren, durch Kommas getrennt: { $methods } (Vorgabe: alle, die hier gelten)
cli-compare-dt = Zeitschritt der Verfahren, die einen nehmen (Vorgabe: etwa ein Tausendstel der Periode, so dass kein Umkehrpunkt auf einen Schritt fällt)
cli-tolerance = Fehler, den dopri5 und dopri5-located in einem Schritt machen dürfen, bezogen auf die Amplitude (Vorgabe: 1e-6)
cli-width = Geschwindigkeit, über die rk4-tanh die trockene Reibung glättet (Vorgabe: 1 % von ω0 mal Amplitude)
cli-theme = Worauf Bilder gezeichnet werden: light (hell, Vorgabe) oder dark (dunkel)
cli-plot-motion = Was Bilder zeigen: { $plots } (Vorgabe: motion)
cli-plot-comparison = Was Bilder zeigen: { $plots } (Vorgabe: error)
compare-unknown-method = --against nennt „{ $name }“; erlaubt sind { $allowed }
compare-unknown-method-near = --against nennt „{ $name }“; war { $nearest } gemeint? Erlaubt sind { $allowed }
compare-does-not-apply = --against nennt „{ $name }“, das hier nicht gilt. { $reason }
compare-one = { $method } weicht um bis zu { $error } davon ab.
compare-range = Am nächsten bleibt { $nearest }, bis auf { $least }; am weitesten weicht { $farthest } ab, um { $most }.
compare-head-method = Verfahren
compare-head-error = Fehler
compare-head-order = Ordnung
compare-head-rest = in Ruhe
compare-head-steps = Schritte
compare-head-time = Laufzeit
compare-order-note = Ordnung: laut Entwurf → beobachtet bei sechs Halbierungen des Schritts
compare-failed = gescheitert
compare-no-order = { $method } zeigt keine Ordnung: { $reason }.
compare-failed-rung = mit { $setting } scheitert es; { $reason }
compare-failure = { $method } ist gescheitert: { $reason }.
compare-detail-largest = größter Fehler einer Auslenkung
compare-detail-when = wann das war
compare-detail-mean = mittlerer quadratischer Fehler (Wurzel)
compare-detail-energy = größter Fehler der Energie, bezogen auf die beim Loslassen
compare-detail-final = Auslenkung am Ende
compare-detail-rungs = Fehler bei immer kürzeren Schritten
compare-detail-creep = Nach der Ruhe: beobachtet in der zweiten ungedämpften Periode, nachdem die Masse zur Ruhe gekommen ist.

### Werte anderer Programme gegen die Referenzprobleme

cli-score = Die Werte eines anderen Programms an einem Referenzproblem messen: wie weit daneben, und ob sie in der Ruhelage stillstehen
cli-score-examples =
    Eine Datei mit Werten ist CSV mit Kopfzeile: die Spalten time und position, dazu velocity, wenn bekannt, in SI-Einheiten; die Zeiten in beliebiger Folge. Zwischen den Zellen stehen Kommas oder Semikolons; mit Semikolons sind auch Dezimalkommas erlaubt. Andere Spalten bleiben unbeachtet.
    Beispiele:
      federpendel score --list coulomb
      federpendel score --problem laboratory-c --times > zeiten.txt
      federpendel score meine.csv --problem laboratory-c
      federpendel score meine.csv --problem laboratory-c --format json
cli-score-samples = Datei mit Werten, „-“ für die Standardeingabe
cli-score-problem = Name des Problems
cli-score-format = Was die Standardausgabe erhält: summary (Vorgabe) oder json
cli-score-list = Die Probleme auflisten; mit einem Text nur die, in deren Namen, Reibung oder englischer Beschreibung er vorkommt
cli-score-times = Die Zeiten ausgeben, zu denen das Problem 36 Stellen enthält
cli-value-text = TEXT
cli-second-samples = „{ $argument }“ ist eine Datei zu viel: Nur eine Datei mit Werten ist erlaubt
score-lists-alone = --list steht allein, --times nur mit --problem; beide vertragen sich weder mit einer Datei noch mit --format
score-no-problem = --problem fehlt; erlaubt ist ein Name aus federpendel score --list
score-no-samples = Die Datei mit den Werten fehlt; erlaubt ist eine CSV-Datei mit den Spalten time und position, oder „-“ für die Standardeingabe
score-unknown-problem = --problem ist „{ $name }“, so heißt kein Problem; federpendel score --list zeigt die Namen
score-unknown-problem-near = --problem ist „{ $name }“, so heißt kein Problem; war { $nearest } gemeint?
score-none-listed = --list ist „{ $part }“; das kommt in keinem Namen, keiner Reibung und keiner Beschreibung vor; federpendel score --list zeigt alle
score-beyond = { $file }: { $reason }
samples-not-utf8 = { $place }: Diese Zeile ist kein UTF-8; erlaubt ist UTF-8-Text
samples-empty = { $place } ist leer; erlaubt sind eine Kopfzeile mit den Spalten time und position und Zeilen mit Zahlen darunter
samples-no-rows = { $place } hat eine Kopfzeile, aber keine Werte; mindestens eine Zeile mit Zahlen muss folgen
samples-missing-column = { $place }: In der Kopfzeile „{ $header }“ fehlt die Spalte { $name }; sie darf { $name } oder { $short } heißen
samples-column-twice = { $place }: Die Spalte { $column } steht zweimal in der Kopfzeile; erlaubt ist einmal
samples-unit = { $place }: Die Einheit der Spalte { $column } ist „{ $unit }“; erlaubt ist { $allowed }
samples-cells = { $place }: Diese Zeile hat { $found } Zellen, die Kopfzeile { $expected }; erlaubt sind gleich viele, und Dezimalkommas nur mit Semikolons zwischen den Zellen
samples-no-number = { $place }: { $column } ist „{ $value }“; erlaubt ist eine Zahl
samples-not-finite = { $place }: { $column } ist „{ $value }“; erlaubt ist eine endliche Zahl, dem Betrag nach höchstens { $largest }
samples-negative-time = { $place }: { $column } ist „{ $value }“; erlaubt ist 0 oder größer
score-of-amplitude = { $error } der Amplitude
score-of-speed = { $error } von ω₀ mal Amplitude
score-agrees = Die Werte stimmen mit der exakten Bewegung auf Rundung genau überein.
score-sentence = Die Werte weichen von der exakten Bewegung um bis zu { $error } ab, am meisten bei { $time }.
score-rest-sticks = Nach der Ruhe bei { $time } stehen sie still.
score-rest-creeps = Nach der Ruhe bei { $time } kriechen sie weiter, mit { $speed }.
score-rest-moves = Nach der Ruhe bei { $time } bewegen sie sich weiter, in einem Bereich von { $range }.
score-rest-unknown = Nach der Ruhe bei { $time } liegen zu wenige von ihnen, um zu sagen, ob sie stillstehen.
score-problem = Problem
score-samples = Werte
score-samples-value = { $samples }, der letzte bei { $time }
score-position = Auslenkung
score-velocity = Geschwindigkeit
score-errors-value = größter Fehler { $error }, bei { $time }; quadratisches Mittel { $mean }
score-last = Fehler des letzten Werts
score-stored = gegen die Referenzziffern
score-stored-value =
    höchstens { $error }, zu { $samples ->
        [one] einer Zeit mit Referenzwert
       *[other] { $samples } Zeiten mit Referenzwert
    }
score-bound = Bewegung bekannt auf

### Die Behauptungen des Artikels

cli-article = Die Behauptungen des Artikels an einem Versuch nachrechnen und den Bericht schreiben
cli-article-examples =
    Beispiele:
      federpendel article -o artikel.html
      federpendel article mein.toml --lang de -o artikel.html
      federpendel article --worksheet -o arbeitsblatt.html
      federpendel article --stiffness "1 N/m" --details
      federpendel article --format json > pruefungen.json
cli-article-output = Datei, deren Endung die Form bestimmt: { $forms }; auch mehrfach
cli-article-format = Was die Standardausgabe erhält: summary (Vorgabe) oder json
cli-article-worksheet = Die Urteile der Seite für eine Klasse frei lassen; die Lösungen stehen in einer zweiten Datei daneben
cli-article-claims = Nur diese Behauptungen auf die Seite setzen, nach ihren Nummern: 43-47,54 (Vorgabe: alle)
cli-article-no-page = --worksheet braucht eine Datei mit der Endung .html: -o arbeitsblatt.html
cli-article-no-claim = --claims ist „{ $value }“; erlaubt sind Nummern von 1 bis { $last } und Bereiche wie 43-47, durch Kommas getrennt
cli-article-claims-without-page = --claims wählt, was auf der Seite steht; dazu gehört eine Datei mit der Endung .html
cli-article-details = Zu jeder Behauptung sagen, was berechnet und gefunden wurde

### Aufzeichnungen

cli-fit = Aufzeichnungen einer freien Schwingung anpassen: welche Reibung wirkt, wie stark, wie sicher
cli-fit-examples =
    Beispiele:
      federpendel fit aufzeichnung.csv -o bericht.html
      federpendel fit phyphox.zip --value "Acceleration y" --details
      federpendel fit *.txt --format json > anpassungen.json
      federpendel fit aufzeichnung.csv --laws stokes,coulomb -o anpassung.svg -o anpassung.json
cli-value-recordings = AUFZEICHNUNG…
cli-value-column = SPALTE
cli-value-unit = EINHEIT
cli-fit-recordings = Dateien, wie Messprogramme sie schreiben: Text mit Kommas, Semikolons, Tabulatoren oder Leerzeichen, .zip, .xlsx, .xls
cli-fit-time = Spalte der Zeiten, nach Überschrift, Name oder Nummer (Vorgabe: die, die in der Kopfzeile so heißt)
cli-fit-value = Spalte der Werte (Vorgabe: die Komponente, die am stärksten schwingt)
cli-fit-quantity = Was die Werte sind: position (Auslenkung), velocity (Geschwindigkeit) oder acceleration (Beschleunigung); Vorgabe: was Einheit oder Name sagen
cli-fit-unit = Einheit der Werte, was auch immer die Datei sagt (Tracker nennt keine): m, cm, rad, m/s, g …
cli-fit-rate = Messwerte je Sekunde, für eine Datei ohne Zeiten: „50 Hz“
cli-fit-run = Der Durchlauf, wenn eine Datei mehrere enthält (Vorgabe: alle)
cli-fit-table = Tabellenblatt einer Mappe oder Datei einer .zip, wenn sie mehrere enthält
cli-fit-laws = auto (Vorgabe): die Gesetze, die sich zeigen; none: keine Reibung; oder das Gemisch, das angepasst werden soll, eine Liste aus stokes, coulomb, newton
cli-fit-from = Wann der angepasste Teil beginnt (Vorgabe: wo die freie Schwingung beginnt)
cli-fit-to = Wann er endet (Vorgabe: wo sich die Masse nicht mehr bewegt)
cli-fit-sigma = Standardabweichung eines Werts, wenn bekannt („1 mm“ oder eine Zahl in der Einheit der Werte); χ² ist in ihr gemessen
cli-fit-output = Datei, deren Endung die Form bestimmt: { $forms }; auch mehrfach
cli-fit-intervals = Wie die 95-%-Intervalle bestimmt werden: profile (Vorgabe, aus Profilen der Fehlerquadratsumme), covariance (aus Standardfehlern) oder bootstrap (Anpassungen an neu gezogene Residuen)
cli-fit-loss = Wie Residuen zählen: squares (Vorgabe, als Quadrate) oder huber oder tukey, die sich von Ausreißern nicht beirren lassen
cli-fit-format = Was die Standardausgabe bekommt: summary (Vorgabe, kurz gefasst), csv (eine Zeile je Aufzeichnung) oder json

### Die Seite

cli-serve = Die Seite zeigen: die Masse ziehen, die Bilder sehen, eine Aufzeichnung auswerten; nichts verlässt diesen Rechner
cli-serve-examples =
    Beispiele:
      federpendel serve
      federpendel serve --port 8080 --no-open
cli-serve-port = Port, auf dem die Seite zu finden ist; wenn nicht angegeben, irgendein freier
cli-serve-no-open = Den Browser nicht öffnen
serve-address = Die Seite steht unter { $address }; Strg+C beendet sie.
serve-no-page = dieses Programm ist ohne die Seite gebaut; web/build stellt sie mit Node und npm her, und cargo run --release --features page -- serve zeigt sie
serve-no-port = --port ist { $value }; erlaubt ist eine ganze Zahl von 1 bis 65535
serve-port-taken = --port ist { $port }, was nicht geht: { $problem }
serve-no-browser = Es ließ sich kein Browser öffnen; geben Sie die Adresse in einen ein.
