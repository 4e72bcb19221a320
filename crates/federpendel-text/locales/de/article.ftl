# Der Bericht über den Artikel: sein Text. Formeln stehen zwischen Dollarzeichen, in der Schreibweise von TeX, ohne Klammern.

### Das Ganze

article-title = Das Federpendel mit Reibung: ein Artikel, nachgerechnet
article-title-worksheet = Das Federpendel mit Reibung: Arbeitsblatt
article-title-solutions = Das Federpendel mit Reibung: Lösungen zum Arbeitsblatt
article-lead = Der Artikel „Das Federpendel mit verschiedenen Arten von Reibung“ verfolgt eine Masse an einer Feder ohne Reibung und mit Stokesscher (viskoser), Coulombscher (trockener) und Newtonscher (quadratischer) Reibung: mit Formeln, wo er sie findet, sonst mit einem einfachen Differenzenverfahren.
article-lead-report = Dieser Bericht geht ihn Abschnitt für Abschnitt an einem Versuch durch und vergleicht jede Behauptung mit der Bewegung selbst, die ohne Newtonsche Reibung in geschlossener Form und mit ihr bis auf Rundungsfehler bekannt ist.
article-lead-worksheet = Dieses Arbeitsblatt geht ihn Abschnitt für Abschnitt an einem Versuch durch.
article-own-values = Der Artikel enthält kein Zahlenbeispiel, und die Werte hinter seinen Graphen sind nicht bekannt. Zu jedem Graphen, den er erwähnt, steht hier einer derselben Art mit den Werten aus der Tabelle der Größen. Zahlen in Klammern sind die Gleichungsnummern des Artikels.
article-result = Von den { $checks } Behauptungen, die hier nachgerechnet sind, gelten { $holds }, und { $fails } gelten nicht.
article-result-readings = { $claims ->
        [one] Eine davon steht
       *[other] { $claims } davon stehen
    } nicht wörtlich im Artikel, sondern { $claims ->
        [one] prüft
       *[other] prüfen
    }, wie weit er reicht.
article-result-here = { $claims ->
        [one] Eine ist
       *[other] { $claims } sind
    } im Allgemeinen falsch, aber für diesen Versuch dem Zahlenwert nach richtig.
article-result-open = Über { $claims ->
        [one] eine Behauptung
       *[other] { $claims } Behauptungen
    } sagt dieser Versuch nichts.
article-errata = Was am Artikel zu berichtigen ist
article-errata-text = Alle Behauptungen, die nicht gelten, in der Reihenfolge des Artikels.
article-task = Neben jeder Behauptung steht, was berechnet wurde und womit zu vergleichen ist. Winzige Unterschiede wie 10⁻¹⁰ sind Rundung. Entscheide: Gilt die Behauptung, gilt sie nicht, stimmt sie nur zufällig für die Zahlen dieses Versuchs, oder lässt sie sich an diesem Versuch nicht entscheiden? Begründe.
article-see-claims = Behauptungen, die nicht oder nur hier gelten
article-colophon = Erstellt von federpendel { $version }. Jede Zahl auf dieser Seite ist mit den Werten aus der Tabelle der Größen berechnet.
article-head-number = Nr.
article-head-equation = Gleichung
article-head-claim = Behauptung
article-head-verdict = Urteil
article-head-right = Richtig ist

### Der Versuch

article-experiment = Der Versuch
article-experiment-text = Eine Masse $m$ an einer Feder mit der Federkonstante $C$ wird bei $x_0$ mit der Geschwindigkeit $v_0$ losgelassen. Auslenkungen zählen von der Lage aus, in der die Feder entspannt ist, bei einer hängenden Masse von ihrer Ruhelage aus.
article-sketch-none = Die Masse und die Kraft der Feder, ohne Reibung.
article-sketch-stokes = Die Masse in einem zähen Fluid: Die Feder zieht sie zur Mitte, die Reibung wirkt der Geschwindigkeit entgegen.
article-sketch-newton = Die Masse in einem Fluid mit Wirbeln: Die Reibung wirkt der Geschwindigkeit entgegen und wächst mit ihrem Quadrat.
article-sketch-coulomb = Die Masse auf ihrer Führung, auf dem Rückweg zur Mitte. Trockene Reibung ist dort eingezeichnet, wo sie wirkt, an der Berührfläche mit der Führung, dazu die Gewichtskraft und die Normalkraft der Führung.
article-experiment-motion = Die Bewegung dieses Versuchs, mit allen seinen Arten von Reibung zugleich ({ $mix }).
article-quantities = Größen dieses Berichts
article-symbols = So liest man die Zahlen bei den Behauptungen: max|Δx| ist der größte Abstand von der Bewegung, $t_n$ und $x_n$ sind Zeit und Ort des $n$-ten Umkehrpunkts, $x_N$ ist der Ort der Ruhe, $A$ die Amplitude ohne Reibung, n(…) eine Anzahl, p(…) die beobachtete Ordnung: Halbiert man den Schritt, so sinkt der Fehler auf ein $2^p$-tel.
article-head-quantity = Größe
article-head-symbol = Zeichen
article-head-value = Wert
article-head-origin = Herkunft
article-origin-given = gegeben
article-origin-built-in = Standardwert
article-origin-added = ergänzt
article-origin-derived = abgeleitet
article-quantity-force = Kraft der trockenen Reibung
article-quantity-omega = Kreisfrequenz ohne Reibung
article-quantity-period = Periodendauer ohne Reibung
article-quantity-offset = Verschiebung der Mitte
article-quantity-rate = Dämpfungsparameter
article-quantity-drag-rate = Parameter der Newtonschen Reibung
article-quantity-thrown = Anfangsgeschwindigkeit, wo der Artikel eine hat
article-quantity-displaced = Auslenkung, wo der Artikel eine hat
article-lacks = Der Versuch hat keine { $laws }. Die Abschnitte darüber rechnen mit einem Standardwert; er ist in der Tabelle so bezeichnet.
article-faint = Die { $laws } des Versuchs ist so schwach, dass von ihr nichts zu sehen wäre. Die Abschnitte darüber rechnen mit einem Standardwert; er ist in der Tabelle so bezeichnet.
article-added-velocity = Der Versuch beginnt in Ruhe oder beinahe. Wo der Artikel die Masse mit einer Geschwindigkeit starten lässt, sind es hier { $velocity }, einmal entgegen der Auslenkung und einmal in ihrer Richtung.
article-built-in-release = Der Versuch lässt die Masse in der Mitte in Ruhe, wo sich nichts bewegt. Im ganzen Bericht wird sie stattdessen bei { $position } losgelassen.
article-added-position = Der Versuch beginnt in der Mitte oder nahe bei ihr. Wo der Artikel die Masse ausgelenkt loslässt, sind es hier { $position }, die Amplitude ohne Reibung.
article-pressed = Die Kraft auf die Führung ist gegeben: Wo der Artikel $\mu m g$ schreibt, steht hier $\mu F_N$.
article-law-stokes = Stokessche Reibung
article-law-coulomb = Coulombsche Reibung
article-law-newton = Newtonsche Reibung

### 1 Ohne Reibung

article-undamped = 1 Ohne Reibung
article-undamped-text = Das zweite Newtonsche Gesetz ergibt mit der Hookeschen Feder die Bewegungsgleichung. Der Artikel löst sie auf zwei Wegen.
article-trigonometric = 1.1 Erster Weg: Kosinus und Sinus
article-trigonometric-text = Zwei Funktionen kehren nach zweimaligem Ableiten bis auf das Vorzeichen zu sich selbst zurück: Kosinus und Sinus. Jede löst (3), wenn $\omega_0$ den Wert (16) hat, und ebenso ihre Summe, deren zwei Konstanten aus den Anfangsbedingungen folgen.
article-exponential = 1.2 Zweiter Weg: Exponentialfunktionen
article-exponential-text = Der Standardansatz für lineare Gleichungen ist eine Exponentialfunktion. Er führt auf eine Gleichung für $\lambda$ mit zwei imaginären Lösungen, und die Eulersche Formel bringt die Summe beider Lösungen zurück auf Kosinus und Sinus.
article-undamped-figure = Beide Wege zur Lösung, (20) und (25), über der Bewegung ohne Reibung; darunter ihr Abstand von ihr. Losgelassen bei $x_0$ = { $position } mit $v_0$ = { $velocity }.
article-name-20 = (20)
article-name-25 = (25)

### 2 Stokes

article-stokes = 2 Stokessche Reibung
article-stokes-text = In einem Fluid, das ohne Wirbel strömt, wächst die Reibung proportional zur Geschwindigkeit, mit der Dämpfungskonstante $D$. Die Gleichung bleibt linear, und die Theorie der linearen Gleichungen lässt sich ohne Weiteres anwenden.
article-stokes-analytic = 2.1 Analytische Lösung
article-stokes-roots-text = Der Exponentialansatz führt auf die charakteristische Gleichung. Ihre Lösungen entscheiden, wie sich die Masse bewegt.
article-stokes-roots-figure = Die Lösungen (36) in der komplexen Ebene, wenn $D$ von null an wächst. Im Schwingfall sind sie ein konjugiertes Paar auf dem Kreis mit dem Radius $\omega_0$; auf der reellen Achse treffen sie sich bei $-\omega_0$ und laufen dann auf ihr auseinander. Die dieses Versuchs sind markiert.
article-stokes-solution-text = Im Schwingfall sind die Lösungen $-\gamma \pm i\omega$, und die Bewegung ist eine Schwingung unter einer Exponentialfunktion. Die beiden anderen Fälle nennt der Artikel, ohne sie zu verfolgen; hier sind auch sie gezeichnet.
article-stokes-regimes-figure = Dieselbe Masse an derselben Feder, auf dieselbe Weise losgelassen: Schwingfall, aperiodischer Grenzfall und Kriechfall.
article-stokes-regime-below = Schwingfall: γ = { $ratio } ω₀
article-stokes-regime-critical = Aperiodischer Grenzfall: γ = ω₀
article-stokes-regime-above = Kriechfall: γ = 2 ω₀
article-stokes-numeric = 2.2 Numerische Lösung
article-stokes-scheme-text = Für das Verfahren werden die Ableitungen durch Differenzenquotienten auf einem Gitter mit der Schrittweite $\Delta t$ ersetzt. Nach der neuesten Auslenkung aufgelöst ergeben sie eine Rekursion, die zum Start eine weitere Auslenkung braucht. Überall in diesem Bericht ist $\Delta t$ etwa ein Tausendstel der Periode, so gewählt, dass kein Umkehrpunkt auf einen Schritt fällt.
article-stokes-figure = Die Bewegung mit Stokesscher Reibung, die Formel (46) und das Verfahren (51) mit $\Delta t$ = { $step }; darunter ihr Abstand von der Bewegung. Losgelassen bei $x_0$ = { $position } mit $v_0$ = { $velocity }.
article-name-46 = Formel (46)
article-name-51 = Verfahren (51)

### 3 Coulomb

article-coulomb = 3 Coulombsche Reibung
article-coulomb-text = Trockene Reibung ist bei jeder Geschwindigkeit gleich stark und wirkt ihr entgegen. Die Bewegungsgleichung ist nur zwischen zwei Umkehrpunkten linear, denn in jedem wechselt ihre rechte Seite das Vorzeichen.
article-coulomb-scheme = 3.1 Numerische Lösung
article-coulomb-scheme-text = Der Artikel sieht zuerst nach, was das Verfahren aus dem Loslassen in Ruhe macht, und liest am Graphen ab, dass die Amplitude linear abnimmt.
article-coulomb-scheme-figure = Loslassen in Ruhe mit Coulombscher Reibung: die Bewegung und das Verfahren (59) mit $\Delta t$ = { $step }; darunter sein Abstand von der Bewegung.
article-name-59 = Verfahren (59)
article-coulomb-rest = 3.2.1 Analytische Lösung beim Loslassen in Ruhe
article-coulomb-energy-text = Wenn die Reibung die Frequenz nicht ändert, müsste die Lösung ein Kosinus sein, dessen Amplitude mit der festen Rate $v_A$ abnimmt, (61). Die Rate folgt aus einer Energiebetrachtung: Auf dem Weg von einem Umkehrpunkt zum nächsten verrichtet die Reibung so viel Arbeit, wie die Feder an Energie verliert.
article-coulomb-energy-sketch = Die Energiebetrachtung mit den Zahlen dieses Versuchs: von $x_0$ zum Umkehrpunkt $x_1$ auf der anderen Seite, eine halbe Periode später.
article-coulomb-energy-mirrored = Gezeichnet sind die Beträge; hier beginnt die Bewegung auf der anderen Seite.
article-coulomb-envelope-figure = Die Bewegung zwischen ihren Einhüllenden, mit ihren Umkehrpunkten und dem Haftbereich: Wo $|C x| \le \mu_s F_N$ ist, hält ein Umkehrpunkt die Masse für immer fest.
article-coulomb-formula-text = Mit der Abnahme je halber Periode (67) schreibt der Artikel die Rate aus, (68), und setzt sie ein, (69).
article-coulomb-right-text = Richtig ist, von Umkehrpunkt zu Umkehrpunkt, solange die Masse nicht haftet ($x_0>0$, $n$ Halbschwingungen nach dem Loslassen):
article-coulomb-figure = Loslassen in Ruhe: die Bewegung, die Formel (69) wie gedruckt, dieselbe mit der Rate $\Delta x/(T/2)$ und das Verfahren (59); darunter ihre Abstände von der Bewegung.
article-name-69 = (69), gedruckt
article-name-61 = (61) mit v_A = Δx/(T/2)
article-coulomb-thrown = 3.2.2 Analytische Lösung bei beliebigem Loslassen
article-coulomb-thrown-text = Beim Loslassen mit einer Geschwindigkeit schreibt der Artikel die Lösung ohne Reibung als einen einzigen Sinus mit der Amplitude $A$ und der Phase $\varphi$ und lässt die Amplitude abnehmen wie zuvor.
article-coulomb-forward-figure = Loslassen bei $x_0$ = { $position } mit $v_0$ = { $velocity }: die Bewegung, (79) wie gedruckt, (78) mit der Phase im richtigen Quadranten und der Rate $\Delta x/(T/2)$ und das Verfahren (59); darunter ihre Abstände von der Bewegung.
article-name-79 = (79), gedruckt
article-name-78 = (78) mit v_A = Δx/(T/2)
article-coulomb-stuck = Die trockene Reibung ist hier so stark, dass die Masse bleibt, wo sie losgelassen wird: Die Graphen zum Loslassen in Ruhe zeigen eine waagrechte Linie.

### 4 Newton

article-newton = 4 Newtonsche Reibung
article-newton-text = In einem Fluid mit Wirbeln wächst die Reibung mit dem Quadrat der Geschwindigkeit; $\rho$ ist die Dichte des Fluids, $c_w$ der Widerstandsbeiwert und $A$ die angeströmte Fläche.
article-newton-sketch = Die Masse im Fluid, von ihr aus gesehen: Das Fluid strömt ihr mit der Geschwindigkeit $v$ entgegen und trifft auf die Fläche $A$; die Reibung wirkt in Richtung der Strömung, also gegen die Bewegung der Masse.
article-newton-scheme-text = Der Artikel bleibt beim Verfahren und vermutet, dass ein Reihenansatz zu einer analytischen Lösung führen könnte.
article-newton-known-text = Zweierlei lässt sich hinzufügen. Zwischen zwei Umkehrpunkten gibt ein erstes Integral die Geschwindigkeit an jedem Ort und damit den nächsten Umkehrpunkt in geschlossener Form, durch die Lambertsche Funktion $W$. Und die Reihe ist ausgeführt: Die Auslenkung als Funktion der Zeit ist bis auf Rundungsfehler bekannt.
article-newton-figure = Die Bewegung mit Newtonscher Reibung und das Verfahren (85) mit $\Delta t$ = { $step }; darunter sein Abstand von der Bewegung. Losgelassen bei $x_0$ = { $position } mit $v_0$ = { $velocity }.
article-name-85 = Verfahren (85)
article-newton-decrement-figure = Was jede Halbschwingung verliert, über ihrer mittleren Amplitude.

### Welche Reibung ist es?

article-which = Welche Reibung ist es?
article-which-text = Drei Massen, gleich losgelassen, jede mit einer Art von Reibung. Alle drei Kurven sehen aus wie eine abklingende Schwingung. Was die Arten unterscheidet, ist der Verlust je Halbschwingung: bei Coulombscher Reibung immer derselbe, bei Stokesscher ein fester Anteil der Amplitude, bei Newtonscher ein Anteil, der selbst mit der Amplitude wächst.
article-which-motions-figure = Drei Bewegungen mit je einer Art von Reibung.
article-which-losses-figure = Dieselben drei Bewegungen: Abnahme der Amplitude je Halbschwingung über der mittleren Amplitude. Coulombsche Reibung ist eine waagrechte Gerade (Achsenabschnitt $2f$), Stokessche eine Gerade durch null (Steigung $\pi\gamma/\omega_0$), Newtonsche eine Parabel durch null (Krümmung $4\kappa/3$). Ein Gemisch ist deren Summe.
article-which-losses-blank-figure = Dieselben drei Bewegungen: Abnahme der Amplitude je Halbschwingung über der mittleren Amplitude.
article-which-table = Worin sich die Arten unterscheiden
article-which-head-law = Art
article-which-head-loss = Verlust je Halbschwingung
article-which-head-decay = Abnahme der Amplitude
article-which-head-measured = Erste Halbschwingung hier
article-which-linear = linear, endet in Ruhe
article-which-exponential = exponentiell
article-which-hyperbolic = hyperbolisch

### Wie falsch ist das einfache Verfahren?

article-scheme = Wie falsch ist das einfache Verfahren?
article-scheme-order-text = Halbiert man den Schritt, so bleibt einem Verfahren zweiter Ordnung ein Viertel seines Fehlers, einem erster Ordnung die Hälfte. Der zentrale Differenzenquotient (49) ist von zweiter, der rückwärtige (48) nur von erster Ordnung. Bei trockener Reibung kommt etwas hinzu: Im Allgemeinen fällt keine Umkehr auf einen Gitterpunkt, und in dem Schritt, in dem sie liegt, wirkt die Reibung eine Weile in die falsche Richtung.
article-scheme-order-title = Größter Fehler des Verfahrens über dem Schritt
article-scheme-order-figure = Größter Fehler des Verfahrens über dem Schritt, ohne Reibung und mit jeder ihrer Arten, bei sechs Halbierungen.
article-scheme-name-none = ohne Reibung
article-scheme-name-stokes = Stokes
article-scheme-name-coulomb = Coulomb
article-scheme-name-newton = Newton
article-scheme-table = Ordnung des Verfahrens
article-scheme-head-friction = Reibung
article-scheme-head-order = Beobachtete Ordnung
article-scheme-head-error = Größter Fehler beim kürzesten Schritt
article-scheme-rest-text = Im Verfahren hat die Reibung in Ruhe keinen Wert, denn sign(0) = 0. Sie kann die Masse nicht halten: Wo die Masse haftet, wechselt die Geschwindigkeit des Verfahrens von Schritt zu Schritt das Vorzeichen, und die Auslenkung kriecht zur Mitte. Das Zeitschrittverfahren von Moreau und Jean berechnet die Reibung nicht aus der Geschwindigkeit vor dem Schritt; es fragt, welche Reibung innerhalb ihrer Grenzen die Geschwindigkeit am Ende des Schritts auf null bringt, und lässt die Masse haften, wenn es eine gibt.
article-scheme-rest-figure = Nach dem Stillstand, vergrößert: die Bewegung, das Verfahren des Artikels und das von Moreau und Jean, alle mit $\Delta t$ = { $step }.
article-scheme-rest-table = Nach dem Stillstand
article-scheme-head-method = Verfahren
article-scheme-head-place = Auslenkung nach { $time }
article-scheme-head-rests = In Ruhe
article-scheme-head-creep = Kriechen
article-scheme-motion = die Bewegung
article-scheme-own = Verfahren des Artikels
article-scheme-moreau = Moreau–Jean
article-yes = ja
article-no = nein


