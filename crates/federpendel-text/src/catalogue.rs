//! The one place from which every sentence comes.

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::memoizer::MemoizerKind;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};
use fluent_syntax::ast::Pattern;

use crate::language::Language;

/// A value put into a sentence: a text, or a number on which a plural may depend.
///
/// Made with `into()` from texts, integers and floats. A measured number should go through
/// [`Catalogue::quantity`] or [`Catalogue::number`] first, which round it.
pub type Value<'a> = FluentValue<'a>;

/// All sentences in one language.
pub struct Catalogue {
    language: Language,
    bundle: FluentBundle<FluentResource>,
    on_page: bool,
}

impl Catalogue {
    /// The catalogue in `language`.
    pub fn new(language: Language) -> Self {
        let mut bundle = FluentBundle::new_concurrent(vec![language.identifier()]);
        // The marks that isolate directions of writing would show as rubbish in terminals and files.
        bundle.set_use_isolating(false);
        if language == Language::German {
            bundle.set_formatter(Some(german_number));
        }
        for source in sources(language) {
            // Whatever is wrong in an embedded file a test has refused; what could be read is kept.
            let (Ok(resource) | Err((resource, _))) = FluentResource::try_new(source.to_owned());
            let added = bundle.add_resource(resource);
            debug_assert!(added.is_ok(), "{added:?}");
        }
        Self { language, bundle, on_page: false }
    }

    /// The catalogue of the page, which has fields where the command line has flags: of a sentence that speaks of them its
    /// attribute `page` is said.
    pub fn of_page(language: Language) -> Self {
        Self { on_page: true, ..Self::new(language) }
    }

    /// The language of this catalogue.
    pub fn language(&self) -> Language {
        self.language
    }

    /// The sentence `id`, or for `id.attribute` that attribute of it. An unknown id is returned as it
    /// is; a test refuses ids in the sources that the catalogue lacks.
    pub fn text(&self, id: &str) -> String {
        self.format(id, &[])
    }

    /// The sentence `id` with its variables filled in.
    pub fn format(&self, id: &str, variables: &[(&str, Value<'_>)]) -> String {
        let found = self.find(id);
        debug_assert!(found.is_some(), "no sentence “{id}” in {:?}", self.language);
        let Some(pattern) = found else {
            return id.to_owned();
        };
        let arguments: FluentArgs =
            variables.iter().map(|(name, value)| (*name, value.clone())).collect();
        let mut errors = Vec::new();
        let text = self.bundle.format_pattern(pattern, Some(&arguments), &mut errors).into_owned();
        debug_assert!(errors.is_empty(), "{id}: {errors:?}");
        text
    }

    /// What was typed, in the quotes of the language.
    pub fn quoted(&self, text: &str) -> String {
        self.format("quoted", &[("text", text.to_owned().into())])
    }

    /// Whether there is a sentence `id`.
    pub fn contains(&self, id: &str) -> bool {
        self.find(id).is_some()
    }

    fn find(&self, id: &str) -> Option<&Pattern<&str>> {
        match id.split_once('.') {
            None => {
                let message = self.bundle.get_message(id)?;
                let own = message.get_attribute("page").filter(|_| self.on_page);
                own.map(|own| own.value()).or(message.value())
            }
            Some((id, name)) => Some(self.bundle.get_message(id)?.get_attribute(name)?.value()),
        }
    }
}

impl std::fmt::Debug for Catalogue {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Catalogue").field("language", &self.language).finish_non_exhaustive()
    }
}

/// These embedded files of a language.
macro_rules! locale {
    ($folder:literal, $($file:literal),+) => {
        &[$(include_str!(concat!("../locales/", $folder, "/", $file, ".ftl"))),+]
    };
}

/// The files of a language that everybody needs, and those that only programs do.
macro_rules! locales {
    ($folder:literal) => {
        (
            locale!($folder, "program", "fit", "page", "physical", "measured", "doubt"),
            #[cfg(feature = "programs")]
            locale!(
                $folder, "article", "check", "sketch", "plan", "command", "report", "asked",
                "pictures"
            ),
            #[cfg(not(feature = "programs"))]
            &[],
        )
    };
}

fn sources(language: Language) -> impl Iterator<Item = &'static str> {
    let (all, more): (&[&str], &[&str]) = match language {
        Language::English => locales!("en"),
        Language::German => locales!("de"),
    };
    all.iter().chain(more).copied()
}

/// Numbers that reach a sentence as numbers, with a decimal comma.
fn german_number<M: MemoizerKind>(value: &FluentValue, _: &M) -> Option<String> {
    match value {
        FluentValue::Number(number) => Some(number.as_string().replace('.', ",")),
        _ => None,
    }
}
