# Was das Programm sagt. Der Ordner en enthält dieselben Namen mit denselben Variablen.

### Begriffe des Fachs

term-turning-point = Umkehrpunkt

### Anführungszeichen um das, was eingegeben wurde

quoted = „{ $text }“

### Anzahlen

count-swings = { $swings ->
    [one] { $swings } Halbschwingung
   *[other] { $swings } Halbschwingungen
}

### Größen, die man angibt: wie jede heißt, und eine Zeile, die sagt, was sie ist

parameter-mass = Masse
    .description = Masse des Körpers
parameter-stiffness = Federkonstante
    .description = Federkonstante: Kraft je Länge
parameter-gravity = Fallbeschleunigung
    .description = Fallbeschleunigung, die die Masse auf ihre Führung drückt
parameter-normal-force = Normalkraft
    .description = Kraft, die die Masse auf ihre Führung drückt, statt der Fallbeschleunigung angegeben
parameter-damping = Dämpfung
    .description = Dämpfung der Stokesschen (viskosen) Reibung: Kraft je Geschwindigkeit
parameter-kinetic = Gleitreibungszahl
    .description = Gleitreibungszahl der Coulombschen (trockenen) Reibung
parameter-static = Haftreibungszahl
    .description = Haftreibungszahl der Coulombschen (trockenen) Reibung, mindestens die Gleitreibungszahl
parameter-density = Dichte
    .description = Dichte des Mediums, in dem die Newtonsche Reibung wirkt
parameter-drag-coefficient = Widerstandsbeiwert
    .description = Widerstandsbeiwert des Körpers für die Newtonsche Reibung
parameter-area = Stirnfläche
    .description = Stirnfläche des Körpers für die Newtonsche Reibung
parameter-newton-coefficient = Newtonscher Reibungskoeffizient
    .description = Koeffizient der Newtonschen (quadratischen) Reibung: Kraft je Geschwindigkeitsquadrat
parameter-position = Auslenkung
    .description = Auslenkung beim Loslassen, von der entspannten Lage der Feder aus; hängend: von der Ruhelage aus
parameter-velocity = Geschwindigkeit
    .description = Geschwindigkeit beim Loslassen
parameter-duration = Dauer
    .description = Länge der Aufzeichnung
parameter-samples = Abtastwerte
    .description = Anzahl der Abtastwerte der Aufzeichnung, beide Enden mitgezählt
parameter-dt = Zeitschritt
    .description = Zeitschritt eines numerischen Verfahrens
parameter-tolerance = Toleranz
    .description = Fehler, den ein Verfahren mit Schrittweitensteuerung in einem Schritt machen darf, bezogen auf die Amplitude
parameter-width = Breite der geglätteten Reibung
    .description = Geschwindigkeit, über die geglättete Reibung den Sprung der trockenen ersetzt
parameter-time = Zeit
    .description = Zeitpunkt, für den nach der Bewegung gefragt wird

### Messwerte

measured-interval = { $low } bis { $high }

### Größen, die aus den angegebenen folgen

derived-angular-frequency = Kreisfrequenz ohne Reibung
summary-period = Periode
summary-period-small = Periode bei kleinen Ausschlägen
derived-frequency = Frequenz
derived-damping-rate = Abklingrate
derived-offset = Verschiebung durch die Coulombsche Reibung
derived-sticking-offset = halbe Breite des Haftbereichs
derived-newton-rate = Rate der Newtonschen Reibung
derived-acceleration = Beschleunigung
derived-amplitude = Amplitude
derived-energy = Energie

### Was erlaubt ist

range-positive = eine endliche Zahl größer als 0
range-non-negative = eine endliche Zahl, 0 oder größer
range-finite = eine endliche Zahl
range-fraction = eine Zahl größer als 0 und kleiner als 1
range-count-from-two = eine ganze Zahl, 2 oder größer

### Fehler des Kerns

error-parameter = { $name } ist { $value }; erlaubt ist { $allowed }
error-static-below-kinetic = { $name } ist { $static }; erlaubt ist mindestens die Gleitreibungszahl (kinetic), { $kinetic }
error-no-normal-force = { $name } ist { $value }; die Coulombsche Reibung braucht eine Normalkraft größer als 0
error-magnitude = { $name } ist { $value }; erlaubt sind Beträge von { $smallest } bis { $largest }
error-derived = { $fields }: aus den angegebenen Werten folgt { $quantity } = { $value }; erlaubt sind Beträge von { $smallest } bis { $largest }
error-drag-too-strong = Die Newtonsche Reibung ist zu stark: Rate κ mal Amplitude ist { $value }; erlaubt ist höchstens { $limit }
error-too-many-swings = { $name } ist { $time }; diese Bewegung lässt sich bis { $reached } verfolgen ({ $swings ->
    [one] { $swings } Halbschwingung
   *[other] { $swings } Halbschwingungen
})
error-length = { $name } hat { $found ->
    [one] { $found } Element
   *[other] { $found } Elemente
}; nötig sind { $expected }
error-order = { $name } enthält { $value } nach { $before }; erlaubt ist eine Reihenfolge, die nicht fällt
error-no-such-solution = Im Artikel gilt die Lösung { $solution } hier nicht; die Dämpfung ist: { $regime }
solution-overdamped = für den Kriechfall
solution-critical = für den aperiodischen Grenzfall
error-no-phase = Auslenkung und Geschwindigkeit sind 0; eine Phase (Gleichung 77 des Artikels) braucht eine von 0 verschiedene
error-diverged = { $name } ist { $step }; damit läuft das Verfahren bei { $time } davon, ein kleinerer Schritt kann halten
error-too-many-steps = { $name } ist { $step }; bis { $time } sind das { $steps } Schritte, höchstens { $limit } werden gerechnet
error-not-in-article = Der Artikel löst die Bewegung ohne Reibung, mit Stokesscher oder mit Coulombscher Reibung; diese nicht: { $mix }

### Welche Reibung wirkt

mix-none = ohne Reibung
mix-stokes = Stokessche Reibung
mix-coulomb = Coulombsche Reibung
mix-newton = Newtonsche Reibung
mix-stokes-coulomb = Stokessche und Coulombsche Reibung
mix-stokes-newton = Stokessche und Newtonsche Reibung
mix-coulomb-newton = Coulombsche und Newtonsche Reibung
mix-all = Stokessche, Coulombsche und Newtonsche Reibung

### Wie stark die Stokessche Reibung dämpft

regime-undamped = ungedämpft
regime-underdamped = Schwingfall
regime-critical = aperiodischer Grenzfall
regime-overdamped = Kriechfall
regime-sentence-underdamped = Das ist der Schwingfall: Dämpfungsgrad { $ratio }.
regime-sentence-critical = Das ist der aperiodische Grenzfall.
regime-sentence-overdamped = Das ist der Kriechfall: Dämpfungsgrad { $ratio }.

### Woher man die Bewegung kennt

kind-closed-form = exakt, in geschlossener Form
kind-first-integral = exakte Umkehrpunkte, aus einem ersten Integral
kind-series = Reihe, auf Rundung genau
motion-exact = exakte Bewegung
motion-to-rounding = Bewegung, auf Rundung genau

### Wie die Bewegung endet

outcome-rests = kommt nach { $swings ->
    [one] { $swings } Halbschwingung
   *[other] { $swings } Halbschwingungen
} zur Ruhe, bei { $time }, { $distance } von der Mitte
outcome-rests-at-once = bleibt dort in Ruhe, wo sie losgelassen wird, { $distance } von der Mitte
outcome-creeps = kriecht ohne Ende auf eine Stelle { $distance } von der Mitte zu
outcome-creeps-to-centre = kriecht ohne Ende auf die Mitte zu
outcome-swings = schwingt ohne Ende
outcome-decays = schwingt immer schwächer weiter, ohne je ganz zur Ruhe zu kommen
outcome-unknown = schwingt nach { $swings ->
    [one] { $swings } Halbschwingung
   *[other] { $swings } Halbschwingungen
}, { $time }, noch immer; weiter wurde nicht verfolgt, ob sie je zur Ruhe kommt

### Abbildungen

plot-axis = { $name } { $symbol } in { $unit }
plot-axis-pure = { $name } { $symbol }
plot-time = Zeit
plot-position = Auslenkung
plot-exact-motion = Exakte Bewegung
plot-motion-to-rounding = Bewegung (auf Rundung genau)
plot-envelope = Einhüllende
plot-turning-points = Umkehrpunkte
plot-rest = Ruhe: { $time }, { $position }
plot-sticking-band = Haftbereich ±{ $offset }

### Größen, wie man sie schreibt

dimension-mass = eine Masse
dimension-length = eine Länge
dimension-time = eine Zeit
dimension-force = eine Kraft
dimension-stiffness = eine Federkonstante
dimension-damping = eine Dämpfung
dimension-mass-per-length = eine Masse je Länge
dimension-velocity = eine Geschwindigkeit
dimension-acceleration = eine Beschleunigung
dimension-density = eine Dichte
dimension-area = eine Fläche
dimension-number = eine reine Zahl
dimension-frequency = eine Frequenz
dimension-volume = ein Volumen
dimension-energy = eine Energie
dimension-power = eine Leistung
dimension-pressure = ein Druck
quantity-empty = es fehlt die Angabe
quantity-too-long = die Angabe hat { $length } Bytes, mehr als { $limit }
quantity-no-number = am Anfang steht keine Zahl
quantity-ambiguous = die Zahl kann { $decimal } oder { $grouped } bedeuten; für das eine bitte { $comma } (oder { $point }) schreiben, für das andere { $grouped }
quantity-grouped = Zahlen schreibt man hier ohne Tausendertrennzeichen, etwa { $plain }
quantity-not-finite = das ist keine endliche Zahl
quantity-overflow = die Zahl ist zu groß für doppelte Genauigkeit
quantity-underflow = die Zahl ist nicht null, aber zu klein für doppelte Genauigkeit
quantity-unknown-unit = die Einheit „{ $unit }“ ist unbekannt
quantity-unknown-unit-near = die Einheit „{ $unit }“ ist unbekannt, die ähnlichste ist „{ $nearest }“
quantity-unit-grammar = „{ $unit }“ lässt sich nicht als Einheit lesen
quantity-wrong-dimension = „{ $unit }“ ist die Einheit einer anderen Größe: { $found }
quantity-nameless-dimension = „{ $unit }“ ist die Einheit einer anderen Größe

### Versuche, die abgelehnt werden

experiment-refusal = { $name } ist { $value }; erlaubt ist { $allowed }
experiment-quantity = { $name } ist { $value }: { $problem }; erlaubt ist { $allowed }

### Die Zusammenfassung

summary-sentence = Die Masse { $outcome }.
summary-tie = Ihre letzte Halbschwingung endet auf der Kante des Haftbereichs; im Rahmen der Rundung der angegebenen Zahlen haftet sie dort.
summary-tie-at-release = Losgelassen wird sie auf der Kante des Haftbereichs; im Rahmen der Rundung der angegebenen Zahlen haftet sie dort.
summary-none = keine
derived-damping-ratio = Dämpfungsgrad
derived-quality-factor = Gütefaktor
derived-logarithmic-decrement = logarithmisches Dekrement
remark-equation = Gleichung ({ $number }) des Artikels
remark-scheme = Das Verfahren
remark-sticks-at-once = { $method } kennt kein Haften und lässt die Masse schwingen, die in Wirklichkeit dort bleibt, wo sie losgelassen wird.
remark-no-sticking = { $method } kennt kein Haften und läuft weiter, wo die Masse schon zur Ruhe gekommen ist.
remark-wrong-decay = { $method } lässt die Amplitude mit einer um den Faktor C falschen Rate fallen und läuft weiter, wenn die Masse schon haftet.
remark-grows = { $method } gilt nur für x0 > 0: Hier, bei x0 < 0, wächst ihre Amplitude, statt zu fallen.
remark-wrong-phase = { $method } verliert bei v0 < 0, wie hier, den Quadranten der Phase und beginnt auf der falschen Seite.
remark-wrong-phase-and-decay = { $method } verliert bei v0 < 0, wie hier, den Quadranten der Phase, und ihr Abklingen ist um den Faktor C falsch.
remark-only-at-turning-points = { $method } trifft die exakte Bewegung nur in den Umkehrpunkten und kennt kein Haften.
remark-misses-turning-points = { $method } verfehlt bei v0 ≠ 0, wie hier, selbst die Umkehrpunkte und kennt kein Haften.
remark-chatters = { $method } kennt keine Haftreibung: Es kommt nie zur Ruhe, sondern rattert, vor und zurück mit jedem Schritt, und kriecht.
remark-first-order = { $method } ist wegen des rückwärtigen Differenzenquotienten von erster Ordnung: Der halbe Schritt halbiert den Fehler.
remark-second-order = { $method } ist hier, ohne Reibung, von zweiter Ordnung: Der halbe Schritt lässt ein Viertel des Fehlers.

### Weitere Bilder

plot-motion = Bewegung
plot-speed = Geschwindigkeit
plot-release = Loslassen: { $position }, { $velocity }
plot-phase-rest = Ruhe: { $position }
plot-energy = Energie
plot-energy-kinetic = Kinetisch
plot-energy-potential = Potentiell
plot-energy-stokes = Wärme der Stokesschen Reibung
plot-energy-coulomb = Wärme der Coulombschen Reibung
plot-energy-newton = Wärme der Newtonschen Reibung
plot-mean-amplitude = Mittlere Amplitude
plot-loss = Abnahme je Halbschwingung
plot-decrement-title = Abnahme der Amplitude, { $mix }
plot-decrement-swings = Halbschwingungen
measured-swings = Mittel von bis zu { $count } Halbschwingungen
plot-decrement-some = Halbschwingungen (1 von { $stride })
plot-decrement-law = Gemitteltes Gesetz { $formula }
plot-decrement-coulomb = Achsenabschnitt 2f = { $value } (Coulomb)
plot-decrement-stokes = Steigung πγ/ω₀ = { $value } (Stokes)
plot-decrement-newton = Krümmung (4/3)κ = { $value } (Newton)
plot-decrement-empty = Keine Halbschwingung: Es sind weniger als zwei Amplituden bekannt
plot-decrement-description =
    { $title }: { $swings ->
        [one] Eine Halbschwingung verliert
       *[other] { $swings } Halbschwingungen verlieren
    } jeweils zwischen { $least } und { $most }, bei mittleren Amplituden bis { $largest }. Die Linie ist das gemittelte Gesetz { $formula }.
plot-error = Fehler
plot-time-step = Zeitschritt

### Verfahren neben der exakten Bewegung

compare-sticks = haftet
compare-creeps = kriecht { $speed }
compare-goes-on = schwingt weiter
error-step-underflow = bei { $time } ist der Schritt auf { $step } geschrumpft, womit die Zeit nicht mehr vorankommt; eine größere Toleranz kann halten
error-step-limit = bei { $time } waren die { $limit } erlaubten Schritte verbraucht

### Werte anderer Programme gegen die Referenzprobleme

samples-too-large = { $place } ist zu groß; erlaubt sind { $limit } Bytes

### Aufzeichnungen

plot-recorded = Aufgezeichnet
plot-not-fitted = Aufgezeichnet, nicht angepasst
plot-fit = Anpassung
plot-residual = Aufzeichnung minus Anpassung
plot-recording-description = { $title }: { $samples } Werte über { $duration }, zwischen { $lowest } und { $highest }, und die angepasste Bewegung.
plot-residuals-description = Was die Anpassung übrig lässt, mit einem quadratischen Mittel von { $rms }.
fit-title = { $name }: { $quantity }
fit-quantity-position = Auslenkung
fit-quantity-velocity = Geschwindigkeit
fit-quantity-acceleration = Beschleunigung
fit-parameter-angular-frequency = Kreisfrequenz ω₀
fit-parameter-damping-rate = Dämpfungsparameter γ (Stokes)
fit-parameter-coulomb-acceleration = trockene Reibung je Masse a_c (Coulomb)
fit-parameter-newton-rate = Widerstand je Masse κ (Newton)
fit-parameter-position0 = Auslenkung am Anfang
fit-parameter-velocity0 = Geschwindigkeit am Anfang
fit-parameter-equilibrium = Nullpunkt der Skala
fit-parameter-static-acceleration = Haftreibung je Masse
fit-row-frequency = Eigenfrequenz
fit-row-damping-ratio = Dämpfungsgrad
    .viscous = viskoser Dämpfungsgrad
fit-row-equivalent = gleichwertiger Dämpfungsgrad
fit-range = { $first } bis { $last }
fit-range-at = { $values } ({ $from } bis { $to })
fit-row-window = angepasster Teil
fit-window-value = { $from } bis { $to }, { $samples } Werte
fit-row-residual = Residuum (quadratisches Mittel)
fit-row-begins = Grund des Anfangs
fit-row-ends = Grund des Endes
fit-row-column = Spalte
fit-row-reduced = reduziertes χ²
fit-unit-nameless = die der Aufzeichnung, die keine nennt
fit-row-unit = Einheit u
fit-row-chi = χ²

### Versuche der Seite

preset-article-stokes = Stokes, Verfahren und Lösung (Graph des Artikels)
preset-article-coulomb = Coulomb, Verfahren (Graph des Artikels)
preset-article-coulomb-formula = Coulomb, Formel und Verfahren (Graph des Artikels)
preset-article-coulomb-thrown = Coulomb, angestoßen (Graph des Artikels)
preset-article-newton = Newton (Graph des Artikels)
preset-block-on-table = Ein Klotz auf dem Tisch
preset-card-in-air = Eine Karte in Luft
preset-heavy-oil = Zähes Öl
preset-all-three = Alle drei zugleich

### Was die Fehlerlupe sagt

lens-error = Größter Abstand von der Bewegung: { $error }.
lens-rounding = Größter Abstand von der Bewegung: { $error }; das ist nur Rundung.
lens-order = Der halbe Schritt teilt den Fehler hier durch { $factor }: Ordnung { $observed }; versprochen ist Ordnung { $declared }, solange die Kraft nicht springt.
lens-no-order = Kürzere Schritte zeigen hier keine Ordnung; versprochen ist Ordnung { $declared }, solange die Kraft nicht springt.
lens-sticks = Wo die Masse zur Ruhe gekommen ist, ruht auch diese Kurve.
lens-creeps = Wo die Masse zur Ruhe gekommen ist, kriecht diese Kurve mit { $speed } weiter.
lens-goes-on = Wo die Masse zur Ruhe gekommen ist, schwingt diese Kurve weiter.
