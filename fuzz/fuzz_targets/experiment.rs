//! Any bytes as an experiment file: refused in one sentence, or a complete experiment in range.
#![no_main]

use federpendel_cli::{experiment, words};
use federpendel_text::{Catalogue, Language};
use libfuzzer_sys::fuzz_target;

thread_local! {
    static CATALOGUES: [Catalogue; 2] = [Language::English, Language::German].map(Catalogue::new);
}

/// Samples that are said to fit into memory.
const FIT: usize = 1_000_000;

fuzz_target!(|bytes: &[u8]| {
    match experiment::parse(bytes).and_then(|draft| draft.resolve(FIT)) {
        Ok(experiment) => {
            assert!((2..=FIT).contains(&experiment.samples), "{} samples", experiment.samples);
            assert!(experiment.duration.is_none_or(|time| time > 0.0 && time.is_finite()));
            assert!(experiment.oscillator.angular_frequency().is_normal());
        }
        Err(error) => CATALOGUES.with(|catalogues| {
            for catalogue in catalogues {
                let sentence = words::experiment_error(catalogue, &error, Some("my.toml"));
                assert!(sentence.len() > "my.toml: ".len(), "{error:?} is not said");
                assert!(!sentence.contains(char::is_control), "{sentence:?}");
            }
        }),
    }
});
