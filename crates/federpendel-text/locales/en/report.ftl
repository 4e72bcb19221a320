# What every report says around its content.

report-contents = Contents
report-skip = Skip to the content
report-notice = Note.
report-figure = Figure { $number }
report-table = Table { $number }

## A claim; in a worksheet the reader fills in the verdict and the finding

report-claim = Claim
report-computed = Computed
report-expected = Expected
report-undefined = no value
report-reading = The article does not say this in so many words.
report-agrees = Computed and expected agree to rounding.
report-verdict = Verdict
report-verdict-holds = holds
report-verdict-fails = fails
report-verdict-holds-here = holds here only
report-verdict-not-applicable = cannot be told here
report-finding = Finding

## The head of a worksheet

report-name = Name
report-class = Class
report-date = Date
