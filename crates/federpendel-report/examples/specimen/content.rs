//! A document with every kind of block, some of them as long and as wide as they get.

use federpendel_report::{Block, Claim, Document, Row, Section, Verdict};
use federpendel_text::{Catalogue, Language};

use crate::figure;

/// The specimen in the language of `catalogue`; a worksheet leaves blank what the reader is to find.
pub fn document(catalogue: &Catalogue, worksheet: bool) -> federpendel::Result<Document> {
    let say = Speaker(catalogue.language());
    Ok(Document {
        title: say.one_of("Specimen of a report", "Muster eines Berichts"),
        lead: vec![Block::Paragraph(say.one_of(
            "Every kind of block, in the order in which a report may use it. The spring pendulum has $m = 0.5\\,\\mathrm{kg}$ and $C = 20\\,\\mathrm{N/m}$.",
            "Jede Art von Block, in der Reihenfolge, in der ein Bericht sie verwenden kann. Das Federpendel hat $m = 0{,}5\\,\\mathrm{kg}$ und $C = 20\\,\\mathrm{N/m}$.",
        ))],
        sections: vec![texts(&say), figure::section(catalogue, &say)?, claims(&say, worksheet)],
        colophon: say.one_of("Made by a test of the layout.", "Entstanden aus einer Prüfung des Satzes."),
    })
}

/// Chooses the language of a text.
pub struct Speaker(Language);

impl Speaker {
    pub fn one_of(&self, english: &str, german: &str) -> String {
        match self.0 {
            Language::English => english,
            Language::German => german,
        }
        .to_owned()
    }
}

fn texts(say: &Speaker) -> Section {
    Section {
        id: "texts".to_owned(),
        heading: say.one_of("Texts, formulas and tables", "Texte, Formeln und Tabellen"),
        blocks: vec![
            Block::Paragraph(say.one_of(
                "Signs that HTML reads otherwise stay what they are: a < b & \"c\" > 'd'. A measured length of 0.098 m stays text; the ratio $\\frac{x_1}{x_0} = 0.98$ is a formula.",
                "Zeichen, die HTML anders liest, bleiben, was sie sind: a < b & „c“ > 'd'. Eine gemessene Länge von 0,098 m bleibt Text; das Verhältnis $\\frac{x_1}{x_0} = 0{,}98$ ist eine Formel.",
            )),
            Block::Formula {
                number: Some("(3)".to_owned()),
                tex: "m \\ddot x + 2 m \\gamma \\dot x + C x = 0".to_owned(),
            },
            Block::Notice(say.one_of(
                "In the article $F_\\mathrm{R}$ points the other way, which is easily overlooked.",
                "Im Artikel zeigt $F_\\mathrm{R}$ in die andere Richtung, was man leicht übersieht.",
            )),
        ],
        sections: vec![Section {
            id: "wide".to_owned(),
            heading: say.one_of("What is wider than a phone: $\\dot x(t)$", "Was breiter als ein Telefon ist: $\\dot x(t)$"),
            blocks: vec![
                Block::Formula {
                    number: Some("(17)".to_owned()),
                    tex: "x(t) = \\mathrm{e}^{-\\gamma t}\\left(x_0 \\cos\\left(\\sqrt{\\omega_0^2 - \\gamma^2}\\,t\\right) + \\frac{v_0 + \\gamma x_0}{\\sqrt{\\omega_0^2 - \\gamma^2}} \\sin\\left(\\sqrt{\\omega_0^2 - \\gamma^2}\\,t\\right)\\right) \\qquad (\\gamma < \\omega_0)".to_owned(),
                },
                table(say),
                Block::List(vec![
                    say.one_of("The first point.", "Der erste Punkt."),
                    say.one_of("The second, with $T = 2\\pi\\sqrt{m/C}$.", "Der zweite, mit $T = 2\\pi\\sqrt{m/C}$."),
                ]),
            ],
            sections: vec![],
        }],
    }
}

fn table(say: &Speaker) -> Block {
    let row = |n: usize| {
        let position = format!("{:.4}", 0.1 - 0.01 * n as f64);
        let position = say.one_of(&position, &position.replace('.', ","));
        vec![
            say.one_of(&format!("turning point {n}"), &format!("Umkehrpunkt {n}")),
            format!("{position} m"),
            format!("{position} m"),
            format!("{position} J"),
            say.one_of("agrees", "stimmt überein"),
        ]
    };
    Block::Table {
        caption: say.one_of(
            "Turning points $x_n$ and the energy there.",
            "Umkehrpunkte $x_n$ und die Energie dort.",
        ),
        head: vec![
            say.one_of("Place", "Stelle"),
            say.one_of("Closed form", "Geschlossene Form"),
            say.one_of("By steps of time", "In Zeitschritten"),
            say.one_of("Energy", "Energie"),
            say.one_of("Comparison", "Vergleich"),
        ],
        rows: (0..8).map(row).map(Row::from).collect(),
    }
}

fn claims(say: &Speaker, worksheet: bool) -> Section {
    let claim = |(place, verdict): (usize, Verdict)| {
        Claim {
        number: place + 1,
        id: format!("claim-{}", place + 1),
        equation: format!("({})", 64 + place),
        stated: place % 2 == 0,
        claim: say.one_of(
            "The amplitude falls by the same amount $2 x_\\mathrm{R}$ in every half period $T/2$, whatever the mass.",
            "Die Amplitude nimmt in jeder halben Periode $T/2$ um denselben Betrag $2 x_\\mathrm{R}$ ab, gleichgültig wie groß die Masse ist.",
        ),
        computed: vec![
            say.one_of("$x_1 =$ −0.0902 m", "$x_1 =$ −0,0902 m"),
            say.one_of("$x_2 =$ 0.0804 m", "$x_2 =$ 0,0804 m"),
        ],
        expected: vec![
            say.one_of("$x_1 =$ −0.09019 m", "$x_1 =$ −0,09019 m"),
            say.one_of("$x_2 =$ 0.08038 m", "$x_2 =$ 0,08038 m"),
        ],
        verdict: (!worksheet).then_some(verdict),
        finding: (!worksheet).then(|| {
            say.one_of(
                "The loss does not depend on the mass on a horizontal guide only through the weight.",
                "Der Verlust hängt auf waagerechter Führung nur über das Gewicht von der Masse ab.",
            )
        }),
    }
    };
    Section {
        id: "claims".to_owned(),
        heading: say.one_of("Claims", "Behauptungen"),
        blocks: vec![Block::Claims(Verdict::ALL.into_iter().enumerate().map(claim).collect())],
        sections: vec![],
    }
}
