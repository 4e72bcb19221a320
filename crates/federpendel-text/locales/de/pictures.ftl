# Was nur Programme sagen und zeichnen: die Seite hat eigene Bilder. Der Ordner en enthält dieselben Namen mit denselben Variablen.

### Bilder

plot-motion-title = Federpendel, { $mix }
plot-motion-description = { $title }: Auslenkung über { $duration }, ab { $start } beim Loslassen, zwischen { $lowest } und { $highest }. Die Masse { $outcome }.
plot-comparison-description = Gestrichelt daneben: { $name }, zwischen { $lowest } und { $highest }.
plot-phase-title = Phasenbild, { $mix }
plot-phase-description = { $title }: Geschwindigkeit über der Auslenkung, ab { $position } und { $velocity } beim Loslassen; Auslenkungen zwischen { $lowest } und { $highest }, Geschwindigkeiten zwischen { $slowest } und { $fastest }. Die Masse { $outcome }.
plot-energy-title = Verbleib der Energie, { $mix }
plot-energy-description = { $title }: gestapelte Flächen über { $duration }; ihre Summe ist die Energie beim Loslassen, { $total }. Am Ende, von oben nach unten: { $parts }.
plot-energy-part = { $name } { $energy }
plot-errors-title = Fehler der Auslenkung, { $mix }
plot-errors-description = { $title }: Abstand von der exakten Bewegung über { $duration }, auf logarithmischer Achse. Größter Fehler: { $methods }.
plot-errors-method = { $name } { $error }
plot-largest-error = Größter Fehler
plot-steps = Schritte
plot-convergence-title = Größter Fehler über dem Zeitschritt, { $mix }
plot-convergence-description = { $title }, beide Achsen logarithmisch. { $methods }.
plot-convergence-method = { $name }: Ordnung { $order } laut Entwurf, { $observed } beobachtet, Fehler bis hinab zu { $error }
plot-convergence-unobserved = keine
plot-order = Ordnung
plot-order-observed = { $name } (p ≈ { $order })
plot-work-title = Größter Fehler über der Zahl der Schritte, { $mix }
plot-work-description = { $title }, beide Achsen logarithmisch. { $methods }.
plot-work-method = { $name }: { $error } mit { $steps } Schritten
plot-no-errors = Kein Fehler über null zu zeigen
plot-overlay-title = Bewegung und Verfahren, { $mix }
plot-overlay-last-swings = Die letzten Halbschwingungen, näher betrachtet
plot-overlay-last-periods = Die letzten zwei Perioden, näher betrachtet
plot-overlay-description = { $title }: Auslenkung über { $duration }, dazu der Abschnitt von { $from } bis { $until }, näher betrachtet. Die Masse { $outcome }. Auslenkung am Ende: { $methods }.
plot-beside-description = { $title }: Auslenkung über { $duration }. Die Masse { $outcome }. Auslenkung am Ende: { $methods }.
plot-after-rest-title = Nach dem Stillstand, { $mix }
plot-after-rest-none = In dieser Zeit kommt die Masse nicht zur Ruhe
plot-after-rest-description = { $title }: Auslenkung von { $from } bis { $until }, so hoch wie der Haftbereich ±{ $offset }. Die Masse ruht ab { $rest }. Auslenkung am Ende: { $methods }.
plot-courses-description = { $title }: Auslenkung über { $duration }. { $courses }.
plot-courses-course = { $name }: ab { $start }, zwischen { $lowest } und { $highest }, am Ende { $end }
plot-losses-title = Abnahme der Amplitude je Halbschwingung
plot-losses-description = { $title }, über der mittleren Amplitude. { $motions } Die Linien sind das gemittelte Gesetz.
plot-losses-motion =
    { $name }: { $swings ->
        [one] eine Halbschwingung kostet
       *[other] { $swings } Halbschwingungen kosten
    } zwischen { $least } und { $most }, bei mittleren Amplituden bis { $largest }; { $formula }.
plot-real-part = Realteil
plot-imaginary-part = Imaginärteil
plot-roots-title = Wurzeln der charakteristischen Gleichung
plot-roots-path = { $symbol } für γ von 0 bis { $most } ω₀
plot-roots-marks = Markierte γ
plot-roots-own = Dieser Versuch, γ = { $gamma }
plot-roots-own-pair = Dieser Versuch, γ = { $gamma } 1/s: λ = ({ $real } ± { $imaginary } i) 1/s
plot-roots-own-real = Dieser Versuch, γ = { $gamma } 1/s: λ₁ = { $slow } 1/s, λ₂ = { $fast } 1/s
plot-roots-description = { $title } λ² + 2γλ + ω₀² = 0 in der komplexen Ebene, ω₀ = { $omega }. Für γ von 0 bis ω₀ laufen sie als konjugiertes Paar von ±iω₀ auf dem Kreis vom Radius ω₀ nach −ω₀, danach auf der reellen Achse auseinander, bei γ = { $most } ω₀ bis { $slow } und { $fast }. { $own }.

### Auf der Befehlszeile

output-too-many-points = Die Aufzeichnung von { $duration } enthält etwa { $number } Umkehrpunkte; in einer JSON-Datei stehen höchstens { $limit }. Erlaubt ist eine kürzere Dauer
article-solutions-file = -loesungen
article-hint = -o artikel.html schreibt den Bericht; --details zeigt hier jede Behauptung.
fit-laws-alone = --laws nennt „{ $value }“ neben anderen; es steht allein
fit-laws-refused = --laws nennt „{ $value }“; erlaubt sind auto, none, stokes, coulomb, newton
fit-pictures-of-one = Ein Bild zeigt eine Aufzeichnung; angepasst sind { $count }. Wähle eine Datei oder mit --run einen Durchlauf
fit-heading-models = Gemische, nach AICc
fit-heading-all-the-same = Das beste Gemisch trotzdem, zum Vergleich
fit-model-row = AICc { $aicc }, BIC { $bic }, Residuum { $rms }
fit-row-evaluations = Auswertungen des Modells
fit-stop-step-limit = beim letzten erlaubten Schritt
fit-stop-no-progress = kein Schritt senkte χ² weiter (ein Knick oder Sprung ist nahe)
fit-stop-converged = konvergiert
fit-row-stop = Ende der Suche
fit-row-bic = BIC
fit-row-aicc = AICc
fit-row-aic = AIC
fit-row-effective = wirksame Anzahl der Werte
fit-row-p-value = p-Wert ohne { $law }
fit-heading-correlations = Korrelationen ab { $floor }
fit-interval = { $value } (95 %: { $interval })

### Der Bericht über viele Aufzeichnungen

measured-colophon = Erstellt mit federpendel { $version }.
measured-title-many = Welche Reibung wirkt in { $count } Aufzeichnungen?
measured-title-some = Welche Reibung wirkt in { $count } von { $all } Aufzeichnungen?
measured-not-fitted = Nicht angepasst
measured-lead-one =
    { $adequate ->
        [0] Kein Gemisch Stokesscher, Coulombscher und Newtonscher Reibung beschreibt die eine angepasste Aufzeichnung.
       *[other] Ein Gemisch Stokesscher, Coulombscher und Newtonscher Reibung beschreibt die eine angepasste Aufzeichnung.
    }
measured-lead-many =
    { $adequate ->
        [0] Kein Gemisch Stokesscher, Coulombscher und Newtonscher Reibung beschreibt eine dieser { $count } Aufzeichnungen.
        [one] Ein Gemisch Stokesscher, Coulombscher und Newtonscher Reibung beschreibt eine dieser { $count } Aufzeichnungen.
       *[other] Ein Gemisch Stokesscher, Coulombscher und Newtonscher Reibung beschreibt { $adequate } dieser { $count } Aufzeichnungen.
    }
measured-summary = Übersicht
measured-summary-caption = Alle Aufzeichnungen: die Gesetze, die wirken, mit Standardfehlern, oder warum kein Gemisch die Bewegung beschreibt. Wo viskose Reibung nicht allein wirkt, sind Dämpfungsgrad und Gütefaktor die gleichwertigen von der ersten Amplitude bis zur letzten.
measured-head-recording = Aufzeichnung
measured-brief-mixes = Gemische nach AICc, mit dem Abstand vom besten: { $mixes }.
measured-brief-mix = { $mix } { $difference }
measured-brief-part = Angepasst: { $from } bis { $to }, { $samples } Werte ({ $effective } unabhängige), Spalte { $column }; Residuum (quadratisches Mittel) { $rms }.
measured-brief-edges = Dort beginnt es: { $begins }. Dort endet es: { $ends }.
