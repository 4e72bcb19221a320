//! The picture of a plan.

use federpendel::Mix;
use federpendel_text::plot::draw::{Background, Size, png, svg, terminal};
use federpendel_text::plot::{Plot, Role, SignificanceCurve, SignificanceData};
use federpendel_text::{Catalogue, Language};

const AMPLITUDES: [f64; 3] = [0.01, 0.03, 0.1];

fn curve<'a>(name: &'a str, role: Role, significances: &'a [f64]) -> SignificanceCurve<'a> {
    SignificanceCurve { name, role, amplitudes: &AMPLITUDES, significances }
}

#[test]
fn significance_is_held_against_a_line_and_what_is_far_below_it_is_left_out() {
    for language in Language::ALL {
        let curves = [
            curve("γ", Role::Stokes, &[2.0, 6.0, 60.0]),
            curve("κ", Role::Newton, &[0.0, 0.5, 7.0]),
        ];
        let data = SignificanceData {
            mix: Mix { stokes: true, coulomb: false, newton: true },
            curves: &curves,
            amplitudes: (0.01, 0.1),
            threshold: 5.0,
        };
        let plot = Plot::significance(&Catalogue::new(language), &data);
        let points: Vec<_> = plot.series.iter().map(|series| series.points.len()).collect();
        assert_eq!(points, [3, 2, 2]);
        assert!(plot.series[2].points.iter().all(|point| point.1 == 5.0));
        assert!(plot.description.contains(&plot.title) && plot.description.contains("60"));
        let text = svg(&plot, Size::of(&plot), Background::Light);
        assert!(!text.contains("NaN") && roxmltree::Document::parse(&text).is_ok());
        assert!(png(&plot, Size::of(&plot), Background::Dark, 1.0).is_ok());
        for columns in [60, 80, 120] {
            let text = terminal(&plot, columns, 24, false);
            assert!(text.lines().all(|line| line.chars().count() <= columns), "{text}");
        }
    }
}
