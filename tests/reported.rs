//! What is made of a report: pictures, pages, JUnit XML, certificates.

mod browser;
#[path = "reported/campaigns.rs"]
mod campaigns;
#[path = "reported/certificates.rs"]
mod certificates;
#[path = "reported/commands.rs"]
mod commands;
#[path = "reported/pages.rs"]
mod pages;
#[path = "reported/pictures.rs"]
mod pictures;
#[path = "reported/waivers.rs"]
mod waivers;
