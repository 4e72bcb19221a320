use super::*;

const FIT: usize = 1_000_000;

const FULL: &str = r#"
[oscillator]
mass = "500 g"
stiffness = 20
gravity = "9,81 m/s^2"
[friction]
stokes  = { damping = "0.2 kg/s" }
coulomb = { kinetic = 0.02, static = "3 %" }
newton  = { density = "1000 kg/m^3", drag_coefficient = 0.47, area = "10 cm^2" }
[release]
position = "10 cm"
velocity = -0.3
[record]
duration = "20 s"
samples = 2001
"#;

fn resolve(text: &str, flags: &[(Field, &str)]) -> Result<Experiment, Error> {
    let mut draft = parse(text.as_bytes())?;
    draft.override_with(flags.iter().copied())?;
    draft.resolve(FIT)
}

#[test]
fn a_full_file_is_read() {
    let experiment = resolve(FULL, &[]).unwrap();
    let friction = experiment.oscillator.friction();
    assert_eq!(experiment.oscillator.mass(), 0.5);
    assert_eq!(experiment.oscillator.stiffness(), 20.0);
    assert_eq!(friction.stokes.unwrap().damping(), 0.2);
    assert_eq!(friction.coulomb.unwrap().kinetic(), 0.02);
    assert_eq!(friction.coulomb.unwrap().static_coefficient(), 0.03);
    assert!((friction.newton.unwrap().coefficient() - 0.235).abs() < 1e-16);
    assert_eq!(experiment.release.position, 0.1);
    assert_eq!(experiment.release.velocity, -0.3);
    assert_eq!((experiment.duration, experiment.samples), (Some(20.0), 2001));
    let windows = format!("\u{feff}{}", FULL.replace('\n', "\r\n"));
    assert_eq!(resolve(&windows, &[]), Ok(experiment));
}

#[test]
fn the_example_of_the_help_has_every_key() {
    assert!(resolve(EXAMPLE, &[]).is_ok());
    let draft = parse(EXAMPLE.as_bytes()).unwrap();
    for field in Field::ALL {
        let said = draft.get(*field).is_some();
        // The other ways to say the same stand in the sentence above it.
        assert_eq!(
            said,
            ![Field::NormalForce, Field::NewtonCoefficient].contains(field),
            "{field:?}"
        );
    }
}

#[test]
fn defaults_are_those_of_the_core() {
    let experiment = resolve(BUILT_IN, &[]).unwrap();
    assert_eq!(experiment.normal_force, NormalForce::Weight(9.81));
    assert_eq!(experiment.oscillator.friction().coulomb.unwrap().static_coefficient(), 0.02);
    assert_eq!(experiment.release.velocity, 0.0);
    assert_eq!((experiment.duration, experiment.samples), (None, 2001));
}

#[test]
fn an_override_replaces_its_field_and_its_rivals() {
    let flags = [(Field::NormalForce, "3 N"), (Field::NewtonCoefficient, "0.1 kg/m")];
    let experiment = resolve(FULL, &flags).unwrap();
    assert_eq!(experiment.normal_force, NormalForce::Given(3.0));
    assert_eq!(experiment.oscillator.friction().newton.unwrap().coefficient(), 0.1);
    let experiment = resolve(FULL, &[(Field::Position, "-5cm")]).unwrap();
    assert_eq!(experiment.release.position, -0.05);
    let both = [(Field::Gravity, "9.81"), (Field::NormalForce, "3 N")];
    assert!(matches!(resolve(FULL, &both), Err(Error::Both { .. })));
}

#[test]
fn what_does_not_fit_together_is_refused() {
    let error = |from: &str, to: &str| resolve(&FULL.replace(from, to), &[]).unwrap_err();
    assert!(matches!(error("static = \"3 %\"", "static = 0.01"), Error::StaticBelowKinetic { .. }));
    assert!(matches!(error("kinetic = 0.02, ", ""), Error::StaticWithoutKinetic(_)));
    assert!(matches!(error(", area = \"10 cm^2\"", ""), Error::Incomplete { .. }));
    assert!(matches!(error("area =", "coefficient = 1, area ="), Error::Both { .. }));
    assert!(matches!(error("\"9,81 m/s^2\"", "0"), Error::NoNormalForce(_)));
    assert!(matches!(error("stiffness", "normal_force = 3\nstiffness"), Error::Both { .. }));
    assert!(matches!(error("mass = \"500 g\"", ""), Error::Missing(Field::Mass)));
    assert!(matches!(error("2001", "2000000"), Error::TooManySamples { fit: FIT, .. }));
    for samples in ["1", "2.5", "-3", "0"] {
        assert!(matches!(error("2001", samples), Error::Range(_)), "{samples}");
    }
    assert!(matches!(error("500 g", "1e-307 kg"), Error::Core(_)));
    assert!(matches!(error("-0.3", "nan"), Error::Quantity { .. }));
    assert!(matches!(error("-0.3", "1e-400"), Error::Quantity { .. }));
}

#[test]
fn keys_and_types_are_checked_with_their_line() {
    let error = |from: &str, to: &str| resolve(&FULL.replace(from, to), &[]).unwrap_err();
    let Error::UnknownKey { path, line, nearest, .. } = error("mass", "mas") else { panic!() };
    assert_eq!((path.as_str(), line), ("oscillator.mas", 3));
    assert_eq!(nearest.as_deref(), Some("oscillator.mass"));
    let Error::UnknownKey { nearest, .. } = error("[release]", "[relase]") else { panic!() };
    assert_eq!(nearest.as_deref(), Some("release"));
    let Error::UnknownKey { nearest, .. } = error("[record]", "kinetic = 1\n[record]") else {
        panic!()
    };
    assert_eq!(nearest.as_deref(), Some("friction.coulomb.kinetic"));
    for value in ["true", "[1]", "{ a = 1 }", "1979-05-27"] {
        let error = error("\"500 g\"", value);
        assert!(matches!(error, Error::WrongType { line: 3, .. }), "{value}: {error:?}");
    }
    assert!(matches!(error("{ damping = \"0.2 kg/s\" }", "0.2"), Error::WrongType { .. }));
    assert!(matches!(error("{ damping = \"0.2 kg/s\" }", "{}"), Error::WrongType { .. }));
}

#[test]
fn odd_files_are_refused() {
    assert_eq!(parse(b""), Err(Error::EmptyFile));
    assert_eq!(parse(b"# only a comment\n"), Err(Error::EmptyFile));
    assert_eq!(parse(b"[oscillator]\nmass = \"1 kg\xff\""), Err(Error::NotUtf8 { offset: 25 }));
    assert_eq!(parse(&vec![b' '; LARGEST_FILE + 1]), Err(Error::TooLarge));
    let deep = format!("a = {}{}", "[".repeat(100_000), "]".repeat(100_000));
    assert!(matches!(parse(deep.as_bytes()), Err(Error::Syntax { line: 1, .. })));
    let deep = format!("{}{}", "a.".repeat(200_000), "a = 1");
    assert!(parse(deep.as_bytes()).is_err());
    assert!(matches!(parse(b"[a]\n[a]\n"), Err(Error::Syntax { .. })));
}

/// Found by fuzzing: a tab in a line that a message shows.
#[test]
fn messages_are_one_line_without_tabs() {
    use federpendel_text::{Catalogue, Language};
    let catalogue = Catalogue::new(Language::English);
    for file in
        ["oscillator.mass \t 5e-1", "[oscillator]\nmass\t=\t300\tg", "mass = \t\u{201c}3 g\u{201c}"]
    {
        let error = parse(file.as_bytes()).unwrap_err();
        let sentence = crate::words::experiment_error(&catalogue, &error, Some("my.toml"));
        assert!(!sentence.contains(char::is_control), "{sentence:?}");
    }
}

mod properties {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn no_file_makes_it_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
            let _ = parse(&bytes);
        }

        #[test]
        fn no_change_of_a_good_file_makes_it_panic(
            at in 0..FULL.len(), length in 0..20usize, new in "\\PC{0,20}",
        ) {
            let mut text = FULL.to_owned();
            text.replace_range(at..(at + length).min(FULL.len()), &new);
            let _ = resolve(&text, &[]);
        }
    }
}
