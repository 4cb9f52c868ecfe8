//! Lines cut into words: a letter and a number each.

use std::ops::Range;

use rug::Rational;
use winnow::ascii::Caseless;
use winnow::ascii::{digit0, space0};
use winnow::combinator::{alt, not, opt, peek};
use winnow::error::ParserError;
use winnow::prelude::*;
use winnow::stream::LocatingSlice;
use winnow::token::{any, literal, one_of, rest, take_till};

use radcomp_model::number::parse_decimal;

use super::diagnostic::{Kind, LineFault};

/// The most digits that a number may have before its point, and the most after it.
pub const MOST_DIGITS: usize = 9;

/// The letter of a code that is a whole word, which stands in the place of its number.
pub(super) const NAMED: char = '$';

/// The codes that are whole words.
const NAMES: [&str; 2] = ["NORM", "KONT"];

/// A word: a letter and a number; or a code that is a word.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Word<'a> {
    /// The letter, in upper case.
    pub(super) letter: char,
    /// The number, as written.
    pub(super) number: &'a str,
    /// The bytes of the line that the word takes.
    pub(super) span: Range<usize>,
}

/// What stands in a line.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Line<'a> {
    /// `%`: the start or the end of the program.
    Percent,
    /// The words of a block; none in an empty line or a line of comments.
    Words(Vec<Word<'a>>),
}

type Input<'a> = LocatingSlice<&'a str>;

impl ParserError<Input<'_>> for LineFault {
    type Inner = Self;

    fn from_input(input: &Input<'_>) -> Self {
        let start = input.current_token_start();
        let end = start + input.chars().next().map_or(0, char::len_utf8);
        LineFault::new(Kind::UnexpectedCharacter, start..end, "")
    }

    fn into_inner(self) -> Result<Self::Inner, Self> {
        Ok(self)
    }
}

use winnow::stream::Location;

/// Whether the line starts with the slash of block delete.
pub(super) fn is_deletable(line: &str) -> bool {
    line.trim_start_matches([' ', '\t']).starts_with('/')
}

/// Cuts a line into words.
pub(super) fn line(text: &str) -> Result<Line<'_>, LineFault> {
    let mut input = LocatingSlice::new(text);
    space0(&mut input)?;
    if opt('%').parse_next(&mut input)?.is_some() {
        return percent(&mut input);
    }
    opt('/').parse_next(&mut input)?;
    words(&mut input).map(Line::Words)
}

/// The rest of a line that starts with `%`.
fn percent<'a>(input: &mut Input<'a>) -> Result<Line<'a>, LineFault> {
    match words(input)?.first() {
        None => Ok(Line::Percent),
        Some(word) => Err(LineFault::new(Kind::MisplacedWord, word.span.clone(), "a `%` stands alone in its line")),
    }
}

fn words<'a>(input: &mut Input<'a>) -> Result<Vec<Word<'a>>, LineFault> {
    let mut words = Vec::new();
    space0(input)?;
    while let Some(next) = opt(peek(any)).parse_next(input)? {
        match next {
            '(' => comment(input)?,
            ';' => {
                rest.parse_next(input)?;
            }
            letter if letter.is_ascii_alphabetic() => words.push(word(input)?),
            character => return Err(unexpected(character, input.current_token_start())),
        }
        space0(input)?;
    }
    Ok(words)
}

/// A comment in parentheses.
fn comment(input: &mut Input<'_>) -> Result<(), LineFault> {
    let (_, span) = ('(', take_till(0.., ')')).take().with_span().parse_next(input)?;
    match opt(')').parse_next(input)? {
        Some(_) => Ok(()),
        None => Err(LineFault::new(Kind::UnclosedComment, span, "this comment needs a `)` in the same line")),
    }
}

/// A letter and its number.
fn word<'a>(input: &mut Input<'a>) -> Result<Word<'a>, LineFault> {
    if let Some((number, span)) = opt(name.with_span()).parse_next(input)? {
        return Ok(Word { letter: NAMED, number, span });
    }
    let (letter, place) = any.with_span().parse_next(input)?;
    let letter = char::to_ascii_uppercase(&letter);
    space0(input)?;
    let (number, number_span) = number.with_span().parse_next(input)?;
    let span = place.start..number_span.end;
    let (whole, decimals) = number.split_once('.').unwrap_or((number, ""));
    let whole = whole.trim_start_matches(['+', '-']);
    if whole.is_empty() && decimals.is_empty() {
        let next = input.chars().next().filter(|next| "#[<=".contains(*next) && number.is_empty());
        return Err(match next {
            Some(next) => unexpected(next, number_span.end),
            None => LineFault::new(Kind::MissingNumber, span, format!("{letter} needs a number")),
        });
    }
    if whole.len() > MOST_DIGITS || decimals.len() > MOST_DIGITS {
        let limit = format!("a number has at most {MOST_DIGITS} digits before its point and {MOST_DIGITS} after it");
        return Err(LineFault::new(Kind::TooManyDigits, number_span, limit));
    }
    if let Some(exponent) = exponent(input)? {
        let message = "numbers are written without an exponent";
        return Err(LineFault::new(Kind::WrongNumber, number_span.start..exponent.end, message));
    }
    Ok(Word { letter, number, span })
}

/// A code that is a word, with nothing of a longer word behind it.
fn name<'a>(input: &mut Input<'a>) -> Result<&'a str, LineFault> {
    let (name, _) = (
        alt(NAMES.map(|name| literal(Caseless(name)).value(name))),
        not(one_of(|next: char| next.is_ascii_alphanumeric())),
    )
        .parse_next(input)?;
    Ok(name)
}

/// A sign, digits, a point, digits; each of them may be absent.
fn number<'a>(input: &mut Input<'a>) -> Result<&'a str, LineFault> {
    (opt(one_of(['+', '-'])), digit0, opt(('.', digit0))).take().parse_next(input)
}

/// Where an exponent stands, if one follows.
fn exponent(input: &mut Input<'_>) -> Result<Option<Range<usize>>, LineFault> {
    opt((one_of(['e', 'E']), opt(one_of(['+', '-'])), one_of('0'..='9')).span()).parse_next(input)
}

fn unexpected(character: char, start: usize) -> LineFault {
    let span = start..start + character.len_utf8();
    let fault = |message: String| LineFault::new(Kind::UnexpectedCharacter, span.clone(), message);
    match character {
        '#' | '[' | ']' | '<' | '>' | '=' | '*' => fault("variables and expressions are not supported".to_owned())
            .helping("write the number itself, such as X12.5"),
        '%' => fault("a `%` stands alone in its line".to_owned()),
        '/' => fault("the `/` of block delete stands first in its line".to_owned()),
        ')' => fault("no comment is open here".to_owned()),
        '0'..='9' | '.' | '+' | '-' => fault("a number needs a letter before it".to_owned()),
        _ if character.is_control() => fault("a control character".to_owned()),
        _ => fault("a word is a letter from A to Z and a number, such as X12.5".to_owned()),
    }
}

impl Word<'_> {
    /// The number, exactly.
    pub(super) fn value(&self) -> Rational {
        // The lexer passes only a sign, digits and a point, and at least one digit: a decimal.
        parse_decimal(self.number).expect("a lexed number is a decimal")
    }

    /// The number, if it is digits and nothing else; nine digits fit.
    pub(super) fn whole(&self) -> Option<u32> {
        if self.number.bytes().all(|byte| byte.is_ascii_digit()) { self.number.parse().ok() } else { None }
    }

    /// The number of a word that takes whole numbers only.
    pub(super) fn whole_or_fault(&self, what: &str) -> Result<u32, LineFault> {
        let message = || format!("{what} is a whole number without a sign or a point");
        self.whole().ok_or_else(|| LineFault::new(Kind::WrongNumber, self.span.clone(), message()))
    }
}
