use super::*;
use Dimension::*;

fn value(text: &str, dimension: Dimension) -> f64 {
    parse(text, dimension).unwrap_or_else(|error| panic!("{text}: {error}"))
}

#[test]
fn decimal_quantities_are_correctly_rounded() {
    for text in ["100 mm", "10 cm", "0,1 m", "0.1", "1e2mm", "0.0001 km", "100000 µm", "1e5 um"] {
        assert_eq!(value(text, Length), 0.1, "{text}");
    }
    assert_eq!(value("3 in", Length), 0.0762);
    assert_eq!(value("1 lb", Mass), 0.45359237);
    assert_eq!(value("1 lbf/in", Stiffness), 175.1268352464764);
    assert_eq!(value("3,6 km/h", Velocity), 1.0);
    assert_eq!(value("9,81 m/s²", Acceleration), 9.81);
    assert_eq!(value("10 cm^2", Area), 0.001);
    assert_eq!(value("2 %", Number), 0.02);
    assert_eq!(value("1 g/cm³", Density), 1000.0);
    assert_eq!(value("-5cm", Length), -0.05);
    assert_eq!(value("−5 cm", Length), -0.05);
}

#[test]
fn one_unit_has_many_spellings() {
    for text in [
        "3 N·s/m",
        "3 N*s/m",
        "3 N s/m",
        "3 N s m^-1",
        "3 N s m⁻¹",
        "3 Ns/m",
        "3000 mNs/m",
        "3 kg/s",
    ] {
        assert_eq!(value(text, Damping), 3.0, "{text}");
    }
    for text in ["9 m/s^2", "9 m/s2", "9 m/s/s", "9 m s^-2", "9 m/(s·s)", "9 m s-2"] {
        assert_eq!(value(text, Acceleration), 9.0, "{text}");
    }
    assert_eq!(value("0.5 1", Number), 0.5);
}

#[test]
fn thousands_separators_are_refused_with_their_readings() {
    let ambiguous = |decimal: &str, grouped: &str| {
        Err(Error::Ambiguous { decimal: decimal.into(), grouped: grouped.into() })
    };
    for (written, value) in [
        ("1 × 10⁻⁵", 1e-5),
        ("1,23456789 × 10⁸ kg", 1.23456789e8),
        ("−2.5 · 10^-3 g", -2.5e-6),
        ("1×10⁰", 1.0),
    ] {
        assert_eq!(parse(written, Mass), Ok(value), "{written}");
    }
    for written in ["1 × 10", "1 ×", "1 × 10⁻ kg", "1 × 20²"] {
        assert!(parse(written, Mass).is_err(), "{written}");
    }
    assert_eq!(parse("1,000 kg", Mass), ambiguous("1", "1000"));
    assert_eq!(parse("12,500 g", Mass), ambiguous("12.5", "12500"));
    let grouped = |plain: &str| Err(Error::Grouped { plain: plain.into() });
    assert_eq!(parse("1.000,5 kg", Mass), grouped("1000.5"));
    assert_eq!(parse("1,000.5 kg", Mass), grouped("1000.5"));
    assert_eq!(parse("1.000.000 kg", Mass), grouped("1000000"));
    // No group of a number begins with zero, and no number is grouped only once after four digits.
    assert_eq!(value("0,125 kg", Mass), 0.125);
    assert_eq!(value("1234,500 kg", Mass), 1234.5);
    assert_eq!(value("1.500 kg", Mass), 1.5);
}

#[test]
fn units_that_do_not_fit_are_refused() {
    assert_eq!(
        parse("250 m", Mass),
        Err(Error::WrongDimension { unit: "m".into(), found: Some(Length) })
    );
    let unknown = |text, dimension| match parse(text, dimension) {
        Err(Error::UnknownUnit { nearest, .. }) => nearest,
        other => panic!("{text}: {other:?}"),
    };
    assert_eq!(unknown("5 kgg", Mass).as_deref(), Some("kg"));
    assert_eq!(unknown("5 KG", Mass).as_deref(), Some("kg"));
    assert_eq!(unknown("5 n/m", Stiffness).as_deref(), Some("N/m"));
    for (text, dimension, whole, near) in [
        ("12 N/M", Stiffness, "N/M", "N/m"),
        ("12 kg/M^3", Density, "kg/M^3", "kg/m^3"),
        ("12 Nn/mm^2", Mass, "Nn", "N"),
    ] {
        let expected = Error::UnknownUnit { unit: whole.into(), nearest: Some(near.into()) };
        assert_eq!(parse(text, dimension), Err(expected), "{text}");
    }
    assert_eq!(unknown("5 sec", Time).as_deref(), None);
    assert_eq!(unknown("5 furlong", Length), None);
    for text in [
        "12 N/",
        "12 /m",
        "12 N//m",
        "12 N/m·s",
        "12 N^",
        "12 N^99",
        "12 (N/m",
        "12 N)",
        "1 2 N",
        "1 12 N",
        "1 000 N/m",
        "1 1 N/m",
    ] {
        assert!(matches!(parse(text, Stiffness), Err(Error::UnitGrammar { .. })), "{text}");
    }
}

#[test]
fn what_is_no_ordinary_number_is_refused() {
    assert_eq!(parse("", Mass), Err(Error::Empty));
    assert_eq!(parse("kg", Mass), Err(Error::NoNumber));
    assert_eq!(parse(". kg", Mass), Err(Error::NoNumber));
    assert_eq!(parse("1e400 kg", Mass), Err(Error::Overflow));
    assert_eq!(parse("1e-400 kg", Mass), Err(Error::Underflow));
    assert_eq!(parse("1e99999999999999999999", Mass), Err(Error::Overflow));
    assert_eq!(parse("0e99999999999999999999", Mass), Ok(0.0));
    for text in ["nan", "NaN kg", "inf", "-inf kg", "+Infinity"] {
        assert_eq!(parse(text, Mass), Err(Error::NotFinite), "{text}");
    }
    assert_eq!(parse(&"1".repeat(201), Mass), Err(Error::TooLong { length: 201 }));
}

#[test]
fn an_independent_library_agrees() {
    let cases = [
        ("250 g", Mass),
        ("12 N/m", Stiffness),
        ("2.5 lbf/in", Stiffness),
        ("1.5 kN/m", Stiffness),
        ("7 ft", Length),
        ("3 in", Length),
        ("0.3 µm", Length),
        ("20 min", Time),
        ("2 h", Time),
        ("4 km/h", Velocity),
        ("0.2 N·s/m", Damping),
        ("1.2 g/cm^3", Density),
        ("8 mm^2", Area),
        ("0.4 g/cm", MassPerLength),
        ("3 lbf", Force),
        ("17 lb", Mass),
        ("3 mN", Force),
    ];
    for (text, dimension) in cases {
        let peer = runits::Quantity::parse(text).unwrap();
        let expected = peer.to(dimension.units()[0]).unwrap().value();
        let ours = value(text, dimension);
        assert!((ours / expected - 1.0).abs() < 1e-12, "{text}: {ours} {expected}");
    }
}

mod properties {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_shortest_decimal_comes_back_bit_for_bit(x in proptest::num::f64::NORMAL) {
            prop_assert_eq!(parse(&format!("{x:e} kg"), Mass), Ok(x));
            prop_assert_eq!(parse(&format!("{x:e}"), Length), Ok(x));
        }

        #[test]
        fn a_prefix_only_moves_the_decimal_point(digits in 1u64.., exponent in -30i32..30) {
            let metres: f64 = format!("{digits}e{}", exponent - 3).parse().unwrap();
            prop_assert_eq!(parse(&format!("{digits}e{exponent} mm"), Length), Ok(metres));
        }

        #[test]
        fn the_comma_is_a_decimal_sign(whole in 0u32..10_000, fraction in "[0-9]{1,9}") {
            prop_assume!(fraction.len() != 3);
            let point = format!("{whole}.{fraction}");
            let expected: f64 = point.parse().unwrap();
            prop_assume!(expected == 0.0 || expected.is_normal());
            prop_assert_eq!(parse(&point.replace('.', ","), Number), Ok(expected));
        }

        #[test]
        fn no_text_makes_it_panic(text in "\\PC{0,40}") {
            for dimension in Dimension::ALL {
                let _ = parse(&text, *dimension);
            }
        }
    }
}
