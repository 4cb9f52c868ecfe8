//! The Markdown of the specification as HTML, with what it names linked.

use pulldown_cmark::{BrokenLink, CodeBlockKind, CowStr, Event, Options, Parser, Tag, TagEnd, TextMergeStream, html};

use super::formula::{is_formula, math};
use super::links::{Links, page_of_document};
use super::sentence::in_sentence;

/// What is set beside plain Markdown.
#[derive(Clone, Copy, Debug)]
pub(super) struct Prose<'a> {
    /// Where the names lead.
    pub(super) links: &'a Links,
    /// Code type may be a formula, as in clauses.
    pub(super) formulas: bool,
    /// Code type is a value: no name of a parameter, an alarm or a profile.
    pub(super) bare: bool,
}

impl Prose<'_> {
    /// A text as HTML: citations, parameters and alarms are links, formulas MathML, tables can be scrolled, headings have
    /// ids made of their words.
    pub(super) fn html(&self, text: &str) -> String {
        let resolve = |link: BrokenLink<'_>| {
            let target = self.links.clause(&link.reference)?;
            Some((CowStr::from(target.to_owned()), CowStr::from("")))
        };
        let parser = Parser::new_with_broken_link_callback(text, Options::ENABLE_TABLES, Some(resolve));
        let mut events = Vec::new();
        let (mut in_link, mut in_code, mut heading) = (false, false, None);
        for event in TextMergeStream::new(parser) {
            match event {
                Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
                    in_link = true;
                    let dest_url = self.address(dest_url);
                    events.push(Event::Start(Tag::Link { link_type, dest_url, title, id }));
                }
                Event::End(TagEnd::Link) => {
                    in_link = false;
                    events.push(Event::End(TagEnd::Link));
                }
                Event::Start(Tag::CodeBlock(kind)) => {
                    in_code = true;
                    let class = match &kind {
                        CodeBlockKind::Fenced(words) if words.contains("run") => " class=\"command\"",
                        _ => "",
                    };
                    events.push(Event::Html(format!("<pre tabindex=\"0\"{class}><code>").into()));
                }
                Event::End(TagEnd::CodeBlock) => {
                    in_code = false;
                    events.push(Event::Html("</code></pre>\n".into()));
                }
                Event::Start(Tag::Table(columns)) => {
                    let wrapper = "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"table\">";
                    events.extend([Event::Html(wrapper.into()), Event::Start(Tag::Table(columns))]);
                }
                Event::End(TagEnd::Table) => {
                    events.extend([Event::End(TagEnd::Table), Event::Html("</div>".into())]);
                }
                Event::Start(Tag::Heading { level, classes, attrs, .. }) => {
                    heading = Some(events.len());
                    events.push(Event::Start(Tag::Heading { level, id: None, classes, attrs }));
                }
                Event::End(TagEnd::Heading(level)) => {
                    if let Some(start) = heading.take() {
                        let words = words(&events[start..]);
                        if let Event::Start(Tag::Heading { id, .. }) = &mut events[start] {
                            *id = Some(slug(&words).into());
                        }
                    }
                    events.push(Event::End(TagEnd::Heading(level)));
                }
                Event::Code(code) if !in_link => {
                    // Behind `name` = stands a value, which may have the name of another parameter.
                    let value = matches!(events.last(), Some(Event::Text(text)) if text.ends_with("= "));
                    let code = if value || self.bare { plain_code(&code) } else { self.code(code) };
                    events.push(code);
                }
                Event::Text(text) if !in_link && !in_code => events.extend(self.linked(&text)),
                other => events.push(other),
            }
        }
        let mut out = String::new();
        html::push_html(&mut out, events.into_iter());
        out
    }

    /// A text of one paragraph, without the paragraph's own tags.
    pub(super) fn inline(&self, text: &str) -> String {
        let html = self.html(text);
        html.trim().trim_start_matches("<p>").trim_end_matches("</p>").to_owned()
    }

    fn code(&self, code: CowStr<'_>) -> Event<'static> {
        if self.formulas && is_formula(&code) {
            return Event::InlineHtml(math(&code).into());
        }
        let shown = format!("<code>{}</code>", escaped(&code));
        let target = self.links.parameter(&code).or(self.links.alarm(&code)).or(self.links.profile(&code));
        Event::InlineHtml(match target {
            Some(target) => format!("<a href=\"{target}\">{shown}</a>").into(),
            None => shown.into(),
        })
    }

    /// A text whose bare ids of clauses, with or without the number of an example, are links.
    fn linked(&self, text: &str) -> Vec<Event<'static>> {
        let (mut events, mut rest) = (Vec::new(), text);
        while let Some(start) = rest.find("TRC-") {
            let name =
                |character: char| character.is_ascii_uppercase() || character.is_ascii_digit() || character == '-';
            let tail = &rest[start..];
            let end = tail.find(|character| !name(character)).unwrap_or(tail.len());
            let digits = tail[end..].strip_prefix('#').map_or(0, |digits| {
                1 + digits.find(|character: char| !character.is_ascii_digit()).unwrap_or(digits.len())
            });
            let shown = &tail[..end + digits];
            self.set(&rest[..start], &mut events);
            events.push(match self.links.clause(shown).or(self.links.clause(&tail[..end])) {
                Some(target) => Event::InlineHtml(format!("<a href=\"{target}\">{shown}</a>").into()),
                None => Event::Text(shown.to_owned().into()),
            });
            rest = &tail[end + digits..];
        }
        self.set(rest, &mut events);
        events
    }

    /// A text with its formulas, where there are some.
    fn set(&self, text: &str, events: &mut Vec<Event<'static>>) {
        if !self.formulas {
            return events.push(Event::Text(text.to_owned().into()));
        }
        for (part, formula) in in_sentence(text) {
            events.push(if formula { Event::InlineHtml(math(&part).into()) } else { Event::Text(part.into()) });
        }
    }

    /// A relative link to a file of `spec` leads to its page.
    fn address<'t>(&self, address: CowStr<'t>) -> CowStr<'t> {
        let (path, anchor) = address.split_once('#').map_or((&*address, None), |(path, anchor)| (path, Some(anchor)));
        match (page_of_document(path), anchor) {
            (Some(page), Some(anchor)) => format!("{page}#{anchor}").into(),
            (Some(page), None) => page.into(),
            (None, _) => address,
        }
    }
}

fn plain_code(code: &str) -> Event<'static> {
    Event::InlineHtml(format!("<code>{}</code>", escaped(code)).into())
}

fn words(events: &[Event<'_>]) -> String {
    let word = |event: &Event<'_>| match event {
        Event::Text(text) | Event::Code(text) => text.to_string(),
        Event::InlineHtml(html) => without_tags(html),
        _ => String::new(),
    };
    events.iter().map(word).collect()
}

/// An id made of words: lower case, hyphens between.
pub(super) fn slug(words: &str) -> String {
    let kept = |character: char| if character.is_alphanumeric() { character } else { ' ' };
    let plain: String = words.to_lowercase().chars().map(kept).collect();
    plain.split_whitespace().collect::<Vec<_>>().join("-")
}

/// The text of HTML that this module or a template made.
pub(super) fn without_tags(html: &str) -> String {
    let (mut text, mut inside) = (String::new(), false);
    for character in html.chars() {
        match character {
            '<' => inside = true,
            '>' if inside => inside = false,
            other if !inside => text.push(other),
            _ => {}
        }
    }
    let text = text.replace("&lt;", "<").replace("&gt;", ">").replace("&quot;", "\"");
    text.replace("&amp;", "&")
}

/// A text for HTML.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn html(text: &str) -> String {
        Prose { links: &Links::new([]), formulas: true, bare: false }.html(text)
    }

    #[test]
    fn what_is_named_is_linked() {
        let text = html("See [TRC-CORNER-08] and `corner-owner`; TRC-DUMMY-01#1 too, with `r·n(u1)`. [TRC-NONE-01]");
        assert!(text.contains("<a href=\"04-corner.html#TRC-CORNER-08\">TRC-CORNER-08</a>"), "{text}");
        assert!(text.contains("<a href=\"parameters.html#corner-owner\"><code>corner-owner</code></a>"), "{text}");
        assert!(text.contains("<a href=\"08-dummy.html#TRC-DUMMY-01-1\">TRC-DUMMY-01#1</a>"), "{text}");
        assert!(html("`offset-zero` = `cancel`").ends_with(" = <code>cancel</code></p>\n"));
        assert!(text.contains("<math>") && text.contains("[TRC-NONE-01]"), "{text}");
    }

    #[test]
    fn headings_have_ids_and_links_to_files_lead_to_pages() {
        assert!(html("## The first report\n").contains("<h2 id=\"the-first-report\">"));
        assert!(html("[p](PARAMETERS.md) [c](clauses/04-corner.md#x)").contains("href=\"parameters.html\""));
        assert!(html("[c](clauses/04-corner.md#TRC-CORNER-01)").contains("href=\"04-corner.html#TRC-CORNER-01\""));
    }
}
