# Was jeder Bericht um seinen Inhalt herum sagt.

report-contents = Inhalt
report-skip = Zum Inhalt springen
report-notice = Hinweis.
report-figure = Abbildung { $number }
report-table = Tabelle { $number }

## Eine Behauptung; auf einem Arbeitsblatt trägt man Urteil und Befund selbst ein

report-claim = Behauptung
report-computed = Berechnet
report-expected = Erwartet
report-undefined = kein Wert
report-reading = Im Artikel steht das nicht wörtlich.
report-agrees = Berechnet und erwartet stimmen bis auf Rundung überein.
report-verdict = Urteil
report-verdict-holds = gilt
report-verdict-fails = gilt nicht
report-verdict-holds-here = gilt nur hier
report-verdict-not-applicable = hier nicht entscheidbar
report-finding = Befund

## Der Kopf eines Arbeitsblatts

report-name = Name
report-class = Klasse
report-date = Datum
