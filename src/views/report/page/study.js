// The page of the studies in a folder: its heading, and the order of its parts.

function studyHeading() {
  document.documentElement.classList.add('drawn');
  page.append(element('header', {}, element('h1', {}, data.title),
    element('p', {class: 'soft'}, [stability ? 'a study of stability' : '', tradeoff ? 'a study of accuracy and cost' : '']
      .filter(text => text).join(' and ') + '. Commands are for the folder in which the study was run.')));
}

page.replaceChildren();
studyHeading();
stabilitySection();
tradeoffSection();
page.append(element('footer', {}, 'Made by ' + data.program + '. Colours of plots: Okabe and Ito.'));

let shownWidth = innerWidth;
addEventListener('resize', () => {
  if (innerWidth === shownWidth) return;  // on a phone the height changes while one scrolls
  shownWidth = innerWidth;
  if (stability) showMaps();
  if (tradeoff) showFronts();
});
