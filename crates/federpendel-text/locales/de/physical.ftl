# Physikalische Größen einer Anpassung, und was neben der Aufzeichnung gemessen wurde. Der Ordner en enthält dieselben Namen mit denselben Variablen.

### Zeilen und Sätze

physical-row-moving-mass = bewegte Masse M = m + m_s/3
physical-row-coulomb-force = Kraft der trockenen Reibung F_c
physical-row-agreement = C/M nach den Angaben
physical-row-equivalent = gleichwertiger Dämpfungsgrad bei { $amplitude }
physical-more = um { $percent } % größer als ω₀² ({ $deviation } Standardabweichungen)
physical-less = um { $percent } % kleiner als ω₀² ({ $deviation } Standardabweichungen)
physical-contradicts = Masse und Federkonstante passen nicht zur Aufzeichnung: C/M ist { $difference }. Alles Weitere ist aus der Masse berechnet.
physical-contradicts-spring = Masse und Federkonstante passen nicht zur Aufzeichnung: C/M ist { $difference }. Fehlt die Masse der Feder? Alles Weitere ist aus der Masse berechnet.
physical-weight = Als Normalkraft der Reibungszahlen gilt das Gewicht des Körpers allein, auf einer waagrechten Führung, die die Feder nicht trägt.
physical-absent-angle = Die Aufzeichnung enthält Winkel; Masse und Feder einer geradlinigen Bewegung haben dafür keine Bedeutung, daher fehlen Kräfte und Massen.
physical-absent-mass = Für Kräfte und Massen muss die Masse des Körpers oder die Federkonstante angegeben sein.
physical-absent-normal-force = Reibungszahlen fehlen, weil nicht angegeben ist, was den Körper auf eine Führung drückt; bei einem hängenden Körper gibt es keine solche Kraft.
physical-absent-spring-mass = Ein Drittel der Federmasse ist mehr, als sich nach Federkonstante und Frequenz insgesamt bewegt; daher fehlt die Masse des Körpers.
physical-absent-length = Die Aufzeichnung misst Längen in { $unit }; für Kräfte, Reibungszahlen und den Widerstand sind Meter nötig: --unit m, cm oder mm sagt, worin ihre Längen stehen.
    .page = Die Aufzeichnung misst Längen in { $unit }; für Kräfte, Reibungszahlen und den Widerstand sind Meter nötig: Geben Sie als Einheit der Werte etwa m, cm oder mm an.
physical-absent-unit = Die Aufzeichnung nennt keine Einheit: Massen, Federkonstante und Dämpfung gelten nur, wenn sie Längen und keine Winkel misst, und für Kräfte, Reibungszahlen und den Widerstand sind Meter nötig: --unit m, cm oder mm sagt, worin ihre Längen stehen.
    .page = Die Aufzeichnung nennt keine Einheit: Massen, Federkonstante und Dämpfung gelten nur, wenn sie Längen und keine Winkel misst, und für Kräfte, Reibungszahlen und den Widerstand sind Meter nötig: Geben Sie als Einheit der Werte etwa m, cm oder mm an.

### Was angegeben wird

physical-help-heading = Neben der Aufzeichnung gemessen, etwa "250(1) g" oder "12,0 ± 0,3 N/m"
physical-horizontal-twice = --normal-force ist { $value }, aber mit --horizontal ist schon das Gewicht die Normalkraft; nur eines von beiden darf angegeben sein
physical-gravity-alone = --gravity ist { $value }; erlaubt ist es nur zusammen mit --horizontal
quantity-uncertainty-negative = die Unsicherheit ist negativ
quantity-uncertainty-unit = der Wert hat eine Einheit, seine Unsicherheit keine; die Einheit steht einmal am Ende oder bei beiden
quantity-uncertainty-grammar = das ist kein Wert mit einer Unsicherheit wie 250(1) g, 12,0 ± 0,3 N/m oder (12,0 ± 0,3) N/m

### Was eine Anpassung neben ihren Werten sagt

fit-window-reversed = { $begin } ist { $from } und { $end } ist { $to }; erlaubt ist ein { $begin } vor { $end }
    .page = Der angepasste Teil würde bei { $from } beginnen und bei { $to } enden; erlaubt ist ein Ende nach dem Anfang
plot-residual-axis = Residuum
physical-bare-number = { $name } hat keine Einheit: Angenommen wird { $value }.
quantity-uncertainty-large = die Unsicherheit ist größer als der halbe Wert, zu groß für eine Fortpflanzung auf andere Zahlen
fit-row-plus-minus = ±
fit-plus-minus = ein Standardfehler
physical-hint = Mit --mass folgen auch Federkonstante, D und Kräfte.
    .guided = Mit --mass folgen auch Federkonstante, D und Kräfte; mit --horizontal, für einen Körper auf waagrechter Führung, auch μ.
    .page = Mit einer Masse bei „Angaben zum Versuch“ folgen auch Federkonstante, D und Kräfte, mit der Kraft auf die Führung auch μ.
