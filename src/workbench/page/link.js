// A link that carries the whole state behind its #: version, then JSON in base64url. Browsers do not send what follows #.

const VERSION = "1";
/** The longest address that is made; browsers differ, and all take this. */
export const MOST_CHARACTERS = 1_000_000;

/** The fragment for a state, without #. */
export function encode(state) {
  const bytes = new TextEncoder().encode(JSON.stringify(state));
  let binary = "";
  for (let at = 0; at < bytes.length; at += 0x8000) binary += String.fromCharCode(...bytes.subarray(at, at + 0x8000));
  return VERSION + btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

/** The state of a fragment; throws what is wrong with it, in words. */
export function decode(fragment) {
  if (!fragment.startsWith(VERSION)) throw new Error("this link is of another version of the workbench");
  try {
    const binary = atob(fragment.slice(VERSION.length).replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = Uint8Array.from(binary, (character) => character.charCodeAt(0));
    const state = JSON.parse(new TextDecoder("utf-8", { fatal: true }).decode(bytes));
    if (typeof state !== "object" || state === null) throw new Error();
    return state;
  } catch {
    throw new Error("this link is damaged: a part of it is missing or was changed");
  }
}
