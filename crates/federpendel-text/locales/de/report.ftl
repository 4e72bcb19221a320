# What every report says around its content.
