//! Any text as a quantity of any dimension: refused, or a finite number that reads back as itself.
#![no_main]

use federpendel_cli::quantity::{self, Dimension};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    for dimension in Dimension::ALL {
        if let Ok(measured) = quantity::parse_uncertain(text, *dimension) {
            assert!(measured.value.is_finite() && measured.uncertainty >= 0.0, "{text:?}");
        }
        let Ok(value) = quantity::parse(text, *dimension) else { continue };
        assert!(value.is_finite(), "{text:?} is read as {value}");
        let written = format!("{value:e}");
        assert_eq!(quantity::parse(&written, *dimension), Ok(value), "{text:?} by way of {written}");
    }
});
