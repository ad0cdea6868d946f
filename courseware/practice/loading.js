// The data of exercises.

export const unpack = (packed) => {
  const bytes = Uint8Array.from(atob(packed), (sign) => sign.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Response(stream).json();
};

// The numbers of a topic's exercises, a file beside the page that is loaded when they are needed.
const loadedTopics = {};
export const loadTopic = (topic, version) => loadedTopics[topic] ??= new Promise((resolve, reject) => {
  const script = document.createElement("script");
  script.src = `${document.documentElement.dataset.content_root}_static/practice/${topic}.js?${version}`;
  script.onload = () => resolve(unpack(window.coursewarePractice[topic]));
  script.onerror = () => { delete loadedTopics[topic]; reject(new Error(`${script.src} is missing`)); };
  document.head.append(script);
});
