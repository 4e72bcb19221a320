# Die Behauptungen des Artikels in anderen Worten, und was sich dazu ergab: check-ID, und ein Attribut je Urteil.
# Jeder Satz stimmt für alle Versuche mit diesem Urteil; die Zahlen stehen daneben.

-no-swing = Die trockene Reibung hält die Masse dort fest, wo sie losgelassen wird; es gibt keine Halbschwingung.
-no-motion = Die Masse bewegt sich nicht; es gibt keine Reibung zu messen.
-no-oscillation = Bei dieser Dämpfung, $\gamma\ge\omega_0$, schwingt die Masse nicht: Es gibt keine Kreisfrequenz $\omega$, und die Lösung des Artikels für den Schwingfall $\gamma<\omega_0$ gilt hier nicht.
-runs-away = Bei so starker Reibung läuft das Verfahren mit seinem üblichen Schritt davon; es liefert keine Orte, die man vergleichen könnte.
-too-many-steps = Die trockene Reibung ist hier so schwach, dass das Verfahren bis zum Ende der Bewegung mehr Schritte brauchte, als gerechnet werden.
-no-order = Eine Ordnung lässt sich nicht ablesen: Mit mindestens einem der erprobten Schritte läuft das Verfahren davon oder zeigt keinen Fehler.
-weak-for-order = Die Reibung ist hier so schwach, dass ihr Anteil am Fehler bei den erprobten Schritten nicht sichtbar wird.
-goes-on = Die Masse kommt zur Ruhe und haftet, die Formeln dagegen laufen weiter: Eine linear fallende Amplitude geht durch null und wächst von da an unbegrenzt.
-third-side = setzt für $v_A$ die dritte Seite von (68) ein, die einen Faktor $C$ zu viel enthält. Richtig ist $v_A=2f\omega_0/\pi$ mit der Verschiebung $f=\mu F_N/C$.
-one-newton-per-metre = An der Zahl sieht man das hier nicht, weil $C$ in N/m gerade den Wert 1 hat.

## Abschnitt 1: ohne Reibung

check-harmonic = Mit $\omega_0^2=C/m$ lösen der Kosinus, der Sinus und jede Summe von Vielfachen der beiden die Bewegungsgleichung (3).
    .holds = Was übrig bleibt, ist der Fehler einer numerisch gebildeten zweiten Ableitung.
check-angular-frequency = Die Kreisfrequenz der Bewegung ohne Reibung folgt aus $\omega_0^2=C/m$.
    .holds = Als Kreisfrequenz zählt nur die positive Wurzel; das Vorzeichen ± in (8) und (16) ist entbehrlich.
check-constants = Die Anfangsbedingungen legen die beiden Konstanten fest: $C_1=x_0$ und $C_2=v_0/\omega_0$.
check-general-solution = (20) ist für jede Anfangsbedingung die Bewegung ohne Reibung.
check-imaginary-roots = Der Exponentialansatz löst (3) mit den beiden imaginären Werten $\lambda=\pm i\omega_0$.
check-both-routes = Die Summe (25) zweier komplexer Exponentialfunktionen ist reell und beschreibt dieselbe Bewegung wie (20).
check-chain-25-27 = Die Formel von Euler macht aus (25) die Zeile (26), und nach Kosinus und Sinus geordnet ergibt sich (27).
check-lost-factor = Beim Schritt von (27) nach (28) lautet die Konstante des Sinus $C_2=\tilde C_1-\tilde C_2$.
    .fails = Die Klammer lässt den Faktor $i$ weg, der davor steht; die Differenz allein ist imaginär. Mit $C_2=i(\tilde C_1-\tilde C_2)$ ist die Konstante reell und gleich $v_0/\omega_0$.
    .holds-here = Die Klammer lässt den Faktor $i$ weg, der davor steht. Hier macht das keinen Unterschied, weil die Anfangsgeschwindigkeit und damit die Konstante bis auf Rundung null ist.

## Abschnitt 2.1: Stokessche Reibung

check-only-linear = Von den drei Arten der Reibung lässt nur die Stokessche die Bewegungsgleichung linear.
    .holds = Doppelte Auslenkung und doppelte Geschwindigkeit beim Loslassen ergeben bei Stokesscher Reibung die doppelte Bewegung, bei den beiden anderen nicht.
    .not-applicable = An diesem Versuch lässt sich nicht zeigen, dass die Gleichungen mit trockener und mit Newtonscher Reibung nicht linear sind.
check-stokes-force = Die Kraft der Stokesschen Reibung ist proportional zur Geschwindigkeit, mit der Konstante $D$.
check-characteristic-roots = Die beiden Werte (36) sind die Lösungen der charakteristischen Gleichung (35).
check-oscillates-below-critical = Die Masse schwingt nur dann hin und her, wenn die Diskriminante $D^2/(4m^2)-\omega_0^2$ in (36) negativ ist.
    .holds = Aus der Ruhe losgelassen kehrt sie für $\gamma<\omega_0$ immer wieder um, im aperiodischen Grenzfall und im Kriechfall kein einziges Mal. Streng periodisch, wie der Artikel schreibt, ist auch diese Bewegung nicht, denn ihre Amplitude fällt.
check-conjugate-roots = Im Schwingfall sind die Lösungen $-\gamma\pm i\omega$, mit $\gamma$ und $\omega$ nach (41).
    .not-applicable = { -no-oscillation }
check-complex-form = Im Schwingfall lassen sich die beiden komplexen Exponentialfunktionen (38) als reelle Lösung (40) schreiben.
    .not-applicable = { -no-oscillation }
check-damped-constants = Die Anfangsbedingungen legen die Konstanten von (40) fest: $C_1=x_0$ und $C_2=(v_0+\gamma x_0)/\omega$.
    .not-applicable = { -no-oscillation }
check-derivative = (43) ist die Ableitung von (40) nach der Zeit.
    .not-applicable = { -no-oscillation }
check-damped-solution = Im Schwingfall ist (46) für jede Anfangsbedingung die Bewegung mit Stokesscher Reibung.
    .not-applicable = { -no-oscillation }
check-frequency-lowered = Stokessche Reibung senkt die Kreisfrequenz von $\omega_0$ auf das $\omega$ aus (37).
    .not-applicable = { -no-oscillation }
check-exponential-decay = Bei Stokesscher Reibung fällt die Amplitude exponentiell mit der Zeit.
    .holds = Von Umkehrpunkt zu Umkehrpunkt bleibt immer derselbe Bruchteil der Auslenkung.
    .not-applicable = Die Dämpfung ist kritisch, stärker oder nur wenig schwächer: Es gibt keine Umkehrpunkte, die man vergleichen könnte.
check-overdamped-solution = Ist die Diskriminante in (36) positiv, so löst eine Summe zweier reeller Exponentialfunktionen die Gleichung (30).
check-critical-solution = Ist die Diskriminante in (36) null, so lösen eine Exponentialfunktion und ihr Produkt mit $t$ zusammen die Gleichung (30).

## Abschnitt 2.2: Differenzenquotienten

check-quotient-orders = Die Differenzenquotienten (48) und (49) sind als Ersatz der Ableitungen geeignet, was hier heißen soll: beide sind von zweiter Ordnung.
    .fails = Der zentrale Differenzenquotient (49) ist von zweiter Ordnung, der rückwärtige (48) aber nur von erster: Der halbe Schritt halbiert seinen Fehler nur. Ein zentraler Differenzenquotient über zwei Schritte wäre auch für die Geschwindigkeit von zweiter Ordnung.
check-recursion-stokes = (51) ist die diskretisierte Gleichung (50), aufgelöst nach dem nächsten Ort.
    .not-applicable = { -runs-away }
check-scheme-order-stokes = Das Verfahren (51) ist für Stokessche Reibung geeignet, was hier heißen soll: Es ist mit Reibung wie ohne von zweiter Ordnung.
    .fails = Der rückwärtige Differenzenquotient (48) lässt mit Reibung nur die erste Ordnung übrig: Der halbe Schritt halbiert den Fehler nur. Ohne Reibung fällt (48) weg, und das Verfahren ist von zweiter Ordnung.
    .holds-here = Im Allgemeinen lässt der rückwärtige Differenzenquotient (48) nur die erste Ordnung übrig. { -weak-for-order }
    .not-applicable = { -no-order }
check-stability = Die Rekursion (51), für die der Artikel keine Grenze des Schritts $\Delta t$ nennt, bleibt für jeden Schritt beschränkt.
    .fails = Es gibt eine Grenze, die der Artikel nicht nennt: Die Rekursion bleibt nur für $\omega_0^2\Delta t^2+4\gamma\Delta t<4$ beschränkt. Mit einem Schritt knapp darüber wächst die Amplitude unbegrenzt.
check-start-order = Der Differenzenquotient (52) für die Beschleunigung beim Start ist von zweiter Ordnung.
    .fails = Wenn die Ordnung der Genauigkeit gemeint ist, ist er nur von erster Ordnung. Für den ersten Schritt (54) genügt das, weil er dort mit dem Quadrat des Schritts eingeht.
    .holds-here = Im Allgemeinen ist (52) nur von erster Ordnung. Der führende Fehler ist proportional zur dritten Ableitung der Bewegung beim Start, und die ist bei dieser Anfangsbedingung nahezu null.
check-start-stokes = (54) ist die Gleichung (53), aufgelöst nach dem ersten Ort $x_1$.
check-agreement-stokes = Als Graphen gezeichnet stimmen die numerische Lösung (51) und die analytische Lösung (46) überein.
    .fails = Mit dem üblichen Schritt des Verfahrens liegen sie weiter auseinander, als eine Linie breit ist: Für diese Dämpfung ist der Schritt zu lang.
    .not-applicable = { -runs-away }
    .holds = Der Abstand ist kleiner als die Breite einer Linie; genau gleich sind sie nicht, denn das Verfahren ist eine Näherung.

## Abschnitt 3.1: Coulombsche Reibung, die Gleichung und das Verfahren

check-friction-force = Trockene Reibung hat den Betrag $\mu F_N$, unabhängig von der Geschwindigkeit.
    .not-applicable = { -no-swing }
check-normal-force = Was die Masse auf ihre Führung drückt, ist ihr Gewicht, $F_N=mg$.
    .not-applicable = Die Kraft auf die Führung ist gegeben, unabhängig vom Gewicht.
check-opposes-motion = Durch die Signum-Funktion in (57) wirkt die Reibung immer gegen die Bewegung.
    .not-applicable = { -no-motion }
check-static-friction = Mit der Signum-Funktion beschreiben (57) und (59) auch eine Masse, die von trockener Reibung festgehalten wird.
    .fails = Wegen sign(0) = 0 spürt eine ruhende Masse in (59) keine Reibung. Im Haftbereich aus der Ruhe losgelassen verlässt sie ihren Ort, obwohl die Feder zu schwach ist, sie zu bewegen.
    .not-applicable = { -too-many-steps }
check-recursion-coulomb = (59) ist die diskretisierte Gleichung (58), aufgelöst nach dem nächsten Ort.
check-start-coulomb = (60) liefert den ersten Ort für jede Anfangsbedingung, auch für eine aus der Ruhe.
    .fails = Mit $v_0=0$ ist das Vorzeichen in (60) null, und die Reibung fehlt: Der erste Schritt ist so lang wie ohne Reibung. Maßgeblich ist die Richtung, in die sich die Masse gleich bewegen wird.
    .not-applicable = { -no-swing }
check-linear-decay = Bei trockener Reibung fällt die Amplitude linear mit der Zeit.
    .holds = Jede Halbschwingung verliert $2f$, mit der Verschiebung $f=\mu F_N/C$, und dauert gleich lang.
    .not-applicable = Die Masse macht weniger als drei Halbschwingungen, zu wenige, um ihre Verluste zu vergleichen.
check-scheme-rests = Das Verfahren (59) beschreibt die Bewegung bis zu ihrem Ende, an dem die Masse ruht.
    .fails = Das Verfahren kennt keine Haftreibung. Wenn die Masse längst zur Ruhe gekommen ist, rattert es noch immer hin und her und kriecht auf $x=0$ zu.
    .not-applicable = { -too-many-steps }
check-scheme-order-coulomb = Das Verfahren (59) ist für trockene Reibung geeignet, was hier heißen soll: Es ist von zweiter Ordnung.
    .fails = Die trockene Reibung wechselt ihre Richtung irgendwo zwischen zwei Gitterpunkten, und (59) bemerkt das erst am nächsten. Das kostet die zweite Ordnung; übrig bleibt meist etwa die erste, und sie schwankt, weil es darauf ankommt, wo dazwischen das geschieht.
    .holds-here = Im Allgemeinen bleibt meist etwa die erste Ordnung übrig, weil die Umkehrpunkte zwischen den Gitterpunkten liegen. { -weak-for-order }
    .not-applicable = { -no-order }

## Abschnitt 3.2.1: die Energie und die Abnahmegeschwindigkeit

check-work-energy = Auf dem Weg von $x_0$ zum nächsten Umkehrpunkt $x_1$ verrichtet die Reibung die Arbeit $F_R x_0+F_R x_1$, und ebenso viel Energie verliert die Feder.
    .not-applicable = { -no-swing }
check-energy-chain = Die Umformungen in (65) und (66) lassen die Energiebilanz (64) unverändert.
    .not-applicable = { -no-swing }
check-loss = Von einem Umkehrpunkt zum nächsten fällt die Amplitude um $\Delta x=2\mu F_N/C$.
    .not-applicable = { -no-swing }
check-half-period = Der Weg von $x_0$ nach $x_1$ dauert eine halbe Periode, $T/2$.
    .not-applicable = { -no-swing }
check-period-chain = Auch mit trockener Reibung ist die Periode $T=2\pi/\omega_0$ mit $\omega_0^2=C/m$.
    .not-applicable = Die Masse macht weniger als zwei Halbschwingungen; es gibt keine zwei Umkehrpunkte im Abstand einer Halbschwingung.
check-decay-left = Die Amplitude fällt mit der Geschwindigkeit $v_A=\Delta x/(T/2)$, der ersten Seite von (68).
    .not-applicable = { -no-swing }
check-decay-middle = Die zweite Seite von (68) ist gleich der ersten.
    .fails = Die zweite Seite teilt durch die ganze Periode $T$ statt durch $T/2$; sie ist die Hälfte der ersten.
check-decay-right = Die dritte Seite von (68) ist gleich der ersten.
    .fails = Die dritte Seite ist das $C$-Fache der ersten: Eine Division durch $C$ ist verloren gegangen. Richtig ist $v_A=2\mu F_N\omega_0/(\pi C)$.
    .holds-here = Die dritte Seite ist das $C$-Fache der ersten: Eine Division durch $C$ ist verloren gegangen, und die Einheit ist falsch. { -one-newton-per-metre }
check-decay-dimension = Die Seiten von (68) sind Geschwindigkeiten; ihre Werte hängen daher nicht davon ab, ob man Massen in Kilogramm oder in Gramm angibt.
    .fails = Die dritte Seite ist keine Geschwindigkeit. Ihre Einheit ist N/s statt m/s, und ihr Wert ändert sich mit der Einheit der Masse, wie es $C$ tut.

## Abschnitt 3.2.1: die Lösung aus der Ruhe

check-letter-c = In (61) ist $\omega_0$ die Wurzel aus $c/m$, im Einklang mit (16).
    .fails = Dort muss die Federkonstante $C$ stehen. Ein kleines $c$ kommt im Artikel nur als Widerstandsbeiwert $c_w$ vor, eine reine Zahl.
    .holds-here = Dort muss die Federkonstante $C$ stehen. Ein kleines $c$ kommt im Artikel nur als Widerstandsbeiwert $c_w$ vor, eine reine Zahl, die hier zufällig den Wert von $C$ in N/m hat.
    .not-applicable = { -no-swing }
check-frequency-unchanged = Trockene Reibung ändert die Frequenz nicht.
    .holds = Die Umkehrpunkte folgen einander im Abstand der halben Periode ohne Reibung. Die Nulldurchgänge dazwischen verspäten sich.
    .not-applicable = { -no-swing }
check-analytic-exists = Trotz der Signum-Funktion hat die Bewegungsgleichung (57) eine analytische Lösung.
    .holds = Von einem Umkehrpunkt zum nächsten ist die Bewegung ein Kosinus um eine Mitte, die von der Reibung um $f=\mu F_N/C$ verschoben ist.
    .not-applicable = { -no-swing }
check-linear-solution = (61) mit $v_A=\Delta x/(T/2)$ ist für eine Masse, die aus der Ruhe losgelassen wird, die Lösung von (57).
    .fails = Eine Lösung ist das nicht: (61) schwingt um $x=0$, während die Reibung die Mitte jeder Halbschwingung um $f=\mu F_N/C$ gegen die Bewegungsrichtung verschiebt.
check-linear-turning-points = (61) mit $v_A=\Delta x/(T/2)$ liefert die Umkehrpunkte einer Masse, die aus der Ruhe losgelassen wird.
    .not-applicable = { -no-swing }
check-linear-start = (61) erfüllt die Anfangsbedingung $v_0=0$ einer Masse, die aus der Ruhe losgelassen wird.
    .fails = (61) beginnt mit der Geschwindigkeit $v_A$ auf die Mitte zu, weil die Amplitude von Anfang an abnimmt.
check-negative-release = (61) und (69) gelten für jedes $x_0$, auf welcher Seite der Mitte es auch liegt.
    .fails = Für $x_0<0$ wächst der Betrag von $x_0-v_A t$, statt zu fallen. Richtig ist $|x_0|-v_A t$ mit dem Vorzeichen von $x_0$ davor.
    .not-applicable = { -no-swing }
check-written-out = (69) ist (61) mit ausgeschriebenem $v_A$ und hat dieselben Umkehrpunkte.
    .fails = (69) { -third-side }
    .holds-here = (69) { -third-side } { -one-newton-per-metre }
    .not-applicable = { -no-swing }
check-after-rest = (61) und (69) beschreiben die Bewegung zu allen Zeiten.
    .fails = { -goes-on }
    .not-applicable = Ob und wann die Masse zur Ruhe kommt, ist hier nicht bekannt.
check-agreement-coulomb = Als Graphen gezeichnet stimmen die numerische Lösung (59) und die analytische Lösung (69) überein.
    .fails = Mindestens eine der beiden weicht um mehr als eine Linienbreite von der Bewegung ab. In (69) führen der Faktor $C$ in $v_A$ und die fehlende Verschiebung $f$ der Mitte in die Irre; in (59) summieren sich die Fehler der Halbschwingungen.
    .not-applicable = { -too-many-steps }
check-agreement-proves = Die Übereinstimmung der beiden Graphen beweist, dass trockene Reibung die Frequenz unverändert lässt.
    .fails = Eine Zeichnung beweist das nicht: Trockene Reibung verzögert die Nulldurchgänge, die (61) so legt, als gäbe es keine Reibung. Nur die Umkehrpunkte behalten ihren Abstand von einer halben Periode, und das folgt aus der Lösung von (57), nicht aus einem Graphen.
    .not-applicable = Die Masse geht in ihrer ersten Halbschwingung nicht durch $x=0$; es gibt keinen Nulldurchgang zu vergleichen.

## Abschnitt 3.2.2: beliebige Anfangsbedingungen

check-one-sine = Kosinus und Sinus in (71) lassen sich zu einem einzigen Sinus $A\sin(\omega_0 t+\varphi)$ zusammenfassen.
check-coefficients = Der Vergleich der Koeffizienten ergibt $x_0=A\sin\varphi$ und $v_0/\omega_0=A\cos\varphi$.
check-amplitude = Das Quadrat der Amplitude ohne Reibung ist $A^2=x_0^2+(v_0/\omega_0)^2$.
    .not-applicable = Die Bewegung hat keinen Umkehrpunkt, an dem sich die Amplitude ablesen ließe.
check-tangent = Der Tangens der Phase ist $\tan\varphi=x_0\omega_0/v_0$.
check-quadrant = Die Phase ist $\varphi=\arctan(x_0\omega_0/v_0)$, in welche Richtung $v_0$ auch zeigt.
    .fails = Für $v_0<0$ liegt der Arkustangens um eine halbe Drehung daneben, so dass die Formel bei $-x_0$ beginnt. Richtig ist der Arkustangens mit zwei Argumenten, atan2($x_0\omega_0$, $v_0$), der den Quadranten kennt.
check-phase-at-rest = (77) liefert für jede Anfangsbedingung eine Phase, auch für $v_0=0$.
    .fails = Für $v_0=0$ steht im Nenner null. Ist $x_0$ nicht null, so ist der Grenzwert $\varphi=\pm\pi/2$ gemeint, mit dem Vorzeichen von $x_0$; für $x_0=v_0=0$ gibt es keine Phase, und keine wird gebraucht, denn die Masse bleibt in Ruhe.
check-general-linear-solution = (78) mit $v_A=\Delta x/(T/2)$ und der Phase nach (75) ist für jede Anfangsbedingung die Lösung von (57).
    .fails = Eine Lösung ist das nicht: (78) schwingt um $x=0$, während die Reibung die Mitte jeder Halbschwingung um $f=\mu F_N/C$ gegen die Bewegungsrichtung verschiebt.
check-general-turning-points = (78) mit $v_A=\Delta x/(T/2)$ und der Phase nach (75) liefert für jede Anfangsbedingung die Umkehrpunkte.
    .fails = Eine Masse, die mit einer Geschwindigkeit losgelassen wird, beginnt mitten in einer Halbschwingung um eine verschobene Mitte, während (76) und (77) Amplitude und Phase auf $x=0$ beziehen. Daher verfehlt (78) auch die Umkehrpunkte.
check-general-written-out = (79) ist (78) mit ausgeschriebener Amplitude, Abnahmegeschwindigkeit und Phase.
    .fails = (79) { -third-side }
    .holds-here = (79) { -third-side } { -one-newton-per-metre }
    .not-applicable = Die Bewegung hat keinen Umkehrpunkt, an dem sich beide vergleichen ließen.
check-general-after-rest = (78) und (79) beschreiben die Bewegung zu allen Zeiten.
    .fails = { -goes-on }
    .not-applicable = Ob und wann die Masse zur Ruhe kommt, ist hier nicht bekannt.
check-agreement-general = Als Graphen gezeichnet stimmen die numerische Lösung (59) und die analytische Lösung (79) für jede Anfangsbedingung überein, was die Herleitung bestätigt.
    .fails = Für $v_0<0$ stimmen sie nicht überein, auch wenn man $v_A$ berichtigt: Mit der gedruckten Phase beginnt die Kurve bei $-x_0$ und verläuft gespiegelt.
    .not-applicable = { -too-many-steps }
    .holds-here = Im Allgemeinen stimmen sie nicht überein. Hier ist die gespiegelte Kurve von der Bewegung nicht zu unterscheiden, weil die Auslenkung beim Loslassen neben der Amplitude klein ist.

## Abschnitt 4: Newtonsche Reibung, und wie Amplituden fallen

check-drag-force = Newtonsche Reibung hat den Betrag $\rho c_w A\dot x^2/2$.
    .not-applicable = { -no-motion }
check-recursion-newton = (85) ist die diskretisierte Gleichung (84), aufgelöst nach dem nächsten Ort.
    .not-applicable = { -runs-away }
check-start-newton = (86) ist die Gleichung (83) mit dem Differenzenquotienten (52), aufgelöst nach dem ersten Ort $x_1$.
check-scheme-order-newton = Das Verfahren (85) ist für Newtonsche Reibung geeignet, was hier heißen soll: Es ist von zweiter Ordnung.
    .fails = Auch bei Newtonscher Reibung lässt der rückwärtige Differenzenquotient (48) nur die erste Ordnung übrig: Am Ende halbiert der halbe Schritt den Fehler nur.
    .holds-here = Im Allgemeinen lässt der rückwärtige Differenzenquotient (48) nur die erste Ordnung übrig. { -weak-for-order }
    .not-applicable = { -no-order }
check-only-numeric = Bei Newtonscher Reibung ist eine numerische Lösung wahrscheinlich die einzig sinnvolle; in geschlossener Form lässt sich nichts angeben.
    .fails = Für den Ort als Funktion der Zeit trifft das zu; die Umkehrpunkte und die Geschwindigkeit an jedem Ort aber kennt man in geschlossener Form, die Umkehrpunkte mit der Lambertschen Funktion $W$.
    .not-applicable = Die Masse macht weniger als zwei Halbschwingungen; es gibt keine zwei Umkehrpunkte zu vergleichen.
check-series-possible = Bei Newtonscher Reibung ist eine analytische Lösung vielleicht über eine Reihe möglich.
    .holds = Die Bewegung wird hier als Reihe berechnet, Halbschwingung für Halbschwingung, und ihre Umkehrpunkte sind die der geschlossenen Form.
check-neither-decay = Bei Newtonscher Reibung fällt die Amplitude weder linear noch exponentiell.
    .holds = Weder die Verluste zweier Halbschwingungen noch ihre Verhältnisse sind gleich. Bei schwacher Reibung verliert eine Halbschwingung von $x_0$ aus etwa $4\kappa x_0^2/3$ mit $\kappa=\rho c_w A/(2m)$, und die Amplitude fällt hyperbolisch.
    .not-applicable = Es gibt keine zwei Halbschwingungen, deren Verluste sich unterscheiden ließen.
check-decrement-plot = An der Art, wie die Amplitude fällt, lassen sich die Arten der Reibung unterscheiden: linear bei trockener, exponentiell bei Stokesscher, keines von beiden bei Newtonscher Reibung.
    .holds = Über der Amplitude aufgetragen ist der Verlust einer Halbschwingung bei schwacher Reibung eine Parabel. Die trockene Reibung ist ihr Achsenabschnitt $2f$, die Stokessche ihre Steigung $\pi\gamma/\omega_0$, die Newtonsche ihre Krümmung $4\kappa/3$.
    .not-applicable = Mindestens eine der drei Arten der Reibung, jede für sich genommen, ist zu stark für das gemittelte Gesetz schwacher Reibung, zu schwach, um sich in drei Halbschwingungen zu zeigen, oder lässt der Masse weniger als drei.
