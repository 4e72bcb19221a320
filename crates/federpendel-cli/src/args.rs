//! The command line: what can be asked, and how it is said.

mod beside;
mod command;
mod fit;
mod generate;
mod missing;
mod plan;
mod refuse;
mod score;
mod serve;

pub use fit::Fit;
pub(crate) use fit::QUANTITIES;
pub(crate) use generate::{completions, man};
pub use plan::Plan;
pub use score::Score;
pub use serve::Serve;

use std::ffi::OsString;
use std::path::PathBuf;

use clap::ArgMatches;
use clap::error::ErrorKind;
use clap_complete::Shell;
use federpendel_text::plot::draw::Background;
use federpendel_text::{Catalogue, Language};

use crate::experiment::Field;
use crate::failure::Failure;
pub use crate::output::{ComparisonPicture, Dialect, FitPicture, Format, MotionPicture};
pub use crate::record::Method;

/// What pictures can be drawn on.
const LIGHT: &str = "light";
const DARK: &str = "dark";

/// What the user asks for.
#[derive(Debug)]
pub enum Request {
    /// Simulate an experiment.
    Simulate(Simulate),
    /// Hold methods beside its exact motion.
    Compare(Compare),
    /// Check the article's claims.
    Article(Article),
    /// Fit recordings.
    Fit(Box<Fit>),
    /// Plan an experiment.
    Plan(Plan),
    /// Hold samples against a reference problem.
    Score(Score),
    /// Show the page.
    Serve(Serve),
    /// Write the completions for a shell.
    Completions(Shell),
    /// Write the manual page.
    Man,
    /// Print a help text or the version.
    Print(String),
}

/// The experiment that a command is about.
#[derive(Debug)]
pub struct Subject {
    /// The experiment file; none for the built-in experiment.
    pub experiment: Option<PathBuf>,
    /// Fields given as flags.
    pub overrides: Vec<(Field, String)>,
}

/// Where results go, and how.
#[derive(Debug, Clone)]
pub struct Results {
    /// Files to write.
    pub outputs: Vec<PathBuf>,
    /// What standard output gets.
    pub format: Option<Format>,
    /// How CSV is written.
    pub dialect: Dialect,
    /// Whether the summary tells everything.
    pub details: bool,
    /// What pictures are drawn on.
    pub background: Background,
}

/// The arguments of `simulate`.
#[derive(Debug)]
pub struct Simulate {
    /// The experiment.
    pub subject: Subject,
    /// The method of computation.
    pub method: Method,
    /// Time step of a numeric scheme, as written.
    pub time_step: Option<String>,
    /// Standard deviation of a sensor's noise, as written; none for the samples as they are.
    pub noise: Option<String>,
    /// What the noise begins with.
    pub seed: Option<u64>,
    /// What pictures show.
    pub picture: MotionPicture,
    /// Where results go.
    pub results: Results,
}

/// The arguments of `compare`.
#[derive(Debug)]
pub struct Compare {
    /// The experiment.
    pub subject: Subject,
    /// Names of methods with commas between them; none for all that apply.
    pub against: Option<String>,
    /// Time step of the methods that take one, as written.
    pub time_step: Option<String>,
    /// Tolerance of the methods that choose their steps, as written.
    pub tolerance: Option<String>,
    /// Width of smooth friction, as written.
    pub width: Option<String>,
    /// What pictures show.
    pub picture: ComparisonPicture,
    /// Where results go.
    pub results: Results,
}

/// The arguments of `article`.
#[derive(Debug)]
pub struct Article {
    /// The experiment.
    pub subject: Subject,
    /// Whether verdicts are left blank for a class, with the solutions in a second file.
    pub worksheet: bool,
    /// Numbers of the claims that a page is to hold, as written; none for all.
    pub claims: Option<String>,
    /// Where results go.
    pub results: Results,
}

/// The language that `--lang` asks for, or else the environment; found before anything else is
/// parsed, since help and refusals already speak it.
pub fn language(arguments: &[OsString], variable: impl Fn(&str) -> Option<String>) -> Language {
    let mut words = arguments.iter().skip(1).filter_map(|word| word.to_str());
    let mut asked = None;
    while let Some(word) = words.next() {
        match word {
            "--" => break,
            "--lang" => asked = words.next().and_then(Language::from_tag).or(asked),
            _ => {
                let tag = word.strip_prefix("--lang=");
                asked = tag.and_then(Language::from_tag).or(asked);
            }
        }
    }
    asked.unwrap_or_else(|| Language::from_environment(variable))
}

/// Reads the arguments, the program's own name first.
///
/// # Errors
/// One sentence that names what is wrong and what is allowed.
pub(crate) fn parse(arguments: &[OsString], catalogue: &Catalogue) -> Result<Request, Failure> {
    let command = command::command(catalogue);
    let arguments = &asked_for_help(arguments);
    if let Some(flag) = missing::value(arguments, &command) {
        let variables = [("argument", flag.into())];
        return Err(Failure::Input(catalogue.format("cli-missing-value", &variables)));
    }
    let matches = command.try_get_matches_from(arguments);
    let matches = match matches {
        Ok(matches) => matches,
        Err(error) => {
            return match error.kind() {
                ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
                    Ok(Request::Print(printed(&error)))
                }
                ErrorKind::MissingSubcommand
                | ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand => {
                    Err(Failure::NoCommand(command::command(catalogue).render_help()))
                }
                _ => Err(Failure::Input(refuse::sentence(&error, arguments, catalogue))),
            };
        }
    };
    Ok(match matches.subcommand() {
        Some(("completions", matches)) => match matches.get_one::<Shell>("shell") {
            Some(shell) => Request::Completions(*shell),
            None => Request::Man,
        },
        Some(("man", _)) => Request::Man,
        Some(("plan", matches)) => Request::Plan(Plan::new(matches)),
        Some(("score", matches)) => Request::Score(Score::new(matches)),
        Some(("serve", matches)) => Request::Serve(Serve::new(matches)),
        Some(("compare", matches)) => Request::Compare(compare(matches)),
        Some(("fit", matches)) => Request::Fit(Box::new(Fit::new(matches))),
        Some(("article", matches)) => Request::Article(article(matches)),
        Some((_, matches)) => Request::Simulate(simulate(matches)),
        None => Request::Print(command::command(catalogue).render_help().to_string()),
    })
}

/// `help simulate` as `simulate --help`, which says the same in clap's own way.
fn asked_for_help(arguments: &[OsString]) -> Vec<OsString> {
    let mut arguments = arguments.to_vec();
    let mut at = 1;
    while let Some(word) = arguments.get(at).and_then(|word| word.to_str()) {
        match word {
            "--lang" => at += 2,
            word if word.starts_with("--lang=") => at += 1,
            "help" => {
                arguments.remove(at);
                arguments.push("--help".into());
                break;
            }
            _ => break,
        }
    }
    arguments
}

/// Help as it suits standard output.
fn printed(error: &clap::Error) -> String {
    if console::colors_enabled() {
        error.render().ansi().to_string()
    } else {
        error.render().to_string()
    }
}

fn text(matches: &ArgMatches, id: &str) -> Option<String> {
    matches.get_one::<String>(id).cloned()
}

fn subject(matches: &ArgMatches) -> Subject {
    let given = |field: &Field| Some((*field, text(matches, &field.flag())?));
    Subject {
        experiment: matches.get_one::<PathBuf>("experiment").cloned(),
        overrides: Field::ALL.iter().filter_map(given).collect(),
    }
}

fn results(matches: &ArgMatches) -> Results {
    // Not every command has every flag.
    let named = |id: &str| {
        let written = matches.try_get_one::<String>(id).ok().flatten();
        written.cloned().unwrap_or_default()
    };
    Results {
        outputs: matches.get_many("output").into_iter().flatten().cloned().collect(),
        format: Format::named(&named("format")),
        dialect: Dialect::named(&named("csv-dialect")).unwrap_or_default(),
        details: matches.get_flag("details"),
        background: if named("theme") == DARK { Background::Dark } else { Background::Light },
    }
}

fn simulate(matches: &ArgMatches) -> Simulate {
    let named = |id: &str| text(matches, id).unwrap_or_default();
    Simulate {
        subject: subject(matches),
        method: Method::named(&named("method")).unwrap_or(Method::Exact),
        time_step: text(matches, "dt"),
        noise: text(matches, "noise"),
        seed: matches.get_one("seed").copied(),
        picture: MotionPicture::named(&named("plot")).unwrap_or_default(),
        results: results(matches),
    }
}

fn compare(matches: &ArgMatches) -> Compare {
    let picture = text(matches, "plot").and_then(|name| ComparisonPicture::named(&name));
    Compare {
        subject: subject(matches),
        against: text(matches, "against"),
        time_step: text(matches, "dt"),
        tolerance: text(matches, "tolerance"),
        width: text(matches, "width"),
        picture: picture.unwrap_or_default(),
        results: results(matches),
    }
}

fn article(matches: &ArgMatches) -> Article {
    Article {
        subject: subject(matches),
        worksheet: matches.get_flag("worksheet"),
        claims: text(matches, "claims"),
        results: results(matches),
    }
}
