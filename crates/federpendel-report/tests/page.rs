//! The page says what the document says, and refuses what it cannot set. How it looks, a browser tests.

use std::collections::BTreeSet;

use federpendel_report::document::{Row, literal};
use federpendel_report::html::{PageError, page};
use federpendel_report::{Block, Claim, Document, Section, Verdict};
use federpendel_text::{Catalogue, Language};

fn document(blocks: Vec<Block>) -> Document {
    let section =
        Section { id: "only".to_owned(), heading: "Only".to_owned(), blocks, sections: vec![] };
    Document {
        title: "a < b: $x_0$".to_owned(),
        lead: vec![],
        sections: vec![section],
        colophon: String::new(),
    }
}

fn german(blocks: Vec<Block>) -> Result<String, PageError> {
    page(&document(blocks), &Catalogue::new(Language::German))
}

fn paragraph(text: &str) -> Result<String, PageError> {
    german(vec![Block::Paragraph(text.to_owned())])
}

fn claim(verdict: Option<Verdict>, finding: Option<&str>) -> Block {
    Block::Claims(vec![Claim {
        number: 7,
        id: "seven".to_owned(),
        equation: "(68)".to_owned(),
        stated: true,
        claim: "Sieben ist $7$.".to_owned(),
        computed: vec!["6,9 m".to_owned()],
        expected: vec!["7,0 m".to_owned()],
        verdict,
        finding: finding.map(str::to_owned),
    }])
}

#[test]
fn text_is_escaped_and_formulas_are_set() {
    let page = paragraph("<script> & $x < 1$").expect("a page");
    let expected = "<p>&lt;script&gt; &amp; <math><mi>x</mi><mo>&lt;</mo><mn>1</mn></math></p>";
    assert!(page.contains(expected), "{page}");
    assert!(!page.contains('$'));
}

#[test]
fn what_somebody_else_wrote_stays_what_it_is() {
    for written in ["5 $", r"C:\$a$b", "$x_0$"] {
        let text = format!("{} has $x$ in it", literal(written));
        let page = paragraph(&text).expect("a page");
        let expected = format!("<p>{written} has <math><mi>x</mi></math> in it</p>");
        assert!(page.contains(&expected), "{page}");
    }
}

#[test]
fn the_name_of_the_page_has_no_markup() {
    assert!(paragraph("").expect("a page").contains("<title>a &lt; b: x0</title>"));
}

#[test]
fn a_decimal_comma_stands_within_one_number() {
    let page =
        paragraph("$m = 0{,}5$ und $10{,}25\\,\\mathrm{m}$, aber $f(1, 2)$").expect("a page");
    assert!(page.contains("<mn>0,5</mn>") && page.contains("<mn>10,25</mn>"), "{page}");
    assert!(page.contains("<mn>1</mn><mo>,</mo><mn>2</mn>"), "{page}");
}

#[test]
fn a_number_stays_on_the_line_of_its_unit() {
    let page = paragraph("auf 0,5 m genau, 9,2 × 10⁻⁸ m, 7 ± 2 m, (3) und 2 3").expect("a page");
    let expected =
        "auf 0,5\u{a0}m genau, 9,2\u{a0}×\u{a0}10⁻⁸\u{a0}m, 7\u{a0}±\u{a0}2\u{a0}m, (3) und 2 3";
    assert!(page.contains(expected), "{page}");
}

#[test]
fn what_is_no_formula_is_refused() {
    let refused = |result| match result {
        Err(PageError::Formula { tex, .. }) => tex,
        other => panic!("{other:?}"),
    };
    assert_eq!(refused(paragraph("so $\\nothing$")), "\\nothing");
    assert_eq!(refused(paragraph("so $\\frac{1$")), "\\frac{1");
    let formula = Block::Formula { number: None, tex: "x_".to_owned() };
    assert_eq!(refused(german(vec![formula])), "x_");
    assert!(matches!(paragraph("5 $"), Err(PageError::Dollar(text)) if text == "5 $"));
}

#[test]
fn every_verdict_has_a_word_of_its_own_in_either_language() {
    let mut words = BTreeSet::new();
    for language in Language::ALL {
        for verdict in Verdict::ALL {
            let document = document(vec![claim(Some(verdict), Some("So."))]);
            let page = page(&document, &Catalogue::new(language)).expect("a page");
            let (_, mark) = page
                .split_once(&format!("<p class=\"verdict {}\">", verdict.name()))
                .expect("the verdict");
            let word = mark.split_once("</p>").and_then(|(mark, _)| mark.split_once("</span> "));
            words.insert(word.expect("a word after its sign").1.to_owned());
            assert!(!page.contains("<textarea") && !page.contains("checkbox"));
        }
    }
    assert_eq!(words.len(), Language::ALL.len() * Verdict::ALL.len(), "{words:?}");
}

#[test]
fn a_worksheet_leaves_room_to_write() {
    let page = german(vec![claim(None, None)]).expect("a page");
    assert_eq!(page.matches("type=\"checkbox\"").count(), Verdict::ALL.len());
    assert_eq!(page.matches("<textarea").count(), 1);
    assert!(page.contains("<dt>Klasse</dt>"));
}

#[test]
fn figures_are_numbered_through_all_sections() {
    let sketch = |id: &str| Block::Sketch {
        id: id.to_owned(),
        svg: "<svg></svg>".to_owned(),
        caption: String::new(),
    };
    let mut document = document(vec![sketch("one")]);
    let below = Section {
        id: "below".to_owned(),
        blocks: vec![sketch("two")],
        ..document.sections[0].clone()
    };
    document.sections[0].sections.push(below);
    let page = page(&document, &Catalogue::new(Language::German)).expect("a page");
    assert!(page.contains("<h3>Only</h3>"), "{page}");
    assert!(page.contains("<strong>Abbildung 2</strong>"), "{page}");
    assert!(page.contains("<a href=\"#below\">"), "{page}");
}

#[test]
fn a_table_says_what_it_holds_before_it_scrolls_and_long_names_may_break() {
    let row = |name: &str| Row {
        target: Some("only".to_owned()),
        below: "So ist es.".to_owned(),
        ..Row::from(vec![name.to_owned(), "1".to_owned()])
    };
    let rows = [row("01_a_german.csv"), row("a_recording-of/the-third-bench.csv")];
    let table = |count: usize| Block::Table {
        caption: "Alle.".to_owned(),
        head: vec!["Name".to_owned(), "Wert".to_owned()],
        rows: rows.iter().cycle().take(count).cloned().collect(),
    };
    let page = german(vec![table(2), table(20)]).expect("a page");
    let caption = "<p class=\"caption\" id=\"table-1\"><strong>Tabelle 1</strong> Alle.</p>\n<div class=\"wide\"";
    assert!(page.contains(caption), "{page}");
    assert!(page.contains("<table aria-labelledby=\"table-1\">"), "{page}");
    assert!(page.contains("<table aria-labelledby=\"table-2\" class=\"long\">"), "{page}");
    assert!(page.contains(">01_a_german.csv</a>"), "{page}");
    assert!(
        page.contains(">a_<wbr/>recording-<wbr/>of/<wbr/>the-<wbr/>third-<wbr/>bench.csv</a>"),
        "{page}"
    );
    assert!(page.contains("<td colspan=\"2\"><p>So ist es.</p></td>"), "{page}");
}
