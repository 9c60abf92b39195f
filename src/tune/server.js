"use strict";
// What is asked of inkedge tune.

const $ = id => document.getElementById(id);
const token = new URLSearchParams(location.search).get("token") || "";
const tab = crypto.getRandomValues(new Uint32Array(2)).join("-");
let number = 0;  // counts what this tab asks for

async function fetched(path, options) {
  try {
    const answer = await fetch(path, {...options, headers: {"X-Inkedge-Token": token}});
    $("gone").hidden = true;
    return answer;
  } catch (error) {
    if (error.name !== "AbortError") $("gone").hidden = false;
    throw error;
  }
}

/// The answer to a request with these settings; null: it was given up for a later one.
async function ask(path, settings, more = {}, signal = undefined) {
  const body = JSON.stringify({tab, number: ++number, settings, ...more});
  const answer = await fetched(path, {method: "POST", body, signal});
  if (answer.status === 204) return null;
  if (!answer.ok) throw new Error((await answer.json()).error);
  return answer;
}

setInterval(() => { if (!document.hidden) fetched("/beginning", {method: "HEAD"}).catch(() => {}); }, 4000);
