# Was zu Aufzeichnungen und ihrer Anpassung gesagt wird. Der Ordner en enthält dieselben Namen mit denselben Variablen.

### Aufzeichnungen, die abgelehnt werden; vor dem Satz stehen Datei und Zeile

recording-line = Zeile { $line }
recording-allowed = eine Tabelle von Zeiten und Werten: Text (.csv, .txt), auch in einer .zip-Datei, oder eine Excel-Mappe (.xlsx, .xls)
recording-empty = In der Datei oder in ihrer Tabelle steht nichts; erlaubt ist { $allowed }
recording-no-table = Das ist { $found }; erlaubt ist { $allowed }
recording-no-table-text = Das ist { $found } („{ $text }“); erlaubt ist { $allowed }
recording-too-large = Entpackt sind das mindestens { $bytes } Bytes; erlaubt sind { $most }
recording-long-line = Die Zeile hat mehr als { $most } Bytes; erlaubt ist eine Tabelle, in der jede Messung in einer eigenen Zeile steht
recording-password = Ein Kennwort sperrt diese Arbeitsmappe; erlaubt ist eine ohne: Öffnen Sie sie in ihrem Programm und speichern Sie sie dort ohne Kennwort
recording-damaged = Die Datei lässt sich nicht öffnen (die Leseroutine sagt auf Englisch: { $reason }); erlaubt ist ein unbeschädigtes Archiv oder eine unbeschädigte Mappe
    .page = Die Datei lässt sich nicht öffnen; erlaubt ist ein unbeschädigtes Archiv oder eine unbeschädigte Mappe
recording-several-tables = Die Datei enthält mehrere Tabellen, und keine ist angegeben (--table); erlaubt sind { $tables }
    .page = Die Datei enthält mehrere Tabellen; wählen Sie eine davon: { $tables }
recording-no-tables = Die Datei enthält keine Tabelle; erlaubt ist eine .zip-Datei, in der eine .csv, .txt, .tsv, .dat, .asc oder .lvm liegt, oder eine Mappe mit einem Blatt voller Zahlen
recording-no-named-tables = Als Tabelle ist „{ $asked }“ angegeben, aber in dieser Datei hat keine einen Namen; erlaubt ist, keine anzugeben
recording-table-not-found = Als Tabelle ist „{ $asked }“ angegeben; erlaubt sind { $tables }
recording-too-many-columns = Die Tabelle hat mindestens { $found } Spalten; erlaubt sind höchstens { $most }
recording-no-rows = Unter der Kopfzeile „{ $header }“ steht nichts; nötig sind mindestens { $least } Zeilen mit Zahlen
recording-header-cells = Diese Kopfzeile hat { $found } Zellen, die Zeilen darunter { $expected }; erlaubt sind gleich viele
recording-commas = Die Kommas in „{ $text }“ können zwischen Spalten stehen oder Dezimalzeichen sein; erlaubt ist ein Tabulator oder Semikolon zwischen den Spalten, oder eine Kopfzeile mit einer Zelle für jede Spalte
recording-cells = Diese Zeile hat { $found ->
    [one] eine Zelle
   *[other] { $found } Zellen
}, die Tabelle { $expected ->
    [one] eine Spalte
   *[other] { $expected } Spalten
}; erlaubt sind gleich viele, und Dezimalkommas nur, wo zwischen den Zellen keine Kommas stehen
recording-no-number = In der Spalte „{ $column }“ steht „{ $value }“; erlaubt ist eine Zahl mit { $sign ->
    [comma] Dezimalkomma
   *[point] Dezimalpunkt
} und ohne Tausendertrennzeichen
recording-out-of-range = In der Spalte „{ $column }“ steht „{ $value }“; erlaubt ist eine Zahl, dem Betrag nach höchstens { $most }
recording-column-not-found = Als Spalte für { $field } ist „{ $asked }“ angegeben; erlaubt sind { $columns } oder ihre Nummern
recording-column-ambiguous = Als Spalte für { $field } ist „{ $asked }“ angegeben, was auf { $columns } passt; erlaubt ist ein Name, der nur auf eine davon passt, oder ihre Nummer
recording-field-time = die Zeit
recording-field-value = die Werte
recording-run-not-found = Als Durchgang ist „{ $asked }“ angegeben; erlaubt sind { $runs }
recording-no-runs = Als Durchgang ist „{ $asked }“ angegeben, aber in dieser Datei hat keiner einen Namen; erlaubt ist, keinen anzugeben
recording-no-time = Von keiner der Spalten { $columns } ist bekannt, dass sie die Zeiten enthält; eine davon muss dafür angegeben sein, oder eine Abtastrate (--time oder --rate)
    .page = Von keiner der Spalten { $columns } ist bekannt, dass sie die Zeiten enthält; wählen Sie eine davon, oder geben Sie eine Abtastrate an
recording-time-unit = Die Einheit der Spalte „{ $column }“ ist „{ $unit }“; erlaubt sind für eine Zeit { $allowed }
recording-no-value = Von keiner der Spalten { $columns } ist bekannt, dass sie Werte enthält; nötig ist eine mit Zahlen neben den Zeiten, oder eine, die angegeben ist
recording-quantity-unit = Die Einheit der Spalte „{ $column }“ ist „{ $unit }“; erlaubt sind für { $quantity } { $allowed } und ähnliche
recording-quantity-position = eine Auslenkung
recording-quantity-velocity = eine Geschwindigkeit
recording-quantity-acceleration = eine Beschleunigung
recording-rate = Die Abtastrate ist { $value }; erlaubt ist { $allowed }
recording-rate-and-time = --rate und --time („{ $time }“) sind beide angegeben; erlaubt ist eins davon
    .page = Eine Abtastrate und eine Spalte der Zeiten („{ $time }“) sind beide angegeben; erlaubt ist eins davon
recording-value-unit = --unit ist „{ $asked }“; erlaubt sind Einheiten einer Auslenkung (m, cm, mm, rad, °), einer Geschwindigkeit (m/s, rad/s, …) und einer Beschleunigung (m/s², g, …)
    .page = Als Einheit der Werte ist „{ $asked }“ angegeben; erlaubt sind Einheiten einer Auslenkung (m, cm, mm, rad, °), einer Geschwindigkeit (m/s, rad/s, …) und einer Beschleunigung (m/s², g, …)
recording-too-few-rows = Die Aufzeichnung hat { $rows ->
    [one] eine Zeile
   *[other] { $rows } Zeilen
} mit Zeit und Wert zu verschiedenen Zeiten; nötig sind mindestens { $least }
recording-starts-over = Hier folgt die Zeit { $value } auf { $before }, und eine andere Aufzeichnung beginnt; erlaubt ist eine einzige
recording-constant-time = In der Spalte „{ $column }“ steht in jeder Zeile { $value }; erlaubt sind Zeiten, die steigen
recording-constant-value = In der Spalte „{ $column }“ steht in jeder Zeile { $value } (in SI-Einheiten, wenn ihre Einheit bekannt ist); erlaubt sind Werte, die sich ändern

### Was eine Datei statt einer Tabelle ist

found-binary = kein Text
found-picture = ein Bild
found-pdf = ein PDF-Dokument
found-gzip = eine mit gzip gepackte Datei, die erst entpackt werden muss
found-media = ein Ton oder ein Film
found-hdf5 = eine Datei von HDF5 oder MATLAB
found-xml = XML oder HTML, vielleicht ein Projekt von Tracker oder Logger Pro, aus dem sich eine Tabelle exportieren lässt
found-json = JSON
found-prose = Text ohne Zeilen mit Zahlen

### Was an einer Aufzeichnung angenommen, weggelassen und geordnet wurde

recording-note-time = Keine Kopfzeile nennt die Zeit; dafür wird die erste Spalte genommen, deren Zahlen steigen.
recording-note-time-unit = Die Datei nennt keine Einheit der Zeit; angenommen sind Sekunden.
recording-note-time-ignored = Die Spalte „{ $column }“ mit Zeiten wird nicht gelesen, da eine Abtastrate angegeben ist.
recording-note-quantity = Weder Einheit noch Name sagen, was aufgezeichnet wurde; angenommen ist eine Auslenkung.
recording-note-name = Dem Namen nach enthält die Spalte der Werte { $quantity }, der Einheit nach nicht; es gilt die Einheit.
recording-note-cut-off = Die letzte Zeile, { $line }, endet zu früh und ist weggelassen.
recording-note-missing =
    { $count ->
        [one] In einer Zeile fehlt die Zeit oder der Wert; sie ist weggelassen: Zeile { $line }.
       *[other] In { $count } Zeilen fehlt die Zeit oder der Wert; sie sind weggelassen, die erste ist Zeile { $line }.
    }
recording-note-sorted =
    { $count ->
        [one] Die Zeit fällt einmal, in Zeile { $line }; alle Zeilen sind nach der Zeit sortiert.
       *[other] Die Zeit fällt { $count }-mal, zuerst in Zeile { $line }; alle Zeilen sind nach der Zeit sortiert.
    }
recording-note-averaged =
    { $count ->
        [one] Eine Zeile, Zeile { $line }, hat dieselbe Zeit wie eine andere; es gilt das Mittel ihrer Werte.
       *[other] { $count } Zeilen, die erste ist Zeile { $line }, haben dieselbe Zeit wie eine andere; es gilt das Mittel ihrer Werte.
    }
recording-note-gaps =
    { $count ->
        [one] Die Zeiten haben eine Lücke von { $longest } vor Zeile { $line }; üblich sind { $usual }.
       *[other] Die Zeiten haben { $count } Lücken bis { $longest }, die erste vor Zeile { $line }; üblich sind { $usual }.
    }
recording-note-run = Der Durchgang „{ $run }“ ist weggelassen: { $reason }.
recording-note-nameless-run = Ein Durchgang ohne Namen ist weggelassen: { $reason }.

### Aufzeichnungen, an die sich nichts anpassen lässt; vor dem Satz steht die Datei

fit-refused-length = Die Aufzeichnung hat { $times } Zeiten und { $values } Werte; erlaubt sind gleich viele
fit-refused-too-few = Von { $from } bis { $to } hat die Aufzeichnung { $found ->
    [one] einen Wert
   *[other] { $found } Werte
}; nötig sind mindestens { $needed }
fit-refused-time = Zeit Nummer { $number } ist { $value }; erlaubt ist eine endliche Zahl, größer als die Zeit davor
fit-refused-value = Wert Nummer { $number } ist { $value }; erlaubt ist { $allowed }
fit-refused-option = { $name } ist { $value }; erlaubt ist { $allowed }
fit-refused-still = Von { $from } bis { $to } sind alle Werte gleich; erlaubt ist ein Teil, in dem sich die Masse bewegt
fit-refused-no-oscillation = Von { $from } bis { $to } schwingt nichts: Die Werte zeigen nur Rauschen oder einen gleichmäßigen Anstieg; erlaubt ist ein Teil mit wenigstens einigen Halbschwingungen
fit-refused-no-fit = Von { $from } bis { $to } lässt sich keine Bewegung eines Federpendels anpassen; erlaubt ist ein Teil, in dem es frei schwingt

### Warum der angepasste Teil dort beginnt oder endet, wo er es tut

fit-edge-recording = wie die Aufzeichnung
fit-edge-given = wie angegeben
fit-edge-held = davor wurde die Masse gehalten oder lag still
fit-edge-driven = davor bewegte etwas anderes die Masse: Ihre Schwingungen wuchsen
fit-edge-misfit = die Werte davor gehören nicht zu der Bewegung, die folgt
fit-edge-still = danach liegt die Masse still
fit-edge-disturbed = danach bewegt etwas anderes die Masse
fit-edge-unrest = danach klingen die Schwingungen nicht mehr ab: Etwas anderes hält die Masse in Bewegung, etwa der Boden
fit-edge-stopped = danach sind die Schwingungen plötzlich weg: Eine Hand oder Ähnliches hielt sie an
fit-edge-clipped = davor schneidet der Sensor die Schwingungen ab

### Was in einer Aufzeichnung gefunden wurde

fit-law-stokes = Viskose (Stokessche) Reibung
    .inside = viskose (Stokessche) Reibung
fit-law-coulomb = Trockene (Coulombsche) Reibung
    .inside = trockene (Coulombsche) Reibung
fit-law-newton = Quadratische (Newtonsche) Reibung
    .inside = quadratische (Newtonsche) Reibung
fit-acts-none = In dieser Aufzeichnung zeigt sich keine Reibung.
fit-acts-growing = In dieser Aufzeichnung wächst die Amplitude, statt abzunehmen: Etwas führt der Masse Energie zu, und Reibung zeigt sich nicht.
fit-acts-alone = { $law } wirkt: { $value }
fit-open = Die Aufzeichnung lässt offen, welches Gemisch wirkt: { $mixes }.
fit-physically = In physikalischen Größen: { $values }.
fit-regime-strong = Die Dämpfung ist stark: Der Dämpfungsgrad ist { $ratio }.
fit-regime-overdamped = Die Bewegung ist überdämpft (Kriechfall): Der Dämpfungsgrad ist { $ratio }.
fit-regime-critical = Die Dämpfung liegt nahe am aperiodischen Grenzfall: Der Dämpfungsgrad ist { $ratio }.
fit-dominates = { $law } überwiegt: { $value }, { $share } der verlorenen Energie
fit-leads = { $law } wirkt: { $value }, { $share } der verlorenen Energie
fit-acts-too = { $law } wirkt mit: { $value } ({ $surely }{ $share })
fit-asked = Angepasst wie verlangt: { $values }.
fit-asked-none = Angepasst wie verlangt, ohne Reibung.
fit-and = { $one } und { $other }
fit-or = { $one } oder { $other }
fit-not-needed =
    { $number ->
        [one] { $laws } wird zur Beschreibung nicht gebraucht.
       *[other] { $laws } werden zur Beschreibung nicht gebraucht.
    }
fit-cannot-separate = Um { $one } und { $other } zu unterscheiden, ab mindestens { $amplitude } loslassen.
fit-never-separates = Auch größere Amplituden würden { $one } und { $other } nicht unterscheiden.
fit-no-mix = Kein Gemisch beschreibt diese Aufzeichnung
fit-not-this-mix = Dieses Gemisch beschreibt diese Aufzeichnung nicht
fit-not-undamped = Eine ungedämpfte Bewegung beschreibt diese Aufzeichnung nicht
fit-asked-rejected = Dieses Gemisch ist verworfen: Mit weiteren Gesetzen lässt die Anpassung so viel weniger übrig, wie es der Zufall seltener als einmal unter hundert täte. Welche es sind, zeigt die Anpassung ohne Wahl der Gesetze.
fit-wrong-softening = { $said }: Die Periode wächst mit der Amplitude, wie bei einem Pendel mit großen Ausschlägen (eine Feder, die weicher wird).
fit-wrong-hardening = { $said }: Die Periode fällt mit der Amplitude (eine Feder, die härter wird).
fit-wrong-period-drift = { $said }: Die Periode driftet.
fit-wrong-losses = { $said }: Die Amplitude nimmt ab wie bei keinem Gemisch der drei Gesetze.
fit-wrong-losses-asked = { $said }: Ihre Amplitude nimmt anders ab.
fit-wrong-growing = { $said }: Die Amplitude wächst, statt abzunehmen; etwas führt der Masse Energie zu.
fit-wrong-zero-drift = { $said }: Der Nullpunkt des Sensors driftet.
fit-wrong-shape = { $said }: Die Schwingungen haben eine andere Form, wie bei einem Sensor, der nicht linear ist.
fit-wrong-residual = { $said }: Die Anpassung lässt weit mehr übrig als das Rauschen des Sensors.
fit-wrong = { $said }.
fit-rests = Die Masse kommt bei { $time } zur Ruhe.
fit-rests-early = Die Masse kommt bei { $time } zur Ruhe: Eine einzige Halbschwingung davor sagt nur, wie stark die trockene Reibung mindestens ist.
fit-caution-part = Angepasst ist nur der Teil von { $from } bis { $to }: { $why }.
fit-caution-swings = Das stützt sich auf nur { $number } Halbschwingungen: Bei weniger als fünf irrt das Urteil oft.
fit-caution-one-swing = Das stützt sich auf eine einzige Halbschwingung: Bei weniger als fünf irrt das Urteil oft.
fit-caution-values = Mit { $number } Werten je Halbschwingung bleibt viel von der Bewegung ungesehen: schneller aufzeichnen.
fit-clipped = An { $count } Umkehrpunkten enden die Werte bei { $levels }: Dort schneidet der Sensor ab. { $helps }
fit-clipped-left-out = Angepasst ist nur, was folgt, ab { $time }.
fit-clipped-later = Später beginnen, mit { $flag } "{ $time }", oder kleinere Schwingungen messen.
fit-clipped-smaller = Kleinere Schwingungen messen.
fit-caution-outliers =
    { $count ->
        [one] Ein Wert liegt weit ab von den anderen und verzieht die Anpassung: --loss tukey lässt ihn beiseite.
       *[other] { $count } Werte liegen weit ab von den anderen und verziehen die Anpassung: --loss tukey lässt sie beiseite.
    }
    .page = { $count ->
        [one] Ein Wert liegt weit ab von den anderen und verzieht die Anpassung: Das Programm federpendel kann ihn beiseitelassen.
       *[other] { $count } Werte liegen weit ab von den anderen und verziehen die Anpassung: Das Programm federpendel kann sie beiseitelassen.
    }
