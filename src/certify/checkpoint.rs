//! Checkpoints: what an interrupted campaign goes on from.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use super::course::Begun;
use super::ledger::Ledger;
use super::record::LedgerRecord;

/// The number of this format.
const FORMAT: u64 = 1;
/// The shortest time from one writing to the next.
const PAUSE: Duration = Duration::from_secs(1);
/// Writing may take one part in so many of the time.
const SHARE: u32 = 20;

/// A file that keeps what is done of a campaign. It is replaced as a whole, and its size is bounded as a report's is.
#[derive(Debug)]
pub struct Checkpoint {
    file: PathBuf,
    /// What the campaign is, by name.
    campaign: Vec<(String, String)>,
    begun: Option<State>,
    keeper: Mutex<Keeper>,
}

/// The file.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct State {
    format: u64,
    campaign: Vec<(String, String)>,
    /// Units that are done, counted in the campaign's part.
    units: u64,
    /// The time that they took.
    seconds: f64,
    ledger: LedgerRecord,
}

#[derive(Debug)]
struct Keeper {
    started: Instant,
    due: Instant,
    /// The first writing that failed.
    error: Option<io::Error>,
}

impl Checkpoint {
    /// The checkpoint in a file, which need not be there yet. `campaign` says what the campaign is, by name.
    ///
    /// # Errors
    ///
    /// The file is no checkpoint, or one of another campaign: what differs, in words.
    pub fn open(file: &Path, campaign: Vec<(String, String)>) -> Result<Checkpoint, String> {
        let wrong = |reason: String| format!("{}: {reason}", file.display());
        let begun = match fs::read_to_string(file) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(wrong(format!("cannot be read: {error}"))),
            Ok(text) => {
                let state: State =
                    serde_json::from_str(&text).map_err(|error| wrong(format!("not a checkpoint: {error}")))?;
                if state.format != FORMAT {
                    return Err(wrong(format!("a checkpoint of format {}; this radcomp reads {FORMAT}", state.format)));
                }
                let difference = difference(&state.campaign, &campaign);
                if let Some(difference) = difference {
                    return Err(wrong(format!(
                        "a checkpoint of another campaign: {difference}; delete it, or name another with --checkpoint"
                    )));
                }
                if !(0.0..=1e9).contains(&state.seconds) || state.ledger.clone().ledger().is_none() {
                    return Err(wrong("not a checkpoint of this radcomp".to_owned()));
                }
                Some(state)
            }
        };
        let now = Instant::now();
        let keeper = Mutex::new(Keeper { started: now, due: now + PAUSE, error: None });
        Ok(Checkpoint { file: file.to_owned(), campaign, begun, keeper })
    }

    /// How many programs had been judged before.
    pub fn programs(&self) -> u64 {
        self.begun.as_ref().map_or(0, |state| state.ledger.tally.programs)
    }

    /// Removes the file: the campaign is at its end.
    ///
    /// # Errors
    ///
    /// If a writing failed on the way, or the file cannot be removed.
    pub fn remove(self) -> io::Result<()> {
        let keeper = self.keeper.into_inner().unwrap_or_else(PoisonError::into_inner);
        if let Some(error) = keeper.error {
            return Err(error);
        }
        match fs::remove_file(&self.file) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => Ok(()),
        }
    }

    pub(super) fn begun(&self) -> Begun {
        let Some(state) = self.begun.clone() else { return Begun::default() };
        // Both were looked at when the file was read.
        let (spent, ledger) = (Duration::from_secs_f64(state.seconds), state.ledger.ledger().unwrap_or_default());
        Begun { units: state.units, spent, ledger }
    }

    /// Keeps what is done, if it is time to. A failure is told at the end: it does not spoil the campaign.
    pub(super) fn keep(&self, units: u64, ledger: &Ledger) {
        let mut keeper = self.keeper.lock().unwrap_or_else(PoisonError::into_inner);
        let from = Instant::now();
        if from < keeper.due {
            return;
        }
        let before = self.begun.as_ref().map_or(0.0, |state| state.seconds);
        let state = State {
            format: FORMAT,
            campaign: self.campaign.clone(),
            units,
            seconds: before + keeper.started.elapsed().as_secs_f64(),
            ledger: LedgerRecord::from(ledger),
        };
        if let Err(error) = self.write(&state) {
            keeper.error.get_or_insert(error);
        }
        keeper.due = Instant::now() + PAUSE.max(from.elapsed() * SHARE);
    }

    /// Writes the file beside its place, and moves it there: one that is interrupted leaves the file as it was.
    fn write(&self, state: &State) -> io::Result<()> {
        let mut beside = self.file.clone().into_os_string();
        beside.push(".new");
        let mut out = BufWriter::new(File::create(&beside)?);
        serde_json::to_writer(&mut out, state)?;
        out.flush()?;
        out.get_ref().sync_all()?;
        fs::rename(&beside, &self.file)
    }
}

/// The first name whose text differs, with both.
pub(super) fn difference(was: &[(String, String)], is: &[(String, String)]) -> Option<String> {
    let differs = was.iter().zip(is).find(|(was, is)| was != is);
    let told = differs.map(|((name, was), (_, is))| format!("{name} {was} there, {is} here"));
    told.or_else(|| (was.len() != is.len()).then(|| "it says something else of its campaign".to_owned()))
}
