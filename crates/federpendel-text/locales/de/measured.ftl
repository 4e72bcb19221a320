# Der Bericht einer Anpassung. Der Ordner en enthält dieselben Namen mit denselben Variablen.

measured-none = –

### Eine Aufzeichnung

measured-title = Welche Reibung wirkt in { $name }?

## Ergebnis

measured-result = Ergebnis
measured-fit-caption = { $name }: die Aufzeichnung mit der angepassten Bewegung eines Federpendels, { $mix }; darunter, was die Anpassung übrig lässt, aufgezeichnet minus angepasst.
measured-closest = Diese Werte gehören zum einfachsten Gemisch, das nicht verworfen ist: { $mix }. Da kein Gemisch diese Bewegung beschreibt, messen sie deren Reibung nicht.
measured-values-caption = Die angepassten Werte, auf ihre Unsicherheit gerundet.
measured-head-parameter = Parameter
measured-head-value = Wert ± Standardfehler
measured-head-interval = 95-%-Intervall
measured-head-unit = Einheit

## Dämpfung und physikalische Größen

measured-figures = Dämpfung und physikalische Größen
measured-head-quantity = Größe
measured-damping-text = Was andere Messungen Dämpfung nennen: Der Dämpfungsgrad ist der einer viskosen Reibung, die einer Periode mit dieser Amplitude gleich viel Energie entzieht, $\zeta_A = \gamma/\omega_0 + 2a_c/(\pi\omega_0^2 A) + 4\kappa A/(3\pi)$. Nur bei viskoser Reibung allein ist er bei jeder Amplitude gleich; die Güte ist $Q = 1/(2\zeta)$.
measured-damping-caption = Dämpfung, mit Standardfehlern.
measured-physical-caption = Physikalische Größen, mit Standardfehlern aus der Anpassung und aus dem, was daneben gemessen wurde.

## Abnahme der Amplitude

measured-loss = Abnahme der Amplitude je Halbschwingung
measured-loss-text = Wie viel Amplitude eine Halbschwingung kostet, unterscheidet die Gesetze. Die gleiche Abnahme bei jeder Amplitude, also Punkte auf gleicher Höhe, bedeutet trockene (Coulombsche) Reibung; eine Gerade durch null viskose (Stokessche) Reibung; eine Parabel quadratische (Newtonsche) Reibung. Wirken mehrere, addieren sich ihre Abnahmen.
measured-loss-caption = Die Punkte stammen allein aus den Umkehrpunkten der Aufzeichnung: die halbe Differenz zweier Weiten von Umkehrpunkt zu Umkehrpunkt, in der sich der Nullpunkt des Sensors aufhebt. Die Linie ist das gemittelte Gesetz { $law } mit den Werten der Tabelle oben; an die Punkte ist sie nicht angepasst.
measured-loss-velocity = Da eine Geschwindigkeit aufgezeichnet ist, stehen ihre Extremwerte, geteilt durch $\omega_0$, für die Amplituden; das ist richtig, solange eine Halbschwingung nur einen kleinen Teil ihrer Amplitude verliert.
measured-loss-acceleration = Da eine Beschleunigung aufgezeichnet ist, stehen ihre Extremwerte, geteilt durch $\omega_0^2$, für die Amplituden; das ist richtig, solange eine Halbschwingung nur einen kleinen Teil ihrer Amplitude verliert. Der Sprung, den trockene Reibung an den Umkehrpunkten macht, kann die Amplituden um bis zu $f$ verschieben, ihre Abnahme nicht.
measured-loss-none = Für ein Bild der Abnahmen hat die Aufzeichnung zu wenige Umkehrpunkte.

## Gemische

measured-mixes = Welches Gemisch der Gesetze?
measured-mixes-text =
    { $count ->
        [one] Ein Gemisch war erlaubt und wurde angepasst.
       *[other] Angepasst wurden { $count } Gemische der Gesetze. Das Urteil ist das einfachste Gemisch, das nicht verworfen ist; verworfen ist ein Gemisch, wenn eines mit weiteren Gesetzen so viel besser passt, dass der Zufall das seltener als einmal unter hundert bewirkt ($p$ < 0,01). AICc und BIC wägen ab, wie gut ein Gemisch passt und wie viele Parameter es braucht: Kleiner ist besser, und Unterschiede unter 2 bedeuten wenig.
    }
measured-mixes-caption = Die Gemische, nach AICc. AICc und BIC sind als Abstand vom besten angegeben; $p$ ist die Wahrscheinlichkeit, dass allein durch Zufall ein größeres Gemisch um so viel besser passt. Das Residuum ist das quadratische Mittel dessen, was übrig bleibt.
measured-verdict = { $mix } (Urteil)
measured-nearest = { $mix } (einfachstes nicht verworfenes)
measured-head-mix = Gemisch
measured-head-aicc = ΔAICc
measured-head-bic = ΔBIC
measured-head-rms = Residuum
measured-head-p = p
measured-below = < { $value }

## Unsicherheit

measured-uncertainty = Wie sicher sind die Werte?
measured-uncertainty-text = Die Standardfehler folgen daraus, wie schnell die Summe der Quadrate um ihr Minimum wächst, und aus den Residuen selbst.
measured-uncertainty-effective = Residuen, deren Nachbarn zusammenhängen, zählen weniger: Diese { $samples } Werte sagen so viel wie { $effective } unabhängige.
measured-correlations-caption = Korrelationen der angepassten Werte. Nahe bei 1 oder −1 unterscheidet die Aufzeichnung zwei Werte kaum: Ändert sich der eine, gleicht der andere das aus.
measured-correlations-largest = Am größten ist die von { $one } und { $other }: { $value }.
measured-symbol-zero = Nullpunkt
measured-statistics-caption = Statistik der Anpassung.
measured-head-statistic = Größe
measured-head-number = Wert
measured-samples = Anzahl der Werte, n
measured-effective = wirksame Anzahl der Werte
measured-fitted = angepasste Parameter
measured-evaluations = Berechnungen des Modells, alle Gemische
measured-stop = Die Suche endete, weil
measured-stop-converged = kein weiterer Schritt die Summe der Quadrate verkleinern würde
measured-stop-no-progress = kein Schritt die Summe der Quadrate mehr verkleinerte, obwohl es zu erwarten war
measured-stop-step-limit = die größte Zahl von Schritten erreicht war

## Was gelesen wurde

measured-reading = Was gelesen und angepasst wurde
measured-reading-caption = Die Aufzeichnung und der Teil von ihr, der angepasst ist.
measured-head-what = Was
measured-head-said = Gefunden
measured-file = Datei
measured-run = Durchgang
measured-values-column = Spalte der Werte
measured-times-column = Spalte der Zeiten
measured-rate = gleichmäßige Zeiten mit der Rate
measured-quantity = Größe
measured-unit = Einheit
measured-unit-none = keine angegeben
measured-length = ganze Aufzeichnung
measured-length-value = { $from } bis { $to }, { $samples } Werte
measured-rest = Ruhe
measured-rest-value = bei { $time }, { $position } von der Mitte, nach { $turns ->
    [one] einem Umkehrpunkt
   *[other] { $turns } Umkehrpunkten
}
measured-notes = Anmerkungen zum Lesen der Datei:
measured-findings-none = Die Residuen zeigen kein Muster, das mit der Bewegung geht: Nichts spricht gegen das Modell.
measured-findings = Muster in den Residuen, die mit der Bewegung gehen:
measured-finding-softening = Die Periode wächst mit der Amplitude wie beim Pendel: Die weitesten Schwingungen sind um { $effect } langsamer als die kleinsten.
measured-finding-hardening = Die Periode fällt mit der Amplitude: Die weitesten Schwingungen sind um { $effect } schneller als die kleinsten.
measured-finding-period-drift = Die Periode driftet; das macht bis zu { $effect } der Bewegung aus.
measured-finding-losses = Die Verluste an Amplitude sind die keines Gemischs der Gesetze; das macht bis zu { $effect } der Bewegung aus.
measured-finding-growing = Die Amplitude wächst, statt abzunehmen; das macht bis zu { $effect } der Bewegung aus.
measured-finding-zero-drift = Der Nullpunkt des Sensors driftet; das macht bis zu { $effect } der Bewegung aus.
measured-finding-shape = Die Schwingungen haben eine andere Form, wie bei einem nicht linearen Sensor; das macht bis zu { $effect } der Bewegung aus.
measured-finding-residual = Was die Anpassung übrig lässt, ist weit mehr als das Rauschen von Wert zu Wert: { $effect } der weitesten Halbschwingung.
measured-grave = { $finding } Das ist so viel, dass kein Gemisch die Bewegung beschreibt.
measured-slight = { $finding } Neben der Bewegung ist das wenig; die Standardfehler nehmen es für Rauschen, und Werte können weiter danebenliegen.

## Wie das zu lesen ist

measured-method = Wie das zu lesen ist
measured-equation = Ein Federpendel mit viskoser, trockener und quadratischer Reibung gehorcht
measured-symbols-omega = $\omega_0$ ist die Kreisfrequenz ohne Reibung; die Masse schwingt um die Mitte, $x = 0$.
measured-symbols-gamma = $\gamma$ ist der Dämpfungsparameter der viskosen (Stokesschen) Reibung, einer Kraft $-2m\gamma\dot x$.
measured-symbols-coulomb = $a_c$ ist die Kraft der trockenen (Coulombschen) Reibung, geteilt durch die Masse; um $f = a_c/\omega_0^2$ verschiebt sie die Mitte einer Halbschwingung.
measured-symbols-kappa = $\kappa$ misst die quadratische (Newtonsche) Reibung, eine Kraft $-m\kappa|\dot x|\dot x$.
measured-symbols-length = Längen sind in der Einheit der Aufzeichnung angegeben. Ist $x$ in Volt aufgezeichnet, so hat $a_c$ die Einheit Volt durch Sekunde im Quadrat.
measured-steps = Zuerst wird der Teil der Aufzeichnung gesucht, in dem die Masse frei schwingt; seine Umkehrpunkte geben eine erste Vorstellung von den Koeffizienten. Dann wird die ganze Bewegung, durch jede Umkehr und bis zur Ruhe, nach der Methode der kleinsten Quadrate angepasst, einmal für jedes Gemisch der drei Gesetze. Das Urteil ist das einfachste Gemisch, das nicht verworfen ist, und in den Residuen wird gesucht, was kein Gemisch erklären kann.
measured-confidence = Der Standardfehler sagt, wie weit ein Wert bei einer Wiederholung des Versuchs typischerweise danebenläge; das 95-%-Intervall enthält in 19 von 20 Fällen den wahren Wert, sofern das Modell stimmt.
