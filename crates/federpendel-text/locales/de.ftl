# Jeder deutsche Satz von federpendel. en.ftl enthält dieselben Namen mit denselben Variablen.

### Begriffe des Fachs

term-turning-point = Umkehrpunkt

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
    .description = Auslenkung beim Loslassen, von der entspannten Lage der Feder aus
parameter-velocity = Geschwindigkeit
    .description = Geschwindigkeit beim Loslassen
parameter-duration = Dauer
    .description = Länge der Aufzeichnung
parameter-samples = Abtastwerte
    .description = Anzahl der Abtastwerte der Aufzeichnung, beide Enden mitgezählt
parameter-dt = Zeitschritt
    .description = Zeitschritt eines numerischen Verfahrens
parameter-time = Zeit
    .description = Zeitpunkt, für den nach der Bewegung gefragt wird

### Größen, die aus den angegebenen folgen

derived-angular-frequency = Kreisfrequenz ohne Reibung
derived-damping-rate = Abklingrate
derived-offset = Verschiebung durch die Coulombsche Reibung
derived-sticking-offset = halbe Breite des Haftbereichs
derived-newton-rate = Rate der Newtonschen Reibung
derived-drag-strength = Stärke der Newtonschen Reibung (newton_rate mal Amplitude)
derived-amplitude = Amplitude
derived-energy = Energie

### Was erlaubt ist

range-positive = eine endliche Zahl größer als 0
range-non-negative = eine endliche Zahl, 0 oder größer
range-finite = eine endliche Zahl
range-count-from-two = eine ganze Zahl, 2 oder größer

### Fehler des Kerns

error-parameter = { $name } ist { $value }; erlaubt ist { $allowed }
error-static-below-kinetic = { $name } ist { $static }; erlaubt ist mindestens die Gleitreibungszahl (kinetic), { $kinetic }
error-no-normal-force = { $name } ist { $value }; die Coulombsche Reibung braucht eine Normalkraft größer als 0
error-derived = Aus den angegebenen Werten folgt { $quantity } = { $value }; es muss eine gewöhnliche endliche Zahl sein
error-derived-too-large = Aus den angegebenen Werten folgt { $quantity } = { $value }; das ist zu groß, um berechnet zu werden
error-too-many-swings = { $name } ist { $time }; diese Bewegung lässt sich bis { $reached } verfolgen ({ $swings ->
    [one] { $swings } Halbschwingung
   *[other] { $swings } Halbschwingungen
})
error-length = { $name } hat { $found ->
    [one] { $found } Element
   *[other] { $found } Elemente
}; nötig sind { $expected }
error-order = { $name } enthält { $value } nach { $before }; erlaubt ist eine Reihenfolge, die nicht fällt
error-no-such-solution = Die Lösung { $solution } des Artikels gilt hier nicht; die Dämpfung ist: { $regime }
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
regime-underdamped = schwach gedämpft
regime-critical = aperiodischer Grenzfall
regime-overdamped = stark gedämpft (Kriechfall)

### Woher man die Bewegung kennt

kind-closed-form = exakt, in geschlossener Form
kind-first-integral = exakte Umkehrpunkte, aus einem ersten Integral
kind-series = Reihe, bis auf Rundung

### Wie die Bewegung endet

outcome-rests = kommt nach { $swings ->
    [one] { $swings } Halbschwingung
   *[other] { $swings } Halbschwingungen
} zur Ruhe, bei { $time }, { $distance } von der Mitte
outcome-rests-at-once = bleibt dort in Ruhe, wo sie losgelassen wird, { $distance } von der Mitte
outcome-creeps = kriecht ohne Ende auf eine Stelle { $distance } von der Mitte zu
outcome-creeps-to-centre = kriecht ohne Ende auf die Mitte zu
outcome-swings = schwingt ohne Ende
outcome-unknown = schwingt nach { $swings ->
    [one] { $swings } Halbschwingung
   *[other] { $swings } Halbschwingungen
}, { $time }, noch immer; weiter wurde nicht verfolgt, ob sie je zur Ruhe kommt

### Abbildungen

plot-axis = { $name } { $symbol } in { $unit }
plot-axis-pure = { $name } { $symbol }
plot-time = Zeit
plot-position = Auslenkung
plot-envelope = Einhüllende
plot-turning-points = Umkehrpunkte
plot-rest = Ruhe: { $time }, { $position }
plot-sticking-band = Haftbereich ±{ $offset }
plot-motion-title = Federpendel, { $mix }
plot-motion-description = { $title }: Auslenkung über { $duration }, ab { $start } beim Loslassen, zwischen { $lowest } und { $highest }. Die Masse { $outcome }.
