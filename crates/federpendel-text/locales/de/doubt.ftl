# Was eine Anpassung weniger sicher macht, als ihre Standardfehler sagen.

# $effect: Prozent, bei weicher und härter werdender Feder der Periode, sonst der Bewegung.
fit-slight-softening = Die Periode wächst zu großen Schwingungen hin um { $effect }: Gesetze und Werte können weiter danebenliegen, als ihre Fehler sagen.
fit-slight-hardening = Die Periode fällt zu großen Schwingungen hin um { $effect }: Gesetze und Werte können weiter danebenliegen, als ihre Fehler sagen.
fit-slight-period-drift = Die Periode driftet; das macht bis zu { $effect } der Bewegung aus. Gesetze und Werte können weiter danebenliegen, als ihre Fehler sagen.
fit-slight-losses = Die Amplitude nimmt nicht ganz so ab wie bei einem Gemisch der Gesetze; das macht bis zu { $effect } der Bewegung aus. Gesetze und Werte können weiter danebenliegen, als ihre Fehler sagen.
fit-slight-zero-drift = Der Nullpunkt des Sensors driftet; das macht bis zu { $effect } der Bewegung aus. Gesetze und Werte können weiter danebenliegen, als ihre Fehler sagen.
fit-slight-shape = Die Schwingungen haben eine andere Form, wie bei einem nicht linearen Sensor; das macht bis zu { $effect } der Bewegung aus. Gesetze und Werte können weiter danebenliegen, als ihre Fehler sagen.

# $from, $to: die früheste und die späteste Zeit.
fit-rests-between = Offen ist, ob die Masse schon bei { $from } oder erst bei { $to } zur Ruhe kommt.
fit-rests-or-not = Offen ist, ob die Masse bei { $from } zur Ruhe kommt oder bis zum Ende des angepassten Teils weiterschwingt.
